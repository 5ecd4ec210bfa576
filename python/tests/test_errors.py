"""What is refused, and with which words."""

import pickle

import numpy as np
import pytest

import limn
from conftest import tetrahedron

WRONG = """split = "triangle-dyadic"
vertex = { self = "1", ring = "1/8" }
edge = { end = "3/8", wing = "1/8" }
"""


def test_a_text_with_a_fault():
    with pytest.raises(limn.SchemeError) as caught:
        limn.Scheme(WRONG)
    error = caught.value
    assert (error.file, error.line) == ("text", 2) and error.column > 0
    assert str(error).startswith(f"text:2:{error.column}: {error.message}")


def test_a_file_with_a_fault(tmp_path):
    path = tmp_path / "wrong.toml"
    path.write_text(WRONG)
    with pytest.raises(limn.Error) as caught:
        limn.Scheme(path)
    assert caught.value.file == str(path) and str(caught.value).startswith(f"{path}:2:")


def test_an_unknown_name():
    with pytest.raises(limn.SchemeError, match="loop") as caught:
        limn.Scheme("lopp")
    assert caught.value.line == 0 and caught.value.hint


def test_the_command_says_the_same(tmp_path):
    import os
    import subprocess

    path = tmp_path / "wrong.toml"
    path.write_text(WRONG)
    words = [os.environ["LIMN_COMMAND"], "show", str(path)]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    with pytest.raises(limn.SchemeError) as caught:
        limn.Scheme(path)
    assert done.returncode == 2
    assert done.stderr.splitlines() == ["limn: " + line for line in str(caught.value).splitlines()]


def test_a_mesh_file_with_a_fault(tmp_path):
    path = tmp_path / "wrong.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv nan 1 0\nf 1 2 3\n")
    with pytest.raises(limn.MeshError) as caught:
        limn.read_mesh(path)
    assert (caught.value.file, caught.value.line) == (str(path), 3)
    with pytest.raises(limn.MeshError):
        limn.read_mesh(tmp_path / "missing.obj")
    with pytest.raises(limn.MeshError):
        limn.write_mesh(tmp_path / "mesh.what", *tetrahedron())
    V, F = tetrahedron()
    with pytest.raises(limn.MeshError):
        limn.write_mesh(tmp_path / "mesh.obj", V[:3], F)


def test_errors_are_values_too():
    error = limn.SchemeError("what", "remedy", "file.toml", 3, 7)
    assert isinstance(error, limn.Error) and isinstance(error, ValueError)
    copy = pickle.loads(pickle.dumps(error))
    assert type(copy) is limn.SchemeError and str(copy) == str(error) == "file.toml:3:7: what (remedy)"
    assert (copy.hint, copy.line, copy.column) == ("remedy", 3, 7)


def test_no_parameter():
    for parameters in ({"w": 1}, {"b": "1/"}, {"b": float("nan")}, {"b": None}, {"b": 1e300}):
        with pytest.raises(limn.SchemeError):
            limn.Scheme("laplacian-butterfly", parameters=parameters)


def test_what_is_out_of_range():
    loop = limn.Scheme("loop")
    for call in (
        lambda: loop.eigen(1),
        lambda: loop.eigen(10**9),
        lambda: loop.eigen(5.5),
        lambda: loop.eigen(5, rings=99),
        lambda: loop.certify(),
        lambda: loop.certify(2),
        lambda: loop.certify(3, bits=1),
        lambda: loop.regularity(budget=0),
        lambda: loop.regularity(tolerance=float("nan")),
        lambda: loop.regularity(seconds=-1),
        lambda: loop.artifacts((float("nan"), 0)),
        lambda: loop.artifacts((1e9, 0)),
        lambda: loop.artifacts((0.1, 0), steps=0),
        lambda: loop.artifacts((0.1, 0), steps=1, stages=1),
        lambda: loop.sampling_density(0),
        lambda: loop.sampling_density(float("nan")),
        lambda: loop.artifact_map(0),
        lambda: loop.artifact_map(10**6),
        lambda: loop.characteristic_map(2),
        lambda: loop.characteristic_map(5, steps=99),
        lambda: loop.limit_stencil(0, boundary=True),
        lambda: loop.limit_stencil(1),
        lambda: loop.tune("nothing", "c1"),
        lambda: loop.tune("lambda", "cup ="),
        lambda: loop.prescribe(7, []),
        lambda: loop.prescribe(7, ["1/4"]),
        lambda: limn.compare("loop"),
        lambda: limn.compare("loop", "loop"),
        lambda: limn.fairness(*tetrahedron(), []),
        lambda: limn.fairness(*tetrahedron(), "loop", levels=-1),
        lambda: limn.spectrum(*tetrahedron(), 0),
        lambda: limn.check_mesh(tetrahedron()[0]),
    ):
        with pytest.raises(limn.Error):
            call()


def test_what_is_no_argument():
    with pytest.raises(TypeError):
        limn.Scheme(3)
    with pytest.raises(TypeError):
        limn.Scheme("loop").refine(*tetrahedron(), "three")


