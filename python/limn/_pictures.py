"""Pictures and tables for notebooks."""

from __future__ import annotations

import html
import os
from typing import Any, Callable, Iterable, Sequence


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

    def __repr__(self) -> str:
        return f"<limn.Picture: {self._what}>"

    def _repr_svg_(self) -> str | None:
        return self.bytes("svg").decode() if self._vector else None

    def _repr_png_(self) -> bytes_ | None:
        return None if self._vector else self.bytes("png")


bytes_ = bytes


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
