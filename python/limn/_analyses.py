"""What is computed of a scheme's eigenvalues and of its regular lattice."""

from __future__ import annotations

import operator
from typing import TYPE_CHECKING, Any, Iterable, Optional, Sequence, cast, overload

import numpy as np

from . import _limn
from ._errors import Error
from ._results import ArtifactMap, Certificate, CharacteristicMap, Eigen, Regularity

if TYPE_CHECKING:
    from ._scheme import Scheme

LARGEST_VALENCE = 2000


def valences_of(valences: int | Iterable[int], least: int = 2) -> list[int]:
    """One or many, checked."""
    if isinstance(valences, (str, bytes)):
        raise TypeError(f"valences are whole numbers, not {valences!r}; as 5 or range(3, 13)")
    many = valences if isinstance(valences, Iterable) else [valences]
    checked = []
    for valence in many:
        number = int(valence)
        if number != valence or not least <= number <= LARGEST_VALENCE:
            raise Error(f"valence {valence} is not from {least} to {LARGEST_VALENCE}")
        checked.append(number)
    return checked


def whole_number(name: str, value: Any, least: int, most: int) -> int:
    """A whole number of a range, checked."""
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name} {value!r} is no whole number") from None
    if not least <= number <= most:
        raise Error(f"{name} {value} is not from {least} to {most}")
    return number


def levels_of(levels: Any) -> int:
    """A number of steps, checked."""
    return whole_number("levels", levels, 0, 64)


def seconds_of(seconds: Optional[float]) -> float:
    """0 and None: without end."""
    if seconds is not None and not seconds >= 0:
        raise Error(f"{seconds} is no number of seconds")
    return float(seconds) if seconds else float("inf")


