"""Numbers are the command's, for every shipped scheme: equal, not near."""

import json

import numpy as np
import pytest

import limn
from conftest import ONE_LATTICE, QUADS, SHIPPED, TRIANGLES, mesh_of


@pytest.mark.parametrize("name", ONE_LATTICE)
def test_eigen(command, name):
    scheme = limn.Scheme(name)
    words = ("eigen", name, "--valence", "3..12")
    if command.agrees(lambda: scheme.eigen(range(3, 13)), *words, pick=lambda all: all["valences"]):
        printed = command(*words)
        assert scheme.eigen(7) == printed["valences"][4]
        assert scheme.regular_part() == printed["regular_part"]


@pytest.mark.parametrize("name", ONE_LATTICE)
def test_regularity(command, name):
    command.agrees(
        lambda: limn.Scheme(name).regularity(budget=200, seconds=None),
        *("regularity", name, "--budget", 200, "--time", 0),
    )


@pytest.mark.parametrize("name", ONE_LATTICE)
def test_artifacts(command, name):
    scheme = limn.Scheme(name)
    words = ("artifacts", name, "--frequency", "0.2,0.1")
    command.agrees(lambda: scheme.artifacts((0.2, 0.1)), *words)
    command.agrees(lambda: scheme.artifacts((0.2, 0.1), steps=3), *words, "--steps", 3)


@pytest.mark.parametrize("name", ["loop", "catmull-clark", "sqrt3", "doo-sabin"])
def test_sampling_and_stages(command, name):
    scheme = limn.Scheme(name)
    assert scheme.sampling_density(2) == command("artifacts", name, "--tolerance", 2)
    printed = command("artifacts", name, "--frequency", "0.1,0.2", "--stages", 1)
    assert scheme.artifacts((0.1, 0.2), stages=1) == printed


def test_one_of_two_lattices(command):
    both = command("eigen", "quad-triangle", "--valence", 5)["lattices"]
    for found in both:
        scheme = limn.Scheme(f'extends = "quad-triangle"\nlattice = "{found["lattice"]}"\n')
        assert scheme.eigen(5) == found["valences"][0]
    with pytest.raises(limn.Error, match="no single lattice"):
        limn.Scheme("quad-triangle").eigen(5)


@pytest.mark.parametrize("name", SHIPPED)
def test_show(command, name):
    assert limn.Scheme(name).show(stencils=True) == command("show", name, "--stencils")


def test_schemes(command):
    printed = command("schemes")["schemes"]
    assert [limn.Scheme(name).summary() for name in limn.schemes()] == printed


def test_parameters(command):
    for value in ("3/16", 0.1875):
        scheme = limn.Scheme("laplacian-butterfly", parameters={"b": value})
        printed = command("artifacts", "laplacian-butterfly", "-p", "b=3/16", "-f", "0.1,0.1")
        assert scheme.artifacts((0.1, 0.1)) == printed
    changed = limn.Scheme("laplacian-butterfly").with_parameters(b="3/16")
    assert changed == scheme
    assert changed != limn.Scheme("laplacian-butterfly")


@pytest.mark.parametrize("engine", ["quick", "plain"])
@pytest.mark.parametrize("name", SHIPPED)
def test_refine(command, tmp_path, name, engine):
    scheme = limn.Scheme(name)
    V, F = mesh_of(scheme)
    mesh, out = tmp_path / "mesh.obj", tmp_path / "fine.ply"
    limn.write_mesh(mesh, V, F)
    words = ("refine", mesh, "-s", name, "-n", 3, "-o", out, "--engine", engine)
    if command.run(*words).returncode == 2:
        with pytest.raises(limn.Error):
            scheme.refine(V, F, 3, engine=engine)
        return
    fine, faces = scheme.refine(V, F, 3, engine=engine)
    read, read_faces = limn.read_mesh(out)
    assert np.array_equal(fine, read)
    for mine, theirs in zip(_parts(faces), _parts(read_faces)):
        assert np.array_equal(mine, theirs)


