"""Meshes that limn makes or reads: tuples of arrays with something to say beside."""

from __future__ import annotations

from typing import Any, Mapping, Optional, Tuple, Union

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[Any]
Faces = Union[npt.NDArray[np.int32], Tuple[npt.NDArray[np.int32], npt.NDArray[np.int32]]]


class Surface(Tuple[Any, ...]):
    """``(V, F)``, then ``N`` where normals and ``K`` where curvatures were asked for.

    ``V`` is (n, 3); ``F`` is (m, k) of int32 where all faces have k corners, else a tuple
    ``(corners, offsets)``: face i has ``corners[offsets[i]:offsets[i + 1]]``.
    """

    normals: Optional[Array]
    """(n, 3) of length 1, zero where the surface has none; None where not asked for."""
    corner_normals: Optional[Array]
    """One for each corner of the faces, where vertices on creases have one on each side (their
    ``normals`` are zero); None where none has."""
    curvatures: Optional[Array]
    """(n, 2): the largest and the smallest principal curvature, NaN where there is none, or None."""
    tags: dict[str, Any]
    """What is sharp, as ``Scheme.refine`` takes it: ``scheme.refine(V, F, 3, **surface.tags)``."""
    missing: dict[str, Any]
    """Where a limit, normal or curvature cannot be had, and why: "missing" of ``limn refine --json``."""
    seconds: float
    """What refinement took, without the limit."""

    @property
    def vertices(self) -> Array:
        """V."""
        vertices: Array = self[0]
        return vertices

    @property
    def faces(self) -> Faces:
        """F."""
        faces: Faces = self[1]
        return faces

    @staticmethod
    def _of(made: Mapping[str, Any]) -> Surface:
        normals, curvatures = made.get("normals"), made.get("curvatures")
        parts = [made["vertices"], made["faces"]]
        parts += [part for part in (normals, curvatures) if part is not None]
        surface = Surface(parts)
        surface.normals = normals
        surface.corner_normals = made.get("corner_normals")
        surface.curvatures = curvatures
        surface.tags = made.get("sharp", {})
        surface.missing = made.get("missing", {})
        surface.seconds = made.get("seconds", 0.0)
        return surface

    def __reduce__(self) -> tuple[Any, ...]:
        return Surface, (tuple(self),), self.__dict__

    def __repr__(self) -> str:
        faces = self.faces
        count = len(faces[1]) - 1 if isinstance(faces, tuple) else len(faces)
        beside = [name for name in ("normals", "curvatures") if getattr(self, name) is not None]
        also = "".join(f", {name}" for name in beside)
        return f"<limn.Surface: {len(self.vertices)} vertices, {count} faces{also}>"
