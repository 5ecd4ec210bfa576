"""The same mesh at many positions."""

from __future__ import annotations

from typing import Any, Optional

from . import _limn
from ._analyses import levels_of
from ._scheme import Scheme
from ._tags import tags_of


class Refiner(_limn.RefinerData):
    """A control mesh's topology, worked out once for a scheme and a number of steps.

    ``scheme``: a Scheme or what one is made of; ``faces`` as for ``Scheme.refine``; ``vertices``:
    how many there are, at least one more than the largest corner, which is the default.
    ``evaluate`` is then as fast as refinement gets::

        refiner = limn.Refiner("loop", F, 4)
        for V in frames:
            fine = refiner.evaluate(V)     # (refiner.vertex_count, 3); faces: refiner.faces

    What is sharp is stated as for ``Scheme.refine``, whose numbers these are. Which edges turn by
    more than an angle depends on positions; ``scheme.refine(V, F, 0, crease_angle=60).tags`` says
    which do. Raises Error where only the plain engine takes such sharpness (docs/sharpness.md).

    May be used by several threads at once.
    """

    def __init__(
        self,
        scheme: Any,
        faces: Any,
        levels: int,
        vertices: Optional[int] = None,
        *,
        creases: Any = None,
        crease_sharpness: Any = None,
        corners: Any = None,
        corner_sharpness: Any = None,
        holes: Any = None,
        boundary: Optional[str] = None,
        crease_method: Optional[str] = None,
        triangles: Optional[str] = None,
    ) -> None:
        self._scheme = scheme if isinstance(scheme, Scheme) else Scheme(scheme)
        tags = tags_of(locals())
        super().__init__(self._scheme._data, faces, levels_of(levels), vertices, tags)

    @property
    def scheme(self) -> Scheme:
        """The scheme."""
        return self._scheme

    def __reduce__(self) -> tuple[Any, ...]:
        parts = (self._scheme, self.control_faces, self.levels, self.control_count)
        return _refiner_of, (type(self), parts, self.control_tags)

    def __repr__(self) -> str:
        return (
            f"<limn.Refiner: {self._scheme.name}, {self.levels} levels, "
            f"{self.control_count} → {self.vertex_count} vertices>"
        )


def _refiner_of(kind: type[Refiner], parts: tuple[Any, ...], tags: dict[str, Any]) -> Refiner:
    return kind(*parts, **tags)
