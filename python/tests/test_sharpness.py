"""Sharp edges, corners, holes and smooth triangles: by `refine`, by a Refiner, by the command."""

import pickle

import numpy as np
import pytest

import limn
from conftest import QUADS, TRIANGLES, cube, tetrahedron


def mixed_cube():
    """A cube with two faces cut into triangles."""
    V, F = cube()
    return V, [[0, 2, 3], [0, 3, 1], [4, 5, 7], [4, 7, 6], *F[2:].tolist()]


def parts(faces):
    return faces if isinstance(faces, tuple) else (faces,)


def same_faces(mine, theirs):
    return all(np.array_equal(a, b) for a, b in zip(parts(mine), parts(theirs)))


def same_tags(mine, theirs):
    return mine.keys() == theirs.keys() and all(np.array_equal(mine[k], theirs[k]) for k in mine)


TOP = [[4, 5], [5, 7], [7, 6], [6, 4]]
TAGS = {
    "for ever": {"creases": TOP, "corners": [0]},
    "fading": {"creases": TOP, "crease_sharpness": 1.5, "corners": [0, 3], "corner_sharpness": [2, 3.25]},
    "one by one": {"creases": TOP, "crease_sharpness": [0.5, 1.5, 2.5, 10]},
    "chaikin": {"creases": TOP, "crease_sharpness": 2.5, "crease_method": "chaikin"},
    "dart": {"creases": TOP[:1]},
    "holes": {"holes": [1, 4], "creases": TOP[:2], "crease_sharpness": 4},
    "all holes": {"holes": list(range(6))},
}


@pytest.mark.parametrize("levels", [0, 1, 3])
@pytest.mark.parametrize("what", list(TAGS))
def test_a_refiner_has_the_numbers_of_refine(what, levels):
    V, F = cube()
    scheme = limn.Scheme("catmull-clark")
    tags = TAGS[what]
    expected = scheme.refine(V, F, levels, **tags)
    refiner = limn.Refiner(scheme, F, levels, **tags)
    assert refiner.is_fast and refiner.vertex_count == len(expected.vertices)
    assert np.array_equal(refiner.evaluate(V), expected.vertices)
    assert same_faces(refiner.faces, expected.faces)
    assert same_tags(refiner.tags, expected.tags)
    out = np.empty((refiner.vertex_count, 3))
    assert refiner.evaluate(2 * V, out) is out and np.allclose(out, 2 * expected.vertices)
    small = refiner.evaluate(V.astype(np.float32))
    assert small.dtype == np.float32 and np.allclose(small, expected.vertices, atol=1e-6)
    columns = refiner.evaluate(np.hstack([V, V[:, :1]]))
    assert np.allclose(columns[:, 3], expected.vertices[:, 0], atol=1e-15)
    if levels > 0 and "holes" not in tags:
        smooth = scheme.refine(V, F, levels)
        assert not np.allclose(smooth.vertices, expected.vertices, atol=1e-3)


@pytest.mark.parametrize("mesh, name", [(TRIANGLES, "loop"), (QUADS, "catmull-clark")])
@pytest.mark.parametrize("boundary", ["none", "edgeOnly", "edgeAndCorner"])
def test_a_refiner_of_a_part(mesh, name, boundary):
    V, F = limn.read_mesh(mesh)
    scheme = limn.Scheme(name)
    edges = scheme.refine(V, F, 0, crease_angle=60).tags
    expected = scheme.refine(V, F, 3, crease_angle=60, boundary=boundary)
    refiner = limn.Refiner(scheme, F, 3, len(V), boundary=boundary, **edges)
    assert len(edges["creases"]) > 10
    assert np.array_equal(refiner.evaluate(V), expected.vertices)
    assert same_faces(refiner.faces, expected.faces) and same_tags(refiner.tags, expected.tags)


@pytest.mark.filterwarnings("ignore::limn.LimnWarning")
@pytest.mark.parametrize("what", ["for ever", "fading", "holes", "faded"])
def test_the_limit_by_a_refiner(what):
    V, F = cube()
    tags = {"creases": TOP, "crease_sharpness": 0.5, "holes": [1]} if what == "faded" else TAGS[what]
    scheme = limn.Scheme("catmull-clark")
    expected = scheme.refine(V, F, 2, limit=True, normals=True, **tags)
    points, normals = limn.Refiner(scheme, F, 2, **tags).evaluate_limit(V)
    assert np.allclose(points, expected.vertices, atol=1e-12)
    assert np.allclose(normals, expected.normals, atol=1e-9)


