"""What analyses give: dicts as the command's ``--json`` prints them, that a notebook shows."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Dict, Union

import numpy as np
import numpy.typing as npt

from . import _limn
from ._pictures import Picture, table

if TYPE_CHECKING:
    from ._scheme import Scheme

Array = npt.NDArray[np.float64]
Faces = Union[npt.NDArray[np.int32], "tuple[npt.NDArray[np.int32], npt.NDArray[np.int32]]"]


class Eigen(Dict[str, Any]):
    """Eigencomponents at one valence: an entry of ``valences`` of ``limn eigen --json``."""

    def _repr_html_(self) -> str:
        rows = []
        for block in self["blocks"]:
            for value in block["eigenvalues"]:
                real, imaginary = value["value"]
                number = f"{real:.6g}" + (f" {imaginary:+.6g}i" if imaginary else "")
                rows.append((block["frequency"], number, value["ring"], value["jordan"]))
        caption = f"valence {self['valence']}: " + ", ".join(
            f"{name} {value:.6g}" for name, value in self["components"].items() if value is not None
        )
        return table(("frequency", "eigenvalue", "ring", "Jordan block"), rows, caption)


class Regularity(Dict[str, Any]):
    """Smoothness on the regular lattice: ``limn regularity --json``."""

    def _repr_html_(self) -> str:
        holder = self["holder"]
        rows = [(name, self[name]) for name in ("c0", "c1", "c2")]
        rows += [("Hölder exponent from", holder["lower"]), ("to", holder["upper"])]
        rows += [("attained", holder["attained"]), ("sum rules", self["sum_rules"])]
        return table(("", self["scheme"]), rows)


class Certificate(Dict[str, Any]):
    """Answers of ``certify``, as ``limn certify --json`` has them, and what proves them.

    Truth is asked of ``["valences"][i]["c1"]``: ``"proved"``, ``"refuted"`` or ``"undecided"``.
    """

    def __init__(self, answers: dict[str, Any], text: str, report: str, latex: str) -> None:
        super().__init__(answers)
        self.text = text
        """The certificate: JSON that ``limn.check_certificate`` and ``limn certify --check`` verify."""
        self.report = report
        """The answers in words."""
        self.latex = latex
        """The proof in LaTeX; needs amsmath."""

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the certificate to a file."""
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.text)

    def certificate(self) -> Any:
        """The certificate's JSON as Python objects."""
        return json.loads(self.text)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (dict(self), self.text, self.report, self.latex)

    def _repr_html_(self) -> str:
        rows = [
            (claim["valence"], claim["c1"], claim["curvature"], claim["reason"])
            for claim in self["valences"]
        ]
        return table(("valence", "C1", "curvature", "reason"), rows, self["scheme"])


class _Told(Dict[str, Any]):
    """A dict as ``--json`` of a command, with the lines that the command prints."""

    def __init__(self, values: dict[str, Any], text: str) -> None:
        super().__init__(values)
        self.text = text
        """The command's lines."""

    def __str__(self) -> str:
        return self.text

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (dict(self), self.text)

    def _repr_pretty_(self, printer: Any, cycle: bool) -> None:
        printer.text(self.text)


class Comparison(_Told):
    """Schemes side by side: ``limn compare --json``. ``str`` of it is the table, in which the best of
    each line is marked."""


class Fairness(Dict[str, Any]):
    """Energies of limit surfaces: ``limn fairness --json``."""

    def _repr_html_(self) -> str:
        names = ("scheme", "area", "laplacian_energy", "thin_plate", "curvature_variation")
        return table(names, [[scheme[name] for name in names] for scheme in self["schemes"]])


