"""Arrays in and out."""

import numpy as np
import pytest

import limn
from conftest import cube, tetrahedron


def test_arrays_own_what_the_library_made():
    V, F = tetrahedron()
    fine, faces = limn.Scheme("loop").refine(V, F, 3)
    for array, width in ((fine, 3), (faces, 3)):
        assert array.shape[1] == width and array.flags.c_contiguous and array.flags.writeable
        assert not array.flags.owndata and type(array.base).__name__ == "PyCapsule"
    assert fine.dtype == np.float64 and faces.dtype == np.int32
    assert fine.shape == (130, 3) and faces.shape == (256, 3)


def test_kinds_of_numbers():
    V, F = tetrahedron()
    V = V / 3  # no fraction of a power of 2
    scheme = limn.Scheme("loop")
    exact, faces = scheme.refine(V, F, 2)
    small, _ = scheme.refine(V.astype(np.float32), F, 2)
    assert small.dtype == np.float32
    assert np.allclose(exact, small, atol=1e-6) and not np.array_equal(exact, small)
    for positions in (V.tolist(), np.asfortranarray(V), V[::-1][::-1]):
        assert np.array_equal(scheme.refine(positions, F, 2)[0], exact)
    for indices in (F.astype(np.int64), F.astype(np.uint8), F.tolist(), np.asfortranarray(F)):
        assert np.array_equal(scheme.refine(V, indices, 2)[1], faces)
    whole = np.rint(3 * V).astype(int)
    assert np.array_equal(scheme.refine(whole, F, 2)[0], scheme.refine(3 * V, F, 2)[0])


def test_kinds_of_numbers_of_what_comes_back():
    V, F = tetrahedron()
    scheme = limn.Scheme("loop")
    for kind in (np.float32, np.float64):
        mesh = V.astype(kind), F
        surface = scheme.refine(*mesh, 1, limit=True, normals=True)
        sharp = scheme.refine(*mesh, 2, normals=True, creases=[[0, 1], [1, 2], [2, 0]])
        refiner = limn.Refiner(scheme, F, 1)
        arrays = [surface.vertices, surface.normals, sharp.vertices, sharp.corner_normals]
        arrays += [*scheme.limit_points(*mesh), refiner.evaluate(mesh[0])]
        arrays += [refiner.evaluate(mesh[0][:, :2]), refiner.evaluate(mesh[0][:, 0])]
        assert [array.dtype for array in arrays] == [kind] * len(arrays)
        whole = [*refiner.evaluate_limit(mesh[0]), *limn.repair_mesh(*mesh)[:1]]
        assert {array.dtype for array in whole} == {np.dtype(float)}
        assert np.allclose(arrays[0], whole[0], atol=1e-6)


def test_mixed_faces():
    V, F = cube()
    mixed = [[0, 2, 3], [0, 3, 1], *F[1:].tolist()]
    offsets = np.cumsum([0, *(len(face) for face in mixed)])
    corners = np.concatenate(mixed)
    scheme = limn.Scheme("catmull-clark")
    fine, faces = scheme.refine(V, mixed, 1)
    again, again_faces = scheme.refine(V, (corners, offsets), 1)
    assert np.array_equal(fine, again) and np.array_equal(faces, again_faces)
    assert faces.shape == (len(corners), 4)  # one quad for each corner
    kept, (kept_corners, kept_offsets) = scheme.refine(V, mixed, 0)
    assert np.array_equal(kept, V)
    assert np.array_equal(kept_corners, corners) and np.array_equal(kept_offsets, offsets)


def test_positions_are_read_in_place():
    """No copy is made of what is large: memory rises by the result's size, not by more."""
    import tracemalloc

    V, F = cube()
    V, F = limn.Scheme("catmull-clark").refine(V, F, 7)
    refiner = limn.Refiner("catmull-clark", F, 1)
    out = np.empty((refiner.vertex_count, 3))
    refiner.evaluate(V, out)
    tracemalloc.start()  # NumPy tells it of every array it allocates
    refiner.evaluate(V, out)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 10_000 < V.nbytes