def _parts(faces):
    return faces if isinstance(faces, tuple) else (faces,)


@pytest.mark.filterwarnings("ignore:.*left out. normals")
@pytest.mark.parametrize("mesh, name", [(TRIANGLES, "loop"), (QUADS, "catmull-clark")])
def test_limit(command, tmp_path, mesh, name):
    out = tmp_path / "fine.obj"
    command("refine", mesh, "-s", name, "-n", 2, "--limit", "--normals", "-o", out)
    V, F = limn.read_mesh(mesh)
    points, faces, normals = limn.Scheme(name).refine(V, F, 2, limit=True, normals=True)
    assert np.array_equal(points, limn.read_mesh(out).vertices)
    lines = [line.split() for line in out.read_text().splitlines()]
    printed = [line[1:] for line in lines if line and line[0] == "vn"]
    assert np.array_equal(normals, np.array(printed, dtype=float))


@pytest.mark.filterwarnings("ignore::limn.LimnWarning")
def test_curvatures(command, tmp_path):
    out, table = tmp_path / "fine.ply", tmp_path / "k.json"
    V, F = limn.read_mesh(TRIANGLES)
    printed = command("refine", TRIANGLES, "-s", "loop", "-n", 1, "--curvatures", table, "-o", out)
    rows = json.loads(table.read_text())["rows"]
    surface = limn.Scheme("loop").refine(V, F, 1, curvatures=True)
    expected = [[np.nan if k is None else k for k in row[4:]] for row in rows]
    assert np.array_equal(surface.curvatures, np.array(expected, dtype=float), equal_nan=True)
    assert surface.missing == printed.get("missing", {})
    assert np.array_equal(surface.vertices, limn.read_mesh(out).vertices)


def test_sharpness(command, tmp_path):
    out = tmp_path / "fine.obj"
    V, F = limn.read_mesh(QUADS)
    for options, words in (
        ({"crease_angle": 60}, ["--crease-angle", 60]),
        ({"boundary": "edgeAndCorner"}, ["--boundary", "edgeAndCorner"]),
    ):
        command("refine", QUADS, "-s", "catmull-clark", "-n", 2, "-o", out, *words)
        fine, _ = limn.Scheme("catmull-clark").refine(V, F, 2, **options)
        assert np.array_equal(fine, limn.read_mesh(out).vertices)


def test_creases_as_arrays(command, tmp_path):
    V, F = mesh_of(limn.Scheme("catmull-clark"))
    tags = {
        "creases": np.array([[0, 1], [1, 3]]),
        "crease_sharpness": np.array([2.5, 1]),
        "corners": [6],
    }
    mesh, out = tmp_path / "mesh.obj", tmp_path / "fine.obj"
    limn.write_mesh(mesh, V, F, **tags)
    read = limn.read_mesh(mesh)
    assert read.tags["crease_sharpness"].tolist() == [2.5, 1]
    command("refine", mesh, "-s", "catmull-clark", "-n", 2, "-o", out)
    surface = limn.Scheme("catmull-clark").refine(V, F, 2, **tags)
    again = limn.Scheme("catmull-clark").refine(*read, 2, **read.tags)
    fine = limn.read_mesh(out)
    assert np.array_equal(surface.vertices, fine.vertices)
    assert np.array_equal(again.vertices, fine.vertices)
    assert np.array_equal(surface.tags["corners"], fine.tags["corners"])
    smooth, _ = limn.Scheme("catmull-clark").refine(V, F, 2, engine="plain")
    assert not np.allclose(smooth, surface.vertices)