def test_what_is_left_to_the_plain_engine_is_refused_with_the_reason():
    V, F = tetrahedron()
    edge = {"creases": [[0, 1]]}
    for name, tags, why in (
        ("sqrt3", edge, "its split, sqrt3, does not cut sharp edges in every step"),
        (
            "loop",
            {
                "creases": [[0, 1], [1, 2]],
                "crease_sharpness": [1, 2],
                "crease_method": "chaikin",
            },
            "edges of different sharpness that meet do not fade evenly",
        ),
        (
            "butterfly",
            {"creases": [[0, 1], [1, 2]], "crease_sharpness": [0.5, 0.75]},
            "its rules look past creases, and these end in a step with different sharpness",
        ),
    ):
        with pytest.raises(limn.Error, match=why) as caught:
            limn.Refiner(name, F, 2, **tags)
        assert name in caught.value.message and "Scheme.refine" in caught.value.hint
        assert len(limn.Scheme(name).refine(V, F, 2, **tags).vertices) > 4


def test_what_no_engine_takes_is_refused_in_the_same_words():
    V, F = cube()
    for name, tags in (
        ("doo-sabin", {"corners": [0]}),
        ("midedge", {"creases": [[0, 1]]}),
        ("four-eight", {"holes": [0]}),
        ("catmull-clark", {"creases": [[0, 7]]}),
        ("catmull-clark", {"corners": [8]}),
        ("catmull-clark", {"boundary": "round"}),
        ("catmull-clark", {"triangles": "round"}),
    ):
        said = []
        for call in (
            lambda: limn.Scheme(name).refine(V, F, 2, **tags),
            lambda: limn.Refiner(name, F, 2, **tags),
        ):
            with pytest.raises(limn.Error) as caught:
                call()
            said.append(str(caught.value))
        assert said[0] == said[1]


def test_a_refiner_with_sharpness_pickles():
    V, F = cube()
    creases = np.array(TOP)
    for tags in (
        {"creases": creases, "crease_sharpness": 2.5, "crease_method": "chaikin", "holes": [1]},
        {"boundary": "none", "creases": creases, "triangles": "smooth"},
    ):
        faces = F[:5]  # open
        refiner = limn.Refiner("catmull-clark", faces, 2, len(V), **tags)
        before = refiner.evaluate(V)
        creases[:] = 0  # its own copy is what it has
        again = pickle.loads(pickle.dumps(refiner))
        creases[:] = TOP
        assert np.array_equal(again.evaluate(V), before)
        assert same_tags(again.control_tags, refiner.control_tags)
        assert same_tags(again.tags, refiner.tags) and same_faces(again.faces, refiner.faces)
    assert refiner.control_tags["triangles"] == "smooth"


@pytest.mark.parametrize("engine", ["quick", "plain"])
def test_smooth_triangles_are_the_commands(command, tmp_path, engine):
    V, F = mixed_cube()
    scheme = limn.Scheme("catmull-clark")
    mesh, out = tmp_path / "mesh.obj", tmp_path / "fine.obj"
    limn.write_mesh(mesh, V, F)
    words = ("refine", mesh, "-s", "catmull-clark", "-n", 3, "-o", out, "--engine", engine)
    fine = {}
    for triangles in ("smooth", "catmullClark"):
        command(*words, "--triangles", triangles)
        fine[triangles] = scheme.refine(V, F, 3, triangles=triangles, engine=engine).vertices
        assert np.array_equal(fine[triangles], limn.read_mesh(out).vertices)
    assert np.array_equal(fine["catmullClark"], scheme.refine(V, F, 3, engine=engine).vertices)
    assert np.abs(fine["smooth"] - fine["catmullClark"]).max() > 0.01


def test_smooth_triangles_beside_creases_and_at_the_limit(command, tmp_path):
    V, F = mixed_cube()
    scheme = limn.Scheme("catmull-clark")
    tags = {"creases": TOP, "crease_sharpness": 1.5, "triangles": "smooth"}
    mesh, out = tmp_path / "mesh.obj", tmp_path / "fine.ply"
    limn.write_mesh(mesh, V, F, **tags)
    for more, words in (({}, []), ({"limit": True}, ["--limit"])):
        command("refine", mesh, "-s", "catmull-clark", "-n", 2, "-o", out, *words)
        surface = scheme.refine(V, F, 2, **tags, **more)
        assert np.array_equal(surface.vertices, limn.read_mesh(out).vertices)
    refiner = limn.Refiner(scheme, F, 2, **tags)
    assert np.array_equal(refiner.evaluate(V), scheme.refine(V, F, 2, **tags).vertices)
    assert np.allclose(refiner.evaluate_limit(V)[0], surface.vertices, atol=1e-12)
    again = pickle.loads(pickle.dumps(refiner))
    assert np.array_equal(again.evaluate(V), refiner.evaluate(V))
    for call in (
        lambda: limn.Scheme("loop").refine(*tetrahedron(), 1, triangles="smooth"),
        lambda: limn.Refiner("loop", tetrahedron()[1], 1, triangles="smooth"),
    ):
        with pytest.raises(limn.SchemeError, match="loop has no rule for smooth triangles"):
            call()


