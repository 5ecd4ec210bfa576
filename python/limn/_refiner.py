"""The same mesh at many positions."""

from __future__ import annotations

from typing import Any, Optional

from . import _limn
from ._scheme import Scheme


class Refiner(_limn.RefinerData):
    """A control mesh's topology, worked out once for a scheme and a number of steps.

    ``scheme``: a Scheme or what one is made of; ``faces`` as for ``Scheme.refine``; ``vertices``:
    how many there are, at least one more than the largest corner, which is the default.
    ``evaluate`` is then as fast as refinement gets::

        refiner = limn.Refiner("loop", F, 4)
        for V in frames:
            fine = refiner.evaluate(V)     # (refiner.vertex_count, 3); faces: refiner.faces

    May be used by several threads at once.
    """

    def __init__(
        self, scheme: Any, faces: Any, levels: int, vertices: Optional[int] = None
    ) -> None:
        self._scheme = scheme if isinstance(scheme, Scheme) else Scheme(scheme)
        super().__init__(self._scheme._data, faces, levels, vertices)

    @property
    def scheme(self) -> Scheme:
        """The scheme."""
        return self._scheme

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self._scheme, self.control_faces, self.levels, self.control_count)

    def __repr__(self) -> str:
        return (
            f"<limn.Refiner: {self._scheme.name}, {self.levels} levels, "
            f"{self.control_count} → {self.vertex_count} vertices>"
        )