def test_certify(command, tmp_path):
    scheme = limn.Scheme("loop")
    found = scheme.certify(range(3, 8))
    without = scheme.certify(5, curvature=False)
    assert without == command("certify", "loop", "--valence", "5", "--c1-only")
    assert found == command("certify", "loop", "--valence", "3..7")
    path = tmp_path / "loop.json"
    found.save(path)
    checked = command("certify", "--check", path)
    assert checked.pop("verified") and checked.pop("text_is_shipped")
    assert limn.check_certificate(found) == limn.check_certificate(path) == checked
    wrong = found.certificate()
    wrong["valences"][0]["eigenvalue"] *= 1.1
    path.write_text(json.dumps(wrong))
    with pytest.raises(limn.Error, match="refused"):
        limn.check_certificate(path)


def test_certify_all(command):
    assert limn.Scheme("loop").certify(all=True) == command("certify", "loop", "--all")


def test_tune(command):
    arguments = ["tune", "sqrt3", "--free", "alpha", "--valence", "4..6", "--time", 0]
    printed = command(*arguments, "--require", "cup = tangent^2")
    found = limn.tune("sqrt3", "alpha", "cup = tangent^2", range(4, 7), seconds=None)
    tuned = found.scheme()
    found.pop("text")
    assert found == printed
    components = tuned.eigen(5)["components"]
    assert components["cup"] == pytest.approx(components["tangent"] ** 2)
    printed = command(*arguments, "--require", "c1", "--range")
    assert limn.Scheme("sqrt3").tune("alpha", "c1", range(4, 7), seconds=None) == printed


def test_fairness(command):
    V, F = limn.read_mesh(TRIANGLES)
    printed = command("fairness", TRIANGLES, "-s", "loop", "-s", "optimal", "-n", 2)
    found = limn.fairness(V, F, ["loop", limn.Scheme("optimal")], levels=2)
    assert found["schemes"] == printed["schemes"]
    ends = command("fairness", TRIANGLES, "-s", "loop", "-n", 1, "--spectrum", 3)["spectrum"]
    assert limn.spectrum(V, F, 3) == ends


def test_compare(command):
    printed = command("compare", "loop", "sqrt3", "--valence", "3..4", "--time", 0)
    found = limn.compare("loop", "sqrt3", valence=range(3, 5), seconds=None)
    assert found == printed
    assert "sqrt3" in str(found)


def test_check(command, tmp_path):
    printed = command("check", TRIANGLES)
    found = limn.check_mesh(TRIANGLES)
    for key in found:
        assert found[key] == printed[key], key
    V, F = limn.read_mesh(TRIANGLES)
    assert limn.check_mesh(V, F)["euler"] == printed["euler"]


def test_eigen_formulas(command):
    for name in ("loop", "catmull-clark"):
        assert limn.Scheme(name).eigen_formulas() == command("eigen", name, "--formulas")


def test_eigenvectors(command):
    printed = command("eigen", "catmull-clark", "--valence", "5", "--vectors")
    assert limn.Scheme("catmull-clark").eigen(5, vectors=True) == printed["valences"][0]


def test_prescribe(command, tmp_path):
    out = tmp_path / "loop-prescribed.toml"
    command("prescribe", "loop", "--valence", 7, "--eigenvalues", "1/4,1/2,1/4,1/8", "-o", out)
    scheme = limn.Scheme("loop").prescribe(7, ["1/4", "1/2", "1/4", "1/8"])
    assert scheme.eigen(7) == limn.Scheme(out).eigen(7)
    assert scheme.eigen(7)["components"]["tangent"] == pytest.approx(0.5)


def test_creases_have_a_normal_on_each_side():
    cube = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], dtype=float)
    quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
    scheme = limn.Scheme("catmull-clark")
    sharp = scheme.refine(cube, quads, 1, normals=True, crease_angle=60)
    assert sharp.missing == {}
    normals = sharp.corner_normals.reshape(24, 4, 3)
    assert np.allclose(np.linalg.norm(normals, axis=2), 1)
    assert np.allclose(normals, normals[:, :1])  # faces stay flat
    assert scheme.refine(cube, quads, 1, normals=True).corner_normals is None