def test_refiner():
    V, F = tetrahedron()
    for name in ("loop", "sqrt3", "butterfly"):
        refiner = limn.Refiner(name, F, 3)
        fine, faces = limn.Scheme(name).refine(V, F, 3)
        assert np.array_equal(refiner.evaluate(V), fine)
        assert np.array_equal(refiner.faces, faces)
        assert not refiner.faces.flags.writeable
        out = np.empty_like(fine)
        assert refiner.evaluate(V, out) is out and np.array_equal(out, fine)
        points, normals = refiner.evaluate_limit(V)
        limit = limn.Scheme(name).refine(V, F, 3, limit=True, normals=True)
        assert np.allclose(points, limit.vertices, atol=1e-12)
        assert np.allclose(normals, limit.normals, atol=1e-9)


def test_refiner_of_any_columns():
    V, F = tetrahedron()
    refiner = limn.Refiner("loop", F, 2)
    fine = refiner.evaluate(V)
    colours = np.random.default_rng(1).random((4, 4))
    both = refiner.evaluate(np.hstack([V, colours]))
    assert both.shape == (len(fine), 7)
    assert np.allclose(both[:, :3], fine, atol=1e-15)
    for column in range(4):
        assert np.allclose(refiner.evaluate(colours[:, column]), both[:, 3 + column], atol=1e-15)
    assert np.allclose(refiner.evaluate(np.ones(4)), 1)  # weights sum to 1
    assert refiner.evaluate(colours.astype(np.float32)).dtype == np.float32


def test_refiner_without_a_fast_engine():
    V, F = cube()
    refiner = limn.Refiner("midedge", F, 2)
    fine, faces = limn.Scheme("midedge").refine(V, F, 2)
    assert not refiner.is_fast
    assert np.allclose(refiner.evaluate(V), fine)
    for mine, theirs in zip(refiner.faces, faces):
        assert np.array_equal(mine, theirs)


def test_refiner_refuses():
    V, F = tetrahedron()
    refiner = limn.Refiner("loop", F, 1)
    for values in (V[:3], V.reshape(2, 2, 3), "text", np.zeros((0, 3))):
        with pytest.raises(limn.Error):
            refiner.evaluate(values)
    frozen = np.empty((10, 3))
    frozen.setflags(write=False)
    for out in (np.empty((10, 3), np.float32), np.empty((9, 3)), np.empty((10, 6))[:, ::2], frozen):
        with pytest.raises(limn.MeshError):
            refiner.evaluate(V, out)
    memory = np.empty((14, 3))
    with pytest.raises(limn.MeshError, match="overlaps"):
        refiner.evaluate(memory[:4], memory[2:12])
    for vertices, levels in ((3, 1), (4, -1), (4, 65), (4, 30)):
        with pytest.raises(limn.Error):
            limn.Refiner("loop", F, levels, vertices)