class Tuning(Dict[str, Any]):
    """Values of a parameter: ``limn tune --json``; with ``"text"``, a scheme file that has them."""

    def scheme(self) -> Scheme:
        """The scheme with the solutions; raises SchemeError where there is no file of them."""
        from ._errors import SchemeError
        from ._scheme import Scheme

        if "text" not in self:
            raise SchemeError(self.get("no_text", "there is no text of a range, nor of a scheme without a file"))
        return Scheme(self["text"])

    def _repr_html_(self) -> str:
        if not isinstance(self["free"], str):
            return self._system_html()
        rows = []
        for entry in self["valences"]:
            for found in entry.get("solutions", ()):
                rows.append((entry["valence"], found["value"], found["exact"], found["holds"]))
            for part in entry.get("parts", ()):
                rows.append((entry["valence"], part["low"]["value"], part["high"]["value"], ""))
        return table(("valence", self["free"], "exactly, or up to", "holds"), rows, self["require"])

    def _system_html(self) -> str:
        rows = []
        for entry in self["valences"]:
            for found in entry["solutions"]:
                numbers = [found["exact"][name] or found["values"][name] for name in self["free"]]
                rows.append((entry["valence"], *numbers, found["holds"]))
        return table(("valence", *self["free"], "holds"), rows, ", ".join(self["require"]))


@dataclass(frozen=True)
class ArtifactMap:
    """Signal and artifacts of all waves, in the limit, over the box round the Nyquist region."""

    scheme: Scheme
    fx: Array
    """(width,) frequencies along x, in cycles per control edge."""
    fy: Array
    """(height,) frequencies along y."""
    signal: Array
    """(height, width): what of the wave's amplitude stays at its frequency, signed."""
    artifacts: Array
    """(count, height, width): of the artifacts Y1, Y2, …, signed, relative to the wave."""
    percent_of_signal: Array
    """(height, width): mean energy of the artifacts in percent of the signal; inf where that is 0."""
    nyquist_region: list[tuple[float, float]]
    """Its corners, counterclockwise."""

    @property
    def extent(self) -> tuple[float, float, float, float]:
        """(left, right, bottom, top), as ``matplotlib.imshow(…, origin="lower")`` takes it."""
        dx, dy = (axis[1] - axis[0] if len(axis) > 1 else 0.0 for axis in (self.fx, self.fy))
        return (
            float(self.fx[0] - dx / 2),
            float(self.fx[-1] + dx / 2),
            float(self.fy[0] - dy / 2),
            float(self.fy[-1] + dy / 2),
        )

    def __repr__(self) -> str:
        size = f"{len(self.fx)} × {len(self.fy)}"
        return f"<limn.ArtifactMap of {self.scheme.name}: {size} frequencies>"

    def picture(self) -> Picture:
        """The page that ``limn artifacts --map`` draws."""
        return Picture(
            lambda format: _limn.draw_artifacts(self.scheme._data, format),
            f"artifacts of {self.scheme.name}",
        )

    def _repr_png_(self) -> bytes:
        return self.picture().bytes("png")


@dataclass(frozen=True)
class CharacteristicMap:
    """The characteristic map at a valence, sampled. Its points lie in the plane z = 0."""

    scheme: Scheme
    valence: int
    eigenvalue: float
    """The tangent's."""
    regular: str
    """By samples, which prove nothing: "yes", "no" or "undecided"."""
    reason: str
    turned_over: bool
    """Whether the second coordinate was negated to keep the orientation."""
    smallest_area: float
    """Of a face over the mean, each over the square of its distance; negative where it folds."""
    net: tuple[Array, Faces]
    """(V, F) of the control net."""
    image: tuple[Array, Faces]
    """(V, F) of the faces round the vertex, sampled."""
    steps: int

    def __repr__(self) -> str:
        return f"<limn.CharacteristicMap of {self.scheme.name} at valence {self.valence}>"

    def picture(self) -> Picture:
        """The picture that ``limn eigen --map`` draws."""
        return Picture(
            lambda format: _limn.draw_maps(self.scheme._data, [self.valence], self.steps, format),
            f"characteristic map of {self.scheme.name}",
        )

    def _repr_svg_(self) -> str:
        return self.picture().bytes("svg").decode()