TAGS_FILE = """
boundary = "none"
creases  = "chaikin"
[[crease]]
vertices  = [1, 2]
sharpness = 2.5
[[crease]]
groups    = ["lid"]
sharpness = 1.5
[[corner]]
vertices  = [3]
sharpness = "infinite"
[[hole]]
faces     = [2]
"""


@pytest.mark.filterwarnings("ignore::limn.LimnWarning")
def test_a_file_of_tags(command, tmp_path):
    mesh, tags, out = tmp_path / "mesh.obj", tmp_path / "tags.toml", tmp_path / "fine.obj"
    limn.write_mesh(mesh, *cube(), creases=[[0, 1], [0, 2]], crease_sharpness=0.5)
    text = mesh.read_text()
    first = text.index("\nf ") + 1
    mesh.write_text(text[:first] + "g lid\n" + text[first:].replace("\nf", "\ng rest\nf", 1))
    tags.write_text(TAGS_FILE)
    read = limn.read_mesh(mesh, tags=tags)
    assert read.tags["boundary"] == "none" and read.tags["crease_method"] == "chaikin"
    command("refine", mesh, "--tags", tags, "-s", "catmull-clark", "-n", 2, "-o", out)
    fine = limn.Scheme("catmull-clark").refine(*read, 2, **read.tags)
    assert np.array_equal(fine.vertices, limn.read_mesh(out).vertices)
    alone = limn.read_mesh(mesh)
    other = limn.Scheme("catmull-clark").refine(*alone, 2, **alone.tags)
    assert "holes" not in alone.tags and len(other.vertices) > len(fine.vertices)
    for wrong in ("[1, 2]", "[2]"):
        tags.write_text(TAGS_FILE.replace(wrong, "[1, 99]"))
        with pytest.raises(limn.MeshError) as caught:
            limn.read_mesh(mesh, tags=tags)
        assert caught.value.file == str(tags) and caught.value.line > 0
        done = command.run("refine", mesh, "--tags", tags, "-s", "catmull-clark", "-o", out)
        assert done.stderr.decode().splitlines() == ["limn: " + str(caught.value)]


@pytest.mark.filterwarnings("ignore:.*left out")
@pytest.mark.parametrize(
    "tags",
    [
        {"boundary": "edgeAndCorner"},
        {"boundary": "none", "holes": np.array([1], np.int32)},
        {"creases": [[0, 1], [1, 5]], "crease_sharpness": [1.5, 2.5], "crease_method": "chaikin"},
        {
            "triangles": "smooth",
            "corners": np.array([0, 6], np.int32),
            "corner_sharpness": [1.5, 10.0],
        },
    ],
)
def test_all_that_a_file_says_goes_along(command, tmp_path, tags):
    V, F = mixed_cube()
    mesh, out = tmp_path / "mesh.obj", tmp_path / "fine.obj"
    limn.write_mesh(mesh, V, F[:-1], **tags)
    read = limn.read_mesh(mesh)
    assert same_tags(read.tags, tags)
    command("refine", mesh, "-s", "catmull-clark", "-n", 1, "-o", out)
    surface = limn.Scheme("catmull-clark").refine(*read, 1, **read.tags)
    fine = limn.read_mesh(out)
    assert np.array_equal(surface.vertices, fine.vertices)
    assert same_faces(surface.faces, fine.faces) and same_tags(surface.tags, fine.tags)
    if "holes" not in tags:  # they are gone, and what depended on them has a boundary
        further, _ = limn.Scheme("catmull-clark").refine(*surface, 1, **surface.tags)
        whole, _ = limn.Scheme("catmull-clark").refine(*read, 2, **read.tags)
        distances = np.linalg.norm(further[:, None] - whole[None], axis=2)
        assert len(further) == len(whole) and distances.min(axis=1).max() < 1e-12
