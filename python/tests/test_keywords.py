"""Each keyword does what the command's option of its kind does; none is merely taken."""

import numpy as np
import pytest

import limn
from conftest import QUADS, TRIANGLES, cube


def test_rings(command):
    loop = limn.Scheme("loop")
    for rings in (1, 2):
        printed = command("eigen", "loop", "--valence", 5, "--rings", rings)["valences"][0]
        assert loop.eigen(5, rings=rings) == printed
    assert loop.eigen(5, rings=1) != loop.eigen(5, rings=2)


def test_formulas_of_what_is_evaluated(command):
    scheme = limn.Scheme("laplacian-butterfly", parameters={"b": "3/16"})
    printed = command("eigen", "laplacian-butterfly", "-p", "b=3/16", "--formulas")
    assert scheme.eigen_formulas() == scheme.eigen_formulas(["b"]) == printed
    assert scheme.eigen_formulas([]) == command("eigen", "laplacian-butterfly", "--formulas")
    assert scheme.eigen_formulas([]) != printed
    loop = limn.Scheme("loop")
    assert loop.eigen_formulas(rings=1) != loop.eigen_formulas(rings=2)


def test_steps_of_a_characteristic_map():
    loop = limn.Scheme("loop")
    sizes = [len(loop.characteristic_map(5, steps=steps).image[0]) for steps in (1, 2, 3)]
    assert sizes[0] < sizes[1] < sizes[2]
    assert loop.characteristic_map(7).valence == 7


def test_bits_and_time_of_certificates(command, tmp_path):
    loop = limn.Scheme("loop")
    for bits in (64, 256):
        found = loop.certify(5, bits=bits)
        assert found == command("certify", "loop", "--valence", 5, "--bits", bits)
        assert found["valences"][0]["bits"] == bits
    hurried = limn.Scheme("butterfly").certify(range(3, 200), seconds=1e-9)
    assert "undecided" in {claim["c1"] for claim in hurried["valences"]}


def test_how_long_regularity_looks(command):
    scheme = limn.Scheme("optimal-low")
    found = scheme.regularity(budget=300, tolerance=0.5, seconds=None)
    words = ("regularity", "optimal-low", "--budget", 300, "--time", 0)
    assert found == command(*words, "--tolerance", 0.5)
    assert found != scheme.regularity(budget=300, seconds=None)


TUNE = ("tune", "sqrt3", "--free", "alpha", "--time", 0, "--valence", "4..6")


def test_tuning_between(command):
    scheme = limn.Scheme("sqrt3")
    require, values = "cup = tangent^2", []
    for between, words in (
        ((0, "1/2"), ("--between", "0,1/2")),
        ((0.5, 1), ("--between", "1/2,1")),
    ):
        printed = command(*TUNE, "--require", require, *words)
        found = scheme.tune("alpha", require, range(4, 7), between=between, seconds=None)
        found.pop("text", found.pop("no_text", None))
        assert found == printed
        values.append([one["value"] for entry in found["valences"] for one in entry["solutions"]])
    assert max(values[0]) <= 0.5 <= min(values[1])


def test_tuning_everywhere(command):
    words = ("tune", "loop", "--free", "beta", "--time", 0, "--valence", 5)
    require = "saddle = tangent^3"
    found = {}
    for everywhere in (False, True):
        more = ("--everywhere",) if everywhere else ()
        found[everywhere] = limn.tune("loop", "beta", require, 5, everywhere=everywhere, seconds=None)
        found[everywhere].pop("text", found[everywhere].pop("no_text", None))
        assert found[everywhere] == command(*words, "--require", require, *more)


def test_tuning_of_several_names(command):
    scheme = limn.Scheme("loop-type")
    free, require = ["b", "beta"], ["tangent = 11/20", "cup = 1/4"]
    words = ["tune", "loop-type", "--time", 0, "--valence", 7]
    for option, values in (("--free", free), ("--require", require)):
        for value in values:
            words += [option, value]
    for between, everywhere in ((None, False), ([("1/4", "1/2"), (0, 0.125)], False), (None, True)):
        more = ["--between", "1/4,1/2", "--between", "0,1/8"] if between else []
        more += ["--everywhere"] if everywhere else []
        options = {"between": between, "everywhere": everywhere, "seconds": None}
        found = scheme.tune(free, require, 7, **options)
        if found["valences"][0]["solutions"]:
            components = found.scheme().eigen(7)["components"]
            assert components["tangent"] == pytest.approx(11 / 20)
            assert components["cup"] == pytest.approx(1 / 4)
        found.pop("text", found.pop("no_text", None))
        assert found == command(*words, *more)
    for between in ((0, 1), [(0, 1)]):
        with pytest.raises(limn.Error):
            scheme.tune(free, require, 7, between=between)