@pytest.mark.parametrize(
    "V, F",
    [
        (np.zeros((4, 2)), tetrahedron()[1]),
        (np.full((4, 3), np.nan), tetrahedron()[1]),
        (np.zeros((4, 3)) + np.inf, tetrahedron()[1]),
        (np.zeros((4, 3), complex), tetrahedron()[1]),
        (np.array([["a", "b", "c"]]), tetrahedron()[1]),
        (np.zeros((3, 3)), tetrahedron()[1]),  # a corner that is no vertex
        (np.zeros((4, 3)), -tetrahedron()[1]),
        (np.zeros((4, 3)), tetrahedron()[1].astype(float)),
        (np.zeros((4, 3)), tetrahedron()[1].astype(np.int64) + 2**40),
        (np.zeros((4, 3)), np.array([[2**64 - 1, 0, 1]], dtype=np.uint64)),
        (np.zeros((4, 3)), np.array([[0, 1]])),
        (np.zeros((4, 3)), np.array([0, 1, 2])),
        (np.zeros((4, 3)), [[0, 1, 2], [0]]),
        (np.zeros((4, 3)), [[0, 1, 2], "abc"]),
        (np.zeros((4, 3)), [[[0, 1, 2]]]),
        (np.zeros((4, 3)), (np.array([0, 1, 2]), np.array([0, 4]))),
        (np.zeros((4, 3)), (np.array([0, 1, 2]), np.array([3, 0]))),
        (np.zeros((4, 3)), (np.array([0, 1, 2]), np.array([], dtype=int))),
        (np.zeros((4, 3)), None),
        (None, tetrahedron()[1]),
        (np.zeros((4, 3)), [[0, 1, 2], [0, 1, 2], [0, 1, 2]]),  # no surface
    ],
)
def test_what_is_no_mesh(V, F):
    for call in (
        lambda: limn.Scheme("loop").refine(V, F, 1),
        lambda: limn.Scheme("loop").limit_points(V, F),
        lambda: limn.fairness(V, F, "loop", levels=1),
        lambda: limn.compare("loop", "sqrt3", mesh=(V, F)),
    ):
        with pytest.raises(limn.MeshError):
            call()


def test_nothing_is_a_mesh():
    for F in (np.zeros((0, 3), int), [], (np.array([], dtype=int), np.array([0]))):
        fine, faces = limn.Scheme("loop").refine(np.zeros((0, 3)), F, 2)
        assert len(fine) == 0 and len(faces) == 0


def test_isolated_vertices_are_a_warning():
    V, F = tetrahedron()
    with pytest.warns(limn.LimnWarning):
        limn.Scheme("loop").refine(np.vstack([V, [[5, 5, 5]]]), F, 1)


def test_too_large():
    V, F = tetrahedron()
    for levels in (15, 30, 64):
        with pytest.raises(limn.Error):
            limn.Scheme("loop").refine(V, F, levels)
    for levels in (-1, 65):
        with pytest.raises(limn.Error):
            limn.Scheme("loop").refine(V, F, levels)


def test_tags_that_are_wrong():
    V, F = cube()
    scheme = limn.Scheme("catmull-clark")
    for tags in (
        {"creases": [[0, 7]]},  # no edge
        {"creases": [[0, 99]]},
        {"creases": [0, 1, 2]},
        {"creases": [[0, 1]], "crease_sharpness": [1, 2]},
        {"creases": [[0, 1]], "crease_sharpness": np.nan},
        {"creases": [[0, 1]], "crease_sharpness": -1},
        {"creases": [[0, 1]], "crease_sharpness": "sharp"},
        {"corners": [-1]},
        {"corners": [[1, 2]]},
        {"holes": [6]},
        {"boundary": "round"},
        {"crease_method": "round"},
        {"crease_angle": np.nan},
        {"engine": "other"},
    ):
        with pytest.raises(limn.Error):
            scheme.refine(V, F, 1, **tags)


def test_holes_are_left_out():
    V, F = cube()
    fine, faces = limn.Scheme("catmull-clark").refine(V, F, 1, holes=[0])
    assert len(faces) == 20


def test_repair():
    V, F = cube()
    soup = V[F].reshape(-1, 3)
    faces = np.arange(24).reshape(-1, 4)
    flipped = faces.copy()
    flipped[2] = flipped[2][::-1]
    mended = limn.repair_mesh(soup, flipped)
    assert len(mended.vertices) == 8 and limn.check_mesh(*mended)["refinable"]
    assert [step["what"] for step in mended.missing["done"]]
    cut = limn.repair_mesh(V, F, triangulate=True)
    assert cut.faces.shape == (12, 3)
    with pytest.raises(limn.Error):
        limn.repair_mesh(V, F, weld=np.nan)