def test_what_a_scheme_cannot_do():
    V, F = tetrahedron()
    with pytest.raises(limn.Error, match="triangle"):
        limn.Scheme("loop").refine(V, [[0, 1, 2, 3]], 1)
    with pytest.raises(limn.Error):
        limn.Scheme("doo-sabin").refine(V, F, 1, corners=[0])


def test_text_of_any_bytes():
    for text in ("\n", "\0\n", "name = 'é'\n", "split = 1\n" * 1000, "[" * 100_000 + "\n"):
        with pytest.raises(limn.SchemeError):
            limn.Scheme(text)


def test_certificates_of_any_text(tmp_path):
    path = tmp_path / "certificate.json"
    for text in ("", "{}", "[" * 1000, "null", '{"scheme": 1}'):
        path.write_text(text)
        with pytest.raises(limn.Error):
            limn.check_certificate(path)


def test_a_certificate_that_is_not_there(tmp_path):
    with pytest.raises(limn.Error, match="cannot read"):
        limn.check_certificate(tmp_path / "none.json")


def test_arguments_of_another_type_are_named():
    loop = limn.Scheme("loop")
    for name, call in (
        ("rings", lambda: loop.eigen(5, rings=2.5)),
        ("rings", lambda: loop.eigen_formulas(rings="1")),
        ("steps", lambda: loop.artifacts((0.2, 0.1), steps=1.5)),
        ("stages", lambda: loop.artifacts((0.2, 0.1), stages="2")),
        ("steps", lambda: loop.characteristic_map(5, steps=None)),
        ("bits", lambda: loop.certify(5, bits=128.5)),
        ("budget", lambda: loop.regularity(budget="many")),
        ("count", lambda: limn.spectrum(*tetrahedron(), 2.5)),
        ("threads", lambda: limn.set_thread_limit(1.5)),
        ("valences", lambda: loop.eigen("3")),
        ("parameters", lambda: limn.Scheme("loop-type", parameters="b=1/8")),
    ):
        with pytest.raises(TypeError, match=name) as raised:
            call()
        assert "_limn" not in str(raised.value)


def test_eigenvalues_as_one_text():
    loop = limn.Scheme("loop")
    text = loop.prescribe(7, "1/4,1/2,1/4,1/8")
    assert text == loop.prescribe(7, ["1/4", "1/2", "1/4", "1/8"])
    with pytest.raises(limn.SchemeError):
        loop.prescribe(5, "111")


def test_a_refiner_that_was_never_made():
    class Careless(limn.Refiner):
        def __init__(self):
            self.faces

    with pytest.raises(TypeError, match="__init__"):
        Careless()
    refiner = limn.Refiner.__new__(limn.Refiner)
    for name in ("tags", "faces", "vertex_count", "bytes"):
        with pytest.raises(TypeError, match="__init__"):
            getattr(refiner, name)
    with pytest.raises(TypeError, match="__init__"):
        refiner.evaluate(np.zeros((4, 3)))


def test_what_no_repair_mends():
    V = np.eye(3)
    with pytest.raises(limn.MeshError, match="corner 2 of face 0 is vertex 9"):
        limn.repair_mesh(V, [[0, 1, 9]])
    V[1, 1] = np.nan
    with pytest.raises(limn.MeshError, match="vertex 1 is not finite"):
        limn.repair_mesh(V, [[0, 1, 2]])


def test_file_names_of_any_bytes(tmp_path):
    (tmp_path / "a\udcff.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    name = next(tmp_path.iterdir())
    assert limn.read_mesh(name).faces.tolist() == [[0, 1, 2]]
    limn.write_mesh(tmp_path / "b\udcff.obj", *limn.read_mesh(name)[:2])
    with pytest.raises(limn.MeshError, match="cannot read"):
        limn.read_mesh(tmp_path / "c\udcff.obj")


def test_numbers_of_any_precision():
    wanted = limn.Scheme("laplacian-butterfly", {"b": "1/8"}).eigen(5)
    for value in (np.float32(0.125), np.float64(0.125), np.float16(0.125)):
        assert limn.Scheme("laplacian-butterfly", {"b": value}).eigen(5) == wanted


def test_values_that_are_not_real():
    refiner = limn.Refiner("loop", [[0, 1, 2]], 1)
    with pytest.raises(limn.MeshError, match="complex"):
        refiner.evaluate(np.eye(3) + 1j)


def test_thread_limits_out_of_range():
    for threads in (-1, 10**9):
        with pytest.raises(limn.Error, match="4096"):
            limn.set_thread_limit(threads)


@pytest.mark.parametrize("levels", [-1, 65, 2**31, 2**70, 1.0, "2", None])
def test_levels_that_are_none(levels):
    V, F = tetrahedron()
    for call in (
        lambda: limn.Scheme("loop").refine(V, F, levels),
        lambda: limn.Scheme("loop").draw(V, F, levels),
        lambda: limn.Refiner("loop", F, levels),
        lambda: limn.fairness(V, F, "loop", levels=levels),
    ):
        wrong = limn.Error if isinstance(levels, int) else TypeError
        with pytest.raises(wrong, match="levels"):
            call()