@pytest.mark.filterwarnings("ignore::limn.LimnWarning")
def test_comparing_over_a_mesh(command):
    V, F = limn.read_mesh(TRIANGLES)
    words = ("compare", "loop", "sqrt3", "--valence", "5..6", "--budget", 100, "--time", 0)
    printed = command(*words, "--mesh", TRIANGLES, "-n", 2, "--tolerance", 3)
    found = limn.compare(
        "loop",
        "sqrt3",
        mesh=(V, F),
        valence=range(5, 7),
        tolerance=3,
        budget=100,
        seconds=None,
        levels=2,
    )
    assert found.pop("mesh") == "mesh" and found["distances"]
    for key in found:
        assert found[key] == printed[key], key


def test_labels():
    V, F = limn.read_mesh(TRIANGLES)
    wide = limn.Scheme("laplacian-loop").with_parameters(a="1/32")
    found = limn.fairness(V, F, {"one": "laplacian-loop", "other": wide}, levels=1)
    assert [one["scheme"] for one in found["schemes"]] == ["one", "other"]
    assert found["schemes"][0]["laplacian_energy"] != found["schemes"][1]["laplacian_energy"]
    found = limn.fairness(V, F, ["laplacian-loop", wide], levels=1)
    assert [one["scheme"] for one in found["schemes"]] == ["laplacian-loop", "laplacian-loop a=1/32"]


@pytest.mark.parametrize(
    "words, keywords",
    [
        ([], {}),
        (["--stripes", "--lights", 12], {"kind": "stripes", "lights": 12}),
        (["--reflection-lines", "--lights", 9], {"kind": "lines", "lights": 9}),
        (["--marks", "--crease-angle", 60], {"marks": True, "crease_angle": 60}),
        (["--boundary", "none"], {"boundary": "none"}),
        (["--net", "--azimuth", 20, "--elevation", 60], {"net": True, "azimuth": 20, "elevation": 60}),
    ],
)
def test_drawing(command, tmp_path, words, keywords):
    V, F = limn.read_mesh(QUADS)
    out = tmp_path / "surface.png"
    assert command.run("draw", QUADS, "-s", "catmull-clark", "-n", 1, "-o", out, *words).returncode == 0
    drawn = limn.Scheme("catmull-clark").draw(V, F, 1, **keywords)
    assert drawn.bytes("png") == out.read_bytes()
    if keywords:
        assert drawn.bytes("png") != limn.Scheme("catmull-clark").draw(V, F, 1).bytes("png")


def test_drawing_refuses():
    V, F = cube()
    scheme = limn.Scheme("catmull-clark")
    with pytest.raises(TypeError, match="crease"):
        scheme.draw(V, F, crease=[[0, 1]])
    with pytest.raises(limn.MeshError):
        scheme.draw(V, F, creases=[[0, 7]]).bytes()
    for keywords in ({"kind": "round"}, {"lights": 0}, {"crease_angle": 181}):
        with pytest.raises(limn.Error):
            scheme.draw(V, F, **keywords)


def soup():
    """A cube whose faces have vertices of their own."""
    V, F = cube()
    return V[F].reshape(-1, 3), np.arange(24).reshape(-1, 4)


def faulty_mesh():
    """The same with a face that is turned, and one that is there twice."""
    V, F = soup()
    F[2] = F[2][::-1]
    return V, np.vstack([F, F[:1]])


def turned():
    V, F = cube()
    F[2] = F[2][::-1]
    return V, F


def bow_tie():
    """Two cubes that share a vertex."""
    V, F = cube()
    other = F + 7
    other[other == 7] = 7
    return np.vstack([V, V[1:] + 2]), np.vstack([F, other])


@pytest.mark.parametrize(
    "mesh, words, keywords",
    [
        (soup(), ["--weld=0"], {"weld": 0.0}),
        (soup(), ["--weld"], {"weld": True}),
        (turned(), ["--orient"], {"orient": True}),
        (bow_tie(), ["--cut"], {"cut": True}),
        (faulty_mesh(), ["--repair"], {}),
        (faulty_mesh(), ["--repair"], {"weld": 0.0, "drop": True, "cut": True, "orient": True}),
        (cube(), ["--triangulate"], {"triangulate": True}),
    ],
)
def test_repairs(command, tmp_path, mesh, words, keywords):
    path, out = tmp_path / "faulty.obj", tmp_path / "mended.obj"
    limn.write_mesh(path, *mesh)
    assert command.run("check", path, "-o", out, *words).returncode == 0
    mended, expected = limn.repair_mesh(*mesh, **keywords), limn.read_mesh(out)
    assert np.array_equal(mended.vertices, expected.vertices)
    assert np.array_equal(mended.faces, expected.faces)
    assert (len(mended.vertices), len(mended.faces)) != (len(mesh[0]), len(mesh[1])) or (
        not np.array_equal(mended.faces, mesh[1])
    )


