"""Functions of several schemes, of meshes and of files."""

from __future__ import annotations

import os
from typing import Any, Iterable, Mapping, Optional, Sequence, Union

import numpy.typing as npt

from . import _limn
from ._analyses import levels_of, seconds_of, valences_of, whole_number
from ._errors import Error, MeshError
from ._results import Certificate, Comparison, Fairness, Tuning
from ._scheme import Scheme
from ._surface import Surface
from ._tags import tags_of

SchemeLike = Union[Scheme, str, "os.PathLike[str]"]
Path = Union[str, "os.PathLike[str]"]


def schemes() -> list[str]:
    """Names of the shipped schemes, sorted. ``Scheme(name).summary()`` says more of each."""
    return _limn.shipped_schemes()


def _scheme(scheme: SchemeLike) -> Scheme:
    return scheme if isinstance(scheme, Scheme) else Scheme(scheme)


def _labelled(
    schemes: SchemeLike | Iterable[SchemeLike] | Mapping[str, SchemeLike]
) -> list[tuple[str, Any]]:
    """Labels that differ: names, with the parameters that were set."""
    if isinstance(schemes, Mapping):
        return [(label, _scheme(scheme)._data) for label, scheme in schemes.items()]
    if isinstance(schemes, (str, os.PathLike, Scheme)):
        schemes = [schemes]
    labelled: list[tuple[str, Any]] = []
    for scheme in map(_scheme, schemes):
        label = " ".join([scheme.name, *scheme._data.set_parameters])
        if label in (known for known, _ in labelled):
            raise Error(f"scheme '{label}' is given twice", "name them: {'a': …, 'b': …}")
        labelled.append((label, scheme._data))
    return labelled


def compare(
    *schemes: SchemeLike,
    mesh: Optional[Sequence[Any]] = None,
    valence: Sequence[int] = range(3, 13),
    tolerance: float = 1.0,
    seconds: Optional[float] = 10,
    budget: int = 7000,
    levels: int = 4,
) -> Comparison:
    """Schemes side by side: a dict as ``limn compare --json``, whose ``str`` is the table.

    ``mesh``: (V, F), over which limit surfaces after ``levels`` steps are compared, too;
    ``valence``: a range of valences; ``tolerance``: percent of the signal, for sampling densities;
    ``seconds`` and ``budget``: of the search for each scheme's regularity.
    """
    labelled = _labelled(schemes)
    if len(labelled) < 2:
        raise Error("one scheme alone cannot be compared", "name two or more")
    valences = valences_of(valence)
    if mesh is not None and (len(mesh) < 2 or mesh[0] is None):
        raise MeshError("mesh is not (V, F)")
    vertices, faces = (mesh[0], mesh[1]) if mesh is not None else (None, None)
    return Comparison(
        *_limn.compare(
            labelled,
            vertices,
            faces,
            min(valences),
            max(valences),
            tolerance,
            seconds_of(seconds),
            budget,
            levels_of(levels),
        )
    )


def fairness(
    vertices: npt.ArrayLike,
    faces: Any,
    schemes: SchemeLike | Iterable[SchemeLike] | Mapping[str, SchemeLike],
    *,
    levels: int = 0,
) -> Fairness:
    """Energies of the limit surfaces of one control mesh: a dict as ``limn fairness --json``.

    ``schemes``: one, several, or a dict that names them. Measured after 1 … ``levels`` steps; 0: as
    many as make up to 200000 vertices. Lengths are those of ``vertices``.
    """
    levels = levels_of(levels)
    labelled = _labelled(schemes)
    if not labelled:
        raise Error("there is no scheme")
    return Fairness(_limn.fairness(labelled, vertices, faces, levels))


def spectrum(vertices: npt.ArrayLike, faces: Any, count: int = 10) -> dict[str, list[float]]:
    """The lowest and highest natural frequencies of a mesh: "smallest" and "largest", rising."""
    count = whole_number("count", count, 1, 1000)
    ends: dict[str, list[float]] = _limn.spectrum(vertices, faces, count)
    return ends


def tune(
    scheme: SchemeLike,
    free: str | Sequence[str],
    require: str | Sequence[str],
    *args: Any,
    **options: Any,
) -> Tuning:
    """``Scheme.tune`` of a scheme or what one is made of."""
    return _scheme(scheme).tune(free, require, *args, **options)


def papers(folder: Path, *names: str) -> str:
    """Makes papers anew as pages, figures and tables, all of them if none is named: ``limn papers``.

    Gives the path of the page to begin with. Of one paper the folder is its own; of several each has
    one in it. Takes some seconds to minutes a paper.
    """
    path = os.fspath(folder)
    known = _limn.paper_names()
    if unknown := [name for name in names if name not in known]:
        raise Error(f"there is no paper '{unknown[0]}'", f"the papers are {', '.join(known)}")
    if len(names) == 1:
        _limn.write_paper(names[0], path)
    else:
        chosen = names or tuple(known)
        for name in chosen:
            _limn.write_paper(name, os.path.join(path, name))
        _limn.write_paper_list(path, chosen)
    return os.path.join(path, "index.html")


