"""limn, the workbench for subdivision-surface schemes.

    import limn

    loop = limn.Scheme("loop")                  # or a path, or a scheme file's text
    V, F = limn.read_mesh("mesh.obj")
    fine, faces = loop.refine(V, F, 3)          # NumPy arrays
    loop.eigen(7)["components"]                 # what `limn eigen loop --valence 7 --json` prints

Analyses give dicts, those of the command's ``--json``. What is wrong with input is a ``limn.Error``
(``SchemeError``, ``MeshError``) with ``file``, ``line``, ``column`` and ``hint``.
"""

from ._errors import Error, LimnWarning, MeshError, SchemeError
from ._functions import (
    check_certificate,
    check_mesh,
    compare,
    fairness,
    papers,
    read_mesh,
    repair_mesh,
    schemes,
    set_thread_limit,
    spectrum,
    thread_limit,
    tune,
    write_mesh,
)
from ._limn import __version__
from ._pictures import Picture
from ._refiner import Refiner
from ._results import (
    ArtifactMap,
    Certificate,
    CharacteristicMap,
    Comparison,
    Eigen,
    Fairness,
    Regularity,
    Tuning,
)
from ._scheme import Scheme
from ._study import Study, StudyResult, study, study_quantities
from ._surface import Surface

__all__ = [
    "ArtifactMap",
    "Certificate",
    "CharacteristicMap",
    "Comparison",
    "Eigen",
    "Error",
    "Fairness",
    "LimnWarning",
    "MeshError",
    "Picture",
    "Refiner",
    "Regularity",
    "Scheme",
    "SchemeError",
    "Study",
    "StudyResult",
    "Surface",
    "Tuning",
    "__version__",
    "check_certificate",
    "check_mesh",
    "compare",
    "fairness",
    "papers",
    "read_mesh",
    "repair_mesh",
    "schemes",
    "set_thread_limit",
    "spectrum",
    "study",
    "study_quantities",
    "thread_limit",
    "tune",
    "write_mesh",
]