def book():
    """Four quads at one edge."""
    ends = [(0, 0), (1, 0), (0, 2), (-1, 0.5), (0.3, -1)]
    V = np.array([[x, y, z] for x, y in ends for z in (0.0, 1.0)])
    return V, np.array([[0, 1, 2 * i + 3, 2 * i + 2] for i in range(4)])


@pytest.mark.parametrize("mesh", [book(), bow_tie()])
@pytest.mark.parametrize("boundary", [None, "edgeOnly", "edgeAndCorner"])
def test_what_was_cut_is_refined_as_by_the_command(command, tmp_path, mesh, boundary):
    path, out = tmp_path / "sheets.obj", tmp_path / "fine.ply"
    limn.write_mesh(path, *mesh)
    words = ["--boundary", boundary] if boundary else []
    command("refine", path, "-s", "catmull-clark", "-n", "2", "--repair", "-o", out, *words)
    mended = limn.repair_mesh(*mesh)
    assert mended.tags
    scheme = limn.Scheme("catmull-clark")
    fine = scheme.refine(*mended, 2, boundary=boundary, **mended.tags)
    expected = limn.read_mesh(out)
    assert np.allclose(fine.vertices, expected.vertices, atol=1e-12)
    if boundary != "edgeAndCorner":  # which holds all corners of the book's sheets
        plain = scheme.refine(*mended, 2, boundary=boundary)
        assert not np.allclose(plain.vertices, expected.vertices, atol=1e-3)


def test_what_is_not_asked_for_is_not_repaired():
    V, F = faulty_mesh()
    assert len(limn.repair_mesh(V, F, drop=True).vertices) == 24
    assert limn.check_mesh(*limn.repair_mesh(V, F, weld=0))["flipped_edges"] == 4
    assert limn.check_mesh(*limn.repair_mesh(V, F, weld=0, orient=True))["duplicate_faces"] == 1


def test_weld_within_a_distance():
    V, F = faulty_mesh()
    V[0] += 1e-3
    counts = [len(limn.repair_mesh(V, F, weld=weld).vertices) for weld in (0, 1e-6, 0.01)]
    assert counts == [9, 9, 8]


def test_normals_are_written(tmp_path):
    V, F = cube()
    normals = V / np.linalg.norm(V, axis=1, keepdims=True)
    limn.write_mesh(tmp_path / "mesh.obj", V, F, normals=normals)
    lines = [line.split() for line in (tmp_path / "mesh.obj").read_text().splitlines()]
    written = [line[1:] for line in lines if line and line[0] == "vn"]
    assert np.array_equal(np.array(written, dtype=float), normals)
    with pytest.raises(limn.MeshError, match="normals"):
        limn.write_mesh(tmp_path / "mesh.obj", V, F, normals=normals[:3])


def test_words_are_the_commands(tmp_path):
    import os
    import subprocess

    def said(*words):
        run = [os.environ["LIMN_COMMAND"], *words]
        return subprocess.run(run, capture_output=True, text=True, check=True).stdout

    for name in ("loop", "catmull-clark"):
        scheme = limn.Scheme(name)
        assert scheme.describe().strip() == said("show", name).strip()
        assert scheme.latex().strip() == said("show", name, "--latex").strip()
        proof = scheme.certify(5)
        assert proof.report.strip() == said("certify", name, "--valence", "5").strip()
        assert proof.latex.strip() == said("certify", name, "--valence", "5", "--latex").strip()
    pair = limn.compare("loop", "sqrt3", valence=[5], budget=50, seconds=None)
    words = ("compare", "loop", "sqrt3", "--valence", "5", "--budget", "50", "--time", "0")
    assert str(pair).strip() == said(*words).strip()


def test_a_limit_stencil_of_a_boundary():
    loop = limn.Scheme("loop")
    boundary = loop.limit_stencil(3, boundary=True)
    assert boundary["position"] == pytest.approx([2 / 3, 1 / 6, 0, 0, 1 / 6], abs=1e-12)
    assert len(loop.limit_stencil(3)["position"]) == 4 and boundary["rings"] == 1