class Analyses:
    """The analyses of a ``Scheme``."""

    _data: _limn.SchemeData

    # Extraordinary vertices.

    @overload
    def eigen(self, valence: int, *, rings: int = 0, vectors: bool = False) -> Eigen: ...
    @overload
    def eigen(
        self, valence: Iterable[int], *, rings: int = 0, vectors: bool = False
    ) -> list[Eigen]: ...

    def eigen(
        self, valence: int | Iterable[int], *, rings: int = 0, vectors: bool = False
    ) -> Eigen | list[Eigen]:
        """Frequency blocks, eigenvalues, labelled components and verdicts at a valence.

        A dict as the entries of ``valences`` of ``limn eigen --json``; for several valences, as
        ``range(3, 13)``, a list of them. ``rings``: how many are analysed; 0: as many as control the
        surface. ``vectors``: also the eigenvectors and the stencils of limit point and tangents.
        """
        rings = whole_number("rings", rings, 0, 6)
        many = valences_of(valence)
        found = [Eigen(one) for one in _limn.eigen(self._data, many, rings, bool(vectors))]
        return found if isinstance(valence, Iterable) else found[0]

    def eigen_formulas(
        self, evaluated: Optional[Iterable[str]] = None, *, rings: int = 0
    ) -> dict[str, Any]:
        """Eigenvalues in closed form, for all valences: ``limn eigen --formulas --json``.

        Parameters stay names but for those ``evaluated``; None: those that were set.
        """
        if evaluated is None:
            evaluated = [a.partition("=")[0] for a in self._data.set_parameters]
        formulas: dict[str, Any] = _limn.eigen_formulas(
            self._data, set(evaluated), whole_number("rings", rings, 0, 6)
        )
        return formulas

    def characteristic_map(self, valence: int, *, steps: int = 4) -> CharacteristicMap:
        """The characteristic map at a valence from 3 on, after so many steps."""
        steps = whole_number("steps", steps, 0, 8)
        (number,) = valences_of([valence], 3)
        found = _limn.characteristic_map(self._data, number, steps)
        return CharacteristicMap(scheme=cast("Scheme", self), steps=steps, **found)

    def certify(
        self,
        valence: int | Iterable[int] = (),
        *,
        all: bool = False,
        curvature: bool = True,
        bits: int = 128,
        seconds: Optional[float] = 600,
    ) -> Certificate:
        """Proves or refutes, in ball arithmetic, that surfaces are C1 at vertices of these valences.

        A dict as ``limn certify --json``. ``all``: also at every valence from 3 on. Without
        ``curvature`` only C1 is looked for. What is left when the ``seconds`` end (None: never) is
        "undecided".
        """
        valences = sorted(set(valences_of(valence, 3)))
        if not valences and not all:
            raise Error("no valence to certify", "give one, or several, or all=True")
        bits = whole_number("bits", bits, 64, 4096)
        return Certificate(
            *_limn.certify(
                self._data, valences, bits, bool(all), bool(curvature), seconds_of(seconds)
            )
        )

    def limit_stencil(self, valence: int, *, boundary: bool = False) -> dict[str, Any]:
        """The limit point and tangents at a vertex as weights of the points round it.

        ``valence``: edges at an interior vertex (dual schemes: corners of a face); with
        ``boundary``, faces at a vertex of the boundary, 1 or more. A dict of ``rings``,
        ``position`` (weights that sum to 1, of the points of a star or fan in the order of
        ``docs/coordinates.md``), ``first_tangent``, ``second_tangent`` (empty where there is no
        tangent plane) and ``has_plane``.
        """
        (number,) = valences_of([valence], 1 if boundary else 2)
        return _limn.limit_stencil(self._data, number, boundary)

    # The regular lattice.

    def regularity(
        self, *, budget: int = 7000, tolerance: float = 4e-3, seconds: Optional[float] = 10
    ) -> Regularity:
        """How smooth surfaces are on the regular lattice, with proof: ``limn regularity --json``.

        ``budget``: so many vertices of a polytope at most; ``tolerance``: the width of the bracket
        of the Hölder exponent below which little more is sought; ``seconds``: how long to look
        (None: without end); what was reached is proved all the same.
        """
        budget = whole_number("budget", budget, 1, 1_000_000)
        if not 1e-6 <= tolerance <= 1:
            raise Error(f"tolerance {tolerance} is not from 1e-6 to 1")
        return Regularity(_limn.regularity(self._data, budget, tolerance, seconds_of(seconds)))

    def regular_part(self) -> dict[str, str]:
        """Whether the regular lattice lets curvature be bounded: "bounded" and "reason"."""
        part: dict[str, str] = _limn.regular_part(self._data)
        return part

    def artifacts(
        self,
        frequency: Sequence[float],
        *,
        steps: Optional[int] = None,
        stages: Optional[int] = None,
    ) -> dict[str, Any]:
        """Signal and artifacts of one wave: ``limn artifacts --frequency --json``.

        ``frequency``: (fx, fy) in cycles per control edge. In the limit, or after so many ``steps``,
        or after one refinement and so many smoothing ``stages``.
        """
        fx, fy = (float(f) for f in frequency)
        if not np.hypot(fx, fy) <= 1000:
            raise Error(f"frequency ({fx}, {fy}) is not within 1000 cycles per control edge")
        if steps is not None and stages is not None:
            raise Error("steps and stages exclude each other")
        kind, count = "limit", 0
        if steps is not None:
            kind, count = "steps", whole_number("steps", steps, 1, 30)
        if stages is not None:
            kind, count = "stages", whole_number("stages", stages, 0, 64)
        found: dict[str, Any] = _limn.artifacts(self._data, (fx, fy), kind, count)
        return found

    def artifact_map(self, size: int | tuple[int, int] = 512) -> ArtifactMap:
        """Signal and artifacts of all waves, in the limit.

        ``size``: so many frequencies along each side of the box round the Nyquist region, or
        (width, height).
        """
        width, height = (size, size) if isinstance(size, int) else size
        found = _limn.artifact_map(self._data, width, height)
        found["artifacts"] = np.stack(found["artifacts"])
        return ArtifactMap(scheme=cast("Scheme", self), **found)

    def sampling_density(self, tolerance: float = 1.0) -> dict[str, Any]:
        """Control edges per wavelength that keep artifacts below ``tolerance`` percent of the signal.

        ``limn artifacts --tolerance --json``: under "sampling", by "total_energy" (all artifacts of
        the limit surface) and "mean_energy", the "worst" and the "best" direction.
        """
        density: dict[str, Any] = _limn.sampling_density(self._data, float(tolerance))
        return density
