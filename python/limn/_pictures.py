"""Pictures and tables for notebooks."""

from __future__ import annotations

import html
import os
from typing import Any, Callable, Iterable, Sequence

from ._errors import Error


class Picture:
    """A drawing: shown in a notebook, or written to a file by ``save``.

    Made by methods as ``Scheme.picture``; nothing is drawn before it is asked for.
    """

    def __init__(self, draw: Callable[[str], bytes], what: str, vector: bool = True) -> None:
        self._draw = draw
        self._what = what
        self._vector = vector

    def bytes(self, format: str = "svg") -> bytes:
        """The file's bytes; ``format`` is ``"svg"``, ``"png"`` or ``"pdf"``."""
        return self._draw(format)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes a .svg, .png or .pdf file."""
        name = os.fspath(path)
        content = self.bytes(os.path.splitext(name)[1].lstrip(".").lower())
        with open(name, "wb") as file:
            file.write(content)

    def __reduce__(self) -> tuple[Any, ...]:
        # What draws need not be something that pickle takes, so the drawings go with it.
        files = {format: self.bytes(format) for format in ("svg", "png", "pdf")}
        return (Drawn, (files, self._what, self._vector))

    def __repr__(self) -> str:
        return f"<limn.Picture: {self._what}>"

    def _repr_svg_(self) -> str | None:
        return self.bytes("svg").decode() if self._vector else None

    def _repr_png_(self) -> bytes_ | None:
        return None if self._vector else self.bytes("png")


bytes_ = bytes


class Drawn(Picture):
    """A picture that was unpickled: its files as they were drawn."""

    def __init__(self, files: dict[str, bytes], what: str, vector: bool) -> None:
        super().__init__(self._file, what, vector)
        self._files = files

    def _file(self, format: str) -> bytes_:
        if format not in self._files:
            raise Error(f"there is no format {format!r}: a picture is svg, png or pdf")
        return self._files[format]


def table(heading: Sequence[str], rows: Iterable[Sequence[Any]], caption: str = "") -> str:
    """A table in HTML; numbers to six digits."""

    def cell(value: Any) -> str:
        if value is None:
            return "–"
        if isinstance(value, float):
            return f"{value:.6g}"
        return html.escape(str(value))

    lines = ["<table>"]
    if caption:
        lines.append(f"<caption>{html.escape(caption)}</caption>")
    lines.append("<tr>" + "".join(f"<th>{html.escape(name)}</th>" for name in heading) + "</tr>")
    for row in rows:
        lines.append("<tr>" + "".join(f"<td>{cell(value)}</td>" for value in row) + "</tr>")
    lines.append("</table>")
    return "\n".join(lines)