def check_certificate(certificate: Certificate | Path) -> dict[str, Any]:
    """Verifies a certificate, or the file of one, without a search; gives its answers.

    Raises Error with the first claim that is not shown.
    """
    if isinstance(certificate, Certificate):
        text, file = certificate.text, ""
    else:
        file = os.fspath(certificate)
        try:
            with open(file, encoding="utf-8") as opened:
                text = opened.read()
        except OSError as fault:
            raise Error(f"cannot read the file: {fault.strerror}", file=os.fsdecode(file)) from None
    answers: dict[str, Any] = _limn.check_certificate(text, file)
    return answers


def read_mesh(path: Path, *, tags: Optional[Path] = None) -> Surface:
    """``V, F = limn.read_mesh("mesh.obj")``: OBJ, OFF, PLY, STL, GLB, glTF.

    ``.tags`` has what the file says is sharp, and then what a file of ``tags`` (.toml) says, by the
    mesh file's numbers or names of faces. What of the file is left out is a LimnWarning.
    """
    made = _limn.read_mesh(os.fsencode(path), b"" if tags is None else os.fsencode(tags))
    return Surface._of(dict(zip(("vertices", "faces", "sharp"), made)))


def write_mesh(
    path: Path,
    vertices: npt.ArrayLike,
    faces: Any,
    *,
    normals: Optional[npt.ArrayLike] = None,
    creases: Any = None,
    crease_sharpness: Any = None,
    corners: Any = None,
    corner_sharpness: Any = None,
    holes: Any = None,
    boundary: Optional[str] = None,
    crease_method: Optional[str] = None,
    triangles: Optional[str] = None,
) -> None:
    """Writes .obj, .off, .ply, .stl or .glb, whole or not at all: ``write_mesh(path, V, F)``.

    Arrays, and what is sharp, as for ``Scheme.refine``; ``normals`` (n, 3) of length 1. What the
    format cannot hold of sharpness is left out, with a LimnWarning; .obj holds all of it.
    """
    tags = tags_of(locals())
    _limn.write_mesh(os.fsencode(path), vertices, faces, normals, tags)


def check_mesh(mesh: Path | npt.ArrayLike, faces: Any = None) -> dict[str, Any]:
    """What a mesh is, and every fault of it: ``limn check --json``. Of a file, or of (V, F).

    ``["refinable"]`` says whether limn refines it.
    """
    found: dict[str, Any]
    if faces is None:
        if not isinstance(mesh, (str, os.PathLike)):
            raise Error("check_mesh takes a path, or vertices and faces")
        found = _limn.check_mesh_file(os.fsencode(mesh))
    else:
        found = _limn.check_mesh(mesh, faces)
    return found


def repair_mesh(
    vertices: npt.ArrayLike,
    faces: Any,
    *,
    weld: bool | float | None = None,
    drop: bool = False,
    cut: bool = False,
    orient: bool = False,
    triangulate: bool = False,
) -> Surface:
    """A mesh mended; with nothing asked for, all but ``triangulate`` is done, as by ``--repair``.

    ``weld``: join vertices within so much of the diagonal (True: 1e-6; 0: in one place); ``drop``
    degenerate and repeated faces; ``cut`` where faces are more than one sheet; ``orient`` them
    alike; ``triangulate``: cut polygons into triangles. ``.missing["done"]`` lists what was done.
    ``.tags`` holds sharp what was cut, as ``limn refine --repair`` does, so that the sheets stay
    together: ``scheme.refine(*mended, 3, **mended.tags)``.
    """
    if not (weld is not None and weld is not False or drop or cut or orient or triangulate):
        weld, drop, cut, orient = 0.0, True, True, True
    distance = 1e-6 if weld is True else None if weld is False or weld is None else float(weld)
    if distance is not None and not 0 <= distance <= 1:
        raise Error(f"weld {weld} is not from 0 to 1")
    made = _limn.repair_mesh(vertices, faces, distance, drop, cut, orient, triangulate)
    names = ("vertices", "faces", "sharp")
    return Surface._of({**dict(zip(names, made)), "missing": {"done": made[3]}})


def set_thread_limit(threads: int) -> None:
    """At most so many threads for every call that begins later; 0: as many as the machine has.

    Results are the same bits whatever the number is.
    """
    _limn.set_thread_limit(whole_number("threads", threads, 0, 4096))


def thread_limit() -> int:
    """The limit that was set last; 0: none."""
    return _limn.thread_limit()
