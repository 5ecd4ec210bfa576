"""Schemes: what they are, meshes refined by them, weights chosen."""

from __future__ import annotations

import os
from decimal import Decimal
from fractions import Fraction
from typing import Any, Iterable, Mapping, Optional, Sequence, Union

import numpy.typing as npt

from . import _limn
from ._analyses import Analyses, levels_of, seconds_of, valences_of
from ._errors import Error, SchemeError
from ._pictures import Picture, table
from ._results import Tuning
from ._surface import Array, Surface
from ._tags import TAGS, tags_of

Number = Union[int, float, Fraction, str]
EXACT = (int, Fraction, Decimal)


def _assignment(name: str, value: Number) -> str:
    if isinstance(value, str):
        return f"{name}={value}"
    try:
        # numpy's numbers of other precisions are no fractions, but floats
        exact = Fraction(value) if isinstance(value, EXACT) else Fraction(float(value))
    except (ValueError, OverflowError, TypeError):
        raise SchemeError(f"parameter {name}: {value!r} is no number") from None
    return f"{name}={exact.numerator}/{exact.denominator}"


def _range_text(between: Any) -> str:
    """(low, high) as ``limn tune --between`` takes it."""
    try:
        low, high = between
    except (TypeError, ValueError):
        raise Error(
            f"{between!r} is not (low, high)", "of several names, between= is a list of such pairs"
        ) from None
    return ",".join(_assignment("", bound).lstrip("=") for bound in (low, high))


def _degrees(crease_angle: Optional[float]) -> float:
    """Below 0: none."""
    if crease_angle is None:
        return -1.0
    if not 0 <= crease_angle <= 180:
        raise Error(f"crease_angle {crease_angle} is not from 0 to 180 degrees")
    return float(crease_angle)


