"""Objects: pickled, compared, shown."""

import copy
import pickle
import re

import numpy as np
import pytest

import limn
from conftest import SHIPPED, mesh_of, tetrahedron


@pytest.mark.parametrize("name", SHIPPED)
def test_schemes_pickle(name):
    scheme = limn.Scheme(name)
    again = pickle.loads(pickle.dumps(scheme))
    assert again == scheme and hash(again) == hash(scheme)
    assert again.show() == scheme.show()


def test_schemes_pickle_with_parameters_and_files(tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text('extends = "laplacian-butterfly"\nname = "mine"\n')
    scheme = limn.Scheme(path, parameters={"b": "3/16"})
    path.unlink()  # the text is in the object
    again = copy.deepcopy(scheme)
    assert again == scheme and again.parameters["b"] == "3/16" and again.name == "mine"
    assert again.file == str(path)
    assert again.artifacts((0.1, 0)) == scheme.artifacts((0.1, 0))


def test_results_pickle():
    V, F = tetrahedron()
    loop = limn.Scheme("loop")
    for result in (loop.eigen(5), loop.regularity(), loop.certify(4), loop.show()):
        again = pickle.loads(pickle.dumps(result))
        assert again == result and type(again) is type(result)
    surface = loop.refine(V, F, 1, normals=True)
    again = pickle.loads(pickle.dumps(surface))
    assert np.array_equal(again.normals, surface.normals) and len(again) == 3
    refiner = limn.Refiner(loop, F, 2, vertices=4)
    again = pickle.loads(pickle.dumps(refiner))
    assert np.array_equal(again.evaluate(V), refiner.evaluate(V))
    assert again.scheme == loop
    found = pickle.loads(pickle.dumps(loop.artifact_map(8)))
    assert found.signal.shape == (8, 8)


def test_pictures_pickle():
    picture = limn.Scheme("loop").picture()
    again = pickle.loads(pickle.dumps(picture))
    assert again.bytes("svg") == picture.bytes("svg") and repr(again) == repr(picture)
    assert again.bytes("png")[:4] == b"\x89PNG" and again._repr_svg_() == picture._repr_svg_()
    with pytest.raises(limn.Error, match="svg, png or pdf"):
        again.bytes("gif")
    assert pickle.loads(pickle.dumps(again)).bytes("pdf") == again.bytes("pdf")


def test_a_refiner_of_more_vertices_than_memory_holds_says_so():
    _, F = tetrahedron()
    with pytest.raises(limn.MeshError, match="GB of memory at least"):
        limn.Refiner(limn.Scheme("loop"), F, 1, vertices=2_000_000_000)


def test_a_scheme_of_a_text_is_that_of_its_file():
    loop = limn.Scheme("loop")
    text = limn.Scheme(loop.text)
    assert text.eigen(5) == loop.eigen(5) and text.file == "text"
    assert "split" in loop.text and loop.split == "triangle-dyadic" and "Loop" in loop.source


def test_representations():
    loop = limn.Scheme("loop")
    assert "loop" in repr(loop) and "ring" in str(loop)
    page = loop._repr_html_()
    assert "<svg" in page and "3/8" in page and "<table>" in page
    assert "0.5" in loop.eigen(6)._repr_html_() and "<table>" in loop.regularity()._repr_html_()
    assert "proved" in loop.certify(5)._repr_html_()
    chart = loop.characteristic_map(5)
    assert chart._repr_svg_().startswith("<?xml") and "valence 5" in repr(chart)
    found = loop.artifact_map(16)
    assert found._repr_png_().startswith(b"\x89PNG") and "16 × 16" in repr(found)
    assert "4 → 34" in repr(limn.Refiner("loop", tetrahedron()[1], 2))
    assert repr(loop.refine(*tetrahedron(), 1)) == "<limn.Surface: 10 vertices, 16 faces>"


def cells(page):
    """The rows of all tables of a page, as lists of what stands in the cells."""
    rows = re.findall(r"<tr>(.*?)</tr>", page)
    return [re.findall(r"<t[hd]>(.*?)</t[hd]>", row) for row in rows]


def test_tables_have_the_numbers():
    loop = limn.Scheme("loop")
    found = loop.eigen(7)
    rows = cells(found._repr_html_())
    assert rows[0] == ["frequency", "eigenvalue", "ring", "Jordan block"]
    count = sum(len(block["eigenvalues"]) for block in found["blocks"])
    assert len(rows) == 1 + count and ["1", f"{found['components']['tangent']:.6g}", "1", "1"] in rows
    mask = [row for row in cells(loop._repr_html_()) if row[-1] == "5/8"]
    assert mask == [["(0, 0)", "5/8"]]
    proof = cells(loop.certify(range(3, 6))._repr_html_())
    assert [row[:2] for row in proof[1:]] == [[str(n), "proved"] for n in (3, 4, 5)]
    smooth = dict(row[:2] for row in cells(loop.regularity()._repr_html_()))
    assert smooth["c2"] == "yes"
    energies = limn.fairness(*tetrahedron(), ["loop", "sqrt3"], levels=1)
    rows = cells(energies._repr_html_())
    assert rows[1][0] == "loop" and rows[1][3] == f"{energies['schemes'][0]['thin_plate']:.6g}"


def test_tables_of_what_was_tuned():
    scheme = limn.Scheme("sqrt3")
    found = scheme.tune("alpha", "cup = tangent^2", 5)
    rows = cells(found._repr_html_())
    assert rows[1][:2] == ["5", f"{found['valences'][0]['solutions'][0]['value']:.6g}"]
    ends = cells(scheme.tune("alpha", "c1", 5)._repr_html_())[1][1:3]
    assert float(ends[0]) < float(ends[1])
    both = limn.tune("loop-type", ["b", "beta"], ["tangent = 11/20", "cup = 1/4"], 7)
    rows = cells(both._repr_html_())
    assert rows[0] == ["valence", "b", "beta", "holds"] and rows[1][0] == "7"


def test_a_comparison_is_shown_as_its_table():
    found = limn.compare("loop", "sqrt3", valence=[5], budget=50)

    class Printer:
        text = staticmethod(lambda text: shown.append(text))

    shown = []
    found._repr_pretty_(Printer, False)
    assert shown == [str(found)] and "sqrt3" in shown[0]


@pytest.mark.parametrize("name", SHIPPED)
def test_every_scheme_is_shown(name):
    assert name in limn.Scheme(name)._repr_html_()


def test_pictures(tmp_path):
    loop = limn.Scheme("loop")
    loop.picture().save(tmp_path / "stencils.pdf")
    assert (tmp_path / "stencils.pdf").read_bytes().startswith(b"%PDF")
    with pytest.raises(limn.Error):
        loop.picture().save(tmp_path / "stencils.txt")
    drawn = loop.draw(*tetrahedron(), 3)
    assert drawn._repr_png_().startswith(b"\x89PNG") and drawn._repr_svg_() is None


def test_artifact_map_is_artifacts():
    for name in ("loop", "catmull-clark", "sqrt3"):
        scheme = limn.Scheme(name)
        found = scheme.artifact_map((12, 10))
        for i, j in ((3, 4), (9, 11), (0, 5)):
            one = scheme.artifacts((found.fx[j], found.fy[i]))
            assert found.signal[i, j] == pytest.approx(one["signal"], abs=1e-13)
            assert found.artifacts[:, i, j] == pytest.approx(one["artifacts"], abs=1e-13)
            assert found.percent_of_signal[i, j] == pytest.approx(one["percent_of_signal"])
        left, right, bottom, top = found.extent
        assert right == pytest.approx(max(x for x, _ in found.nyquist_region))
        assert top == pytest.approx(max(y for _, y in found.nyquist_region)) and left < bottom + 1


def test_limit_stencil_of_loop():
    """Loop 1987: the limit of a vertex is 1 - n χ, χ = 1/(n + 3/(8 β)) [Warren, Weimer 2002]."""
    n = 5
    stencil = limn.Scheme("loop").limit_stencil(n)
    beta = (5 / 8 - (3 / 8 + np.cos(2 * np.pi / n) / 4) ** 2) / n
    weight = 1 / (n + 3 / (8 * beta))
    position = stencil["position"]
    assert position[0] == pytest.approx(1 - n * weight) and position[1] == pytest.approx(weight)
    assert sum(position) == pytest.approx(1) and sum(stencil["first_tangent"]) == pytest.approx(0)
    assert limn.Scheme("loop").limit_stencil(2, boundary=True)["has_plane"] in (True, False)


def test_characteristic_map_of_a_regular_vertex():
    found = limn.Scheme("loop").characteristic_map(6)
    assert found.eigenvalue == pytest.approx(0.5) and found.regular == "yes"
    V, F = found.image
    assert V.shape[1] == 3 and np.all(V[:, 2] == 0) and F.max() < len(V)


def test_limit_points_of_a_regular_solid():
    V, F = tetrahedron()
    points, normals = limn.Scheme("loop").limit_points(V, F)
    assert np.allclose(np.linalg.norm(points, axis=1), np.linalg.norm(points[0]))
    assert np.allclose(normals, points / np.linalg.norm(points[0]))