class Scheme(Analyses):
    """A subdivision scheme.

    ``source`` is a shipped name (``limn.schemes()``), the path of a scheme file, or, as it has a
    line feed, the text of one. ``parameters`` sets parameters to numbers or expressions:
    ``{"a": "1/16"}``; floats are taken as the fractions that they are. Raises SchemeError with
    file, line and column. Two schemes are equal if their texts and parameters are.
    """

    def __init__(
        self,
        source: str | os.PathLike[str],
        parameters: Optional[Mapping[str, Number]] = None,
    ) -> None:
        if parameters is not None and not isinstance(parameters, Mapping):
            raise TypeError(f'parameters {parameters!r} are no dict, as {{"a": "1/16"}}')
        assignments = [_assignment(name, value) for name, value in (parameters or {}).items()]
        self._data = _limn.SchemeData(os.fsencode(source), assignments)

    def with_parameters(self, **parameters: Number) -> Scheme:
        """The scheme with these parameters set; others stay as they are."""
        copy = Scheme.__new__(Scheme)
        copy._data = self._data.with_parameters(
            [_assignment(name, value) for name, value in parameters.items()]
        )
        return copy

    # What it is.

    @property
    def name(self) -> str:
        """As the file states it, else the file's own."""
        return self._data.name

    @property
    def title(self) -> str:
        """One line."""
        return self._data.title

    @property
    def split(self) -> str:
        """How a step changes connectivity: "triangle-dyadic", …"""
        return self._data.split

    @property
    def source(self) -> str:
        """The literature that it is from."""
        return self._data.source

    @property
    def notes(self) -> str:
        """What a user should know."""
        return self._data.notes

    @property
    def file(self) -> str:
        """Its path; "NAME.toml" of a shipped one, "text" of a text."""
        return self._data.file

    @property
    def text(self) -> str:
        """The scheme file's content, TOML."""
        return self._data.text

    @property
    def parameters(self) -> dict[str, str]:
        """Expressions by name, as ``parameters=`` takes them."""
        return self._data.parameters

    def show(self, stencils: bool = False) -> dict[str, Any]:
        """Rules, mask, factors, formulas, source: ``limn show --json``, weights as exact strings.

        With ``stencils``, also where each weight lies round the new vertex.
        """
        shown: dict[str, Any] = self._data.show(stencils)
        return shown

    def summary(self) -> dict[str, Any]:
        """Name, title, split and parameters: an entry of ``limn schemes --json``."""
        summary: dict[str, Any] = self._data.summary()
        return summary

    def describe(self) -> str:
        """All of ``show`` in words: ``limn show``."""
        return self._data.describe()

    def latex(self) -> str:
        """Mask, factors, limit stencil and artifact formulas in LaTeX; needs amsmath."""
        return self._data.latex()

    def picture(self) -> Picture:
        """The stencil of every case of every rule."""
        return Picture(
            lambda format: _limn.draw_stencils(self._data, format), f"stencils of {self.name}"
        )

    # Refinement.

    def refine(
        self,
        vertices: npt.ArrayLike,
        faces: Any,
        levels: int = 1,
        *,
        limit: bool = False,
        normals: bool = False,
        curvatures: bool = False,
        engine: str = "quick",
        creases: Any = None,
        crease_sharpness: Any = None,
        corners: Any = None,
        corner_sharpness: Any = None,
        holes: Any = None,
        crease_angle: Optional[float] = None,
        boundary: Optional[str] = None,
        crease_method: Optional[str] = None,
        triangles: Optional[str] = None,
    ) -> Surface:
        """The mesh after so many steps: ``V, F = scheme.refine(V, F, 3)``.

        ``vertices``: (n, 3), in any unit of length; float32 and float64 that are contiguous are read
        where they are, and float32 gives float32. ``faces``: (m, k) integers from 0, a tuple
        ``(corners, offsets)``, or a list of lists. The arrays given back own the memory that they
        were made in.

        ``limit`` moves the vertices to the limit surface, ``normals`` adds its unit normals (n, 3),
        ``curvatures`` its principal curvatures (n, 2), in 1/length, largest first. What cannot be
        had at some vertices is zero or NaN, with a LimnWarning and in ``.missing``.

        ``engine``: "quick", or "plain" (step by step; the same surface, in another order).

        Sharpness, with every scheme that has boundary rules: ``creases`` (e, 2) ends of edges with
        ``crease_sharpness`` (one number or one for each; steps that they stay sharp, 10 and more,
        as without it, for ever); ``corners`` (c) vertices and ``corner_sharpness`` alike; ``holes``
        (h) faces that are left out; ``crease_angle`` in degrees between normals; ``boundary``
        "none", "edgeOnly" or "edgeAndCorner"; ``crease_method`` "uniform" or "chaikin".
        ``triangles`` "catmullClark" or "smooth": amid other faces they are refined more evenly,
        where the scheme has a rule for that (else SchemeError).

        Raises MeshError for a mesh that is no surface, Error where the scheme cannot refine it.
        Other Python threads run meanwhile; Ctrl-C ends it.
        """
        if engine not in ("quick", "plain"):
            raise Error(f"engine {engine!r} is neither 'quick' nor 'plain'")
        tags = tags_of(locals())
        made = _limn.refine(
            self._data,
            vertices,
            faces,
            levels_of(levels),
            limit,
            normals,
            curvatures,
            engine == "plain",
            tags,
            _degrees(crease_angle),
        )
        return Surface._of(made)

    def limit_points(self, vertices: npt.ArrayLike, faces: Any) -> tuple[Array, Array]:
        """(P, N): where the vertices of a mesh are on the limit surface, and its unit normals.

        Arrays as for ``refine``. A vertex without a limit stays where it is, with a LimnWarning.
        """
        return _limn.limit_points(self._data, vertices, faces)

    def draw(
        self,
        vertices: npt.ArrayLike,
        faces: Any,
        levels: int = 4,
        *,
        kind: str = "shaded",
        lights: int = 32,
        azimuth: float = -50.0,
        elevation: float = 30.0,
        net: bool = False,
        marks: bool = False,
        crease_angle: Optional[float] = None,
        **tags: Any,
    ) -> Picture:
        """A picture of the limit surface: ``limn draw``. Needs a limn with cairo and Embree.

        ``kind``: "shaded", "stripes" (a mirror of ``lights`` parallel lights) or "lines"
        (reflection lines as curves); ``azimuth`` and ``elevation`` of the viewer in degrees;
        ``net``: the control net, too; ``marks``: sharp edges and vertices, the sharper the darker.
        What is sharp (``crease_angle`` and ``tags``) is stated as for ``refine``.
        """
        if kind not in ("shaded", "stripes", "lines"):
            raise Error(f"kind {kind!r} is none of 'shaded', 'stripes' and 'lines'")
        if not 1 <= lights <= 10000:
            raise Error(f"lights {lights} is not from 1 to 10000")

        for name in tags.keys() - set(TAGS):
            raise TypeError(f"draw() got an unexpected keyword argument '{name}'")
        degrees = _degrees(crease_angle)

        steps = levels_of(levels)

        def drawn(format: str) -> bytes:
            return _limn.draw_surface(
                self._data,
                vertices,
                faces,
                steps,
                kind,
                lights,
                azimuth,
                elevation,
                net,
                marks,
                tags,
                degrees,
                format,
            )

        return Picture(drawn, f"surface of {self.name}", vector=False)

    # Chosen weights.

    def tune(
        self,
        free: str | Sequence[str],
        require: str | Sequence[str],
        valence: int | Iterable[int] = range(3, 13),
        *,
        between: Optional[tuple[Number, Number] | Sequence[tuple[Number, Number]]] = None,
        everywhere: bool = False,
        seconds: Optional[float] = 10,
    ) -> Tuning:
        """The values of parameters or lets at which eigencomponents are as required.

        A dict as ``limn tune --json``. ``require``: an equation in position, tangent, cup, saddle,
        n and the scheme's names, as ``"cup = tangent^2"``; or what holds in a range: an inequality,
        ``"c1"``, ``"convergent"``, ``"bounded-curvature"``. ``between``: look there alone;
        ``everywhere``: the value is that of the regular neighbours, too. Of an equation,
        ``.scheme()`` is the scheme with the solutions.

        Lists of names and of requirements are solved together: as many equations as names or fewer,
        by Newton's method; the other requirements are asked of each solution. ``between`` is then a
        range for each name.
        """
        if not isinstance(free, str) or not isinstance(require, str):
            return self._tune_system(free, require, valence, between, everywhere, seconds)
        return Tuning(
            _limn.tune(
                self._data,
                free,
                require,
                valences_of(valence, 3),
                "" if between is None else _range_text(between),
                everywhere,
                seconds_of(seconds),
                self._base(),
            )
        )

    def _tune_system(
        self,
        free: str | Sequence[str],
        require: str | Sequence[str],
        valence: int | Iterable[int],
        between: Any,
        everywhere: bool,
        seconds: Optional[float],
    ) -> Tuning:
        return Tuning(
            _limn.tune_system(
                self._data,
                [free] if isinstance(free, str) else list(free),
                [require] if isinstance(require, str) else list(require),
                valences_of(valence, 3),
                [] if between is None else [_range_text(one) for one in between],
                everywhere,
                seconds_of(seconds),
                self._base(),
            )
        )

    def tunable(self) -> list[str]:
        """The parameters and lets that ``tune`` can solve for."""
        return _limn.freeable_names(self._data)

    def prescribe(self, valence: int, eigenvalues: str | Sequence[Number]) -> Scheme:
        """A scheme with chosen eigenvalues at one valence: the cup's, then those of frequency 1, 2, …

        A list of numbers and expressions, or a text with commas, as the command takes it.
        For schemes on triangles, shipped or of a file, whose edges look no further than the first
        ring.
        """
        many = eigenvalues.split(",") if isinstance(eigenvalues, str) else eigenvalues
        words = [_assignment("", value).lstrip("=") for value in many]
        (number,) = valences_of([valence], 3)
        base = self._base()
        if not base:
            raise SchemeError(f"no text can extend {self.name}", "write it to a file first")
        return Scheme(self._data.prescribe(base, number, words))

    def _base(self) -> str:
        """What a text says after ``extends`` to mean this scheme; empty where it cannot."""
        if self.name in _limn.shipped_schemes() and self.text == Scheme(self.name).text:
            return self.name
        return os.path.abspath(self.file) if os.path.isfile(self.file) else ""

    # Python.

    def _identity(self) -> tuple[Any, ...]:
        texts, assignments, _ = self._data.__getstate__()
        return tuple(text for _, text in texts), tuple(assignments)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Scheme) and self._identity() == other._identity()

    def __hash__(self) -> int:
        return hash(self._identity())

    def __repr__(self) -> str:
        parameters = "".join(f" {name}={value}" for name, value in self.parameters.items())
        return f"<limn.Scheme {self.name}{parameters}: {self.split}>"

    def __str__(self) -> str:
        return self.describe()

    def _repr_html_(self) -> str:
        shown = self.show()
        rows = [("split", self.split), ("source", self.source)]
        rows += [(f"parameter {name}", value) for name, value in self.parameters.items()]
        parts = [table(("", self.name), rows)]
        if shown.get("mask"):
            parts.append(table(("twice the offset", "coefficient of the regular mask"), [
                (tuple(term["twice_offset"]), term["value"]) for term in shown["mask"]
            ]))
        if _limn.figures_available():
            try:
                parts.insert(1, self.picture().bytes("svg").decode().partition("?>")[2])
            except Error:
                pass  # given by a mask without rules to draw
        return "\n".join(parts)
