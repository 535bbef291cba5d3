"""Splines used as forms: the same questions get the same answers, piece by piece or whole."""

import copy
import pickle

import numpy as np
import pytest

import pforms as pf


@pytest.fixture
def whole(make):
    """A rational curve in space."""
    return make(5)


@pytest.fixture
def pieces(whole):
    """The same in four pieces, counted from 10 to 14."""
    return whole.subdivide(2).on_window(0, 10, 14)


T = np.array([0.0, 0.1, 0.25, 0.6, 0.99, 1.0])


def test_points_and_derivatives_broadcast(whole, pieces, make):
    there = 10 + 4 * T
    np.testing.assert_allclose(pieces(there), whole(T), rtol=0, atol=1e-13)
    np.testing.assert_allclose(pieces(there.reshape(2, 3)), whole(T.reshape(2, 3)), atol=1e-13)
    slopes = pieces.evaluate(there, derivative=2)
    np.testing.assert_allclose(16 * slopes, whole.evaluate(T, derivative=2), rtol=1e-11, atol=1e-9)
    surface = make(3, 4)
    patches = surface.subdivide((1, 2))
    u, v = T[:, None], T[::-1]
    np.testing.assert_allclose(patches(u, v), surface(u, v), atol=1e-13)
    np.testing.assert_allclose(patches.grid(5, 7), surface.grid(5, 7), atol=1e-13)
    out = np.empty((6, 6, 3))
    assert patches.evaluate(u, v, out=out) is out
    points, normals = patches.grid(5, 7, normals=True)
    _, expected = surface.grid(5, 7, normals=True)
    np.testing.assert_allclose(normals, expected, atol=1e-12)
    np.testing.assert_allclose(pf.grid(patches, 5, 7), points)
    with pytest.raises(pf.ShapeError):
        patches(0.5)
    with pytest.raises(pf.DomainError):
        patches(0.5, np.nan)


def test_many_points_are_quick_and_right(pieces):
    t = np.random.default_rng(1).uniform(9, 15, 20_000)
    one_by_one = np.array([pieces(x) for x in t[:100]])
    np.testing.assert_allclose(pieces(t)[:100], one_by_one, rtol=1e-13, atol=1e-13)
    inside = np.sort(t[(t > 10) & (t < 14)])
    np.testing.assert_array_equal(pieces(inside[::-1])[::-1], pieces(inside))


def test_operators_answer_for_both(whole, pieces):
    there = 10 + 4 * T
    assert pf.elevate(pieces, 2).kind == pf.elevate(whole, 2).kind
    np.testing.assert_allclose(pf.reverse(pieces, 0)(there), whole(1 - T), atol=1e-13)
    np.testing.assert_allclose(pf.stretch(pieces, 14, 10)(T), whole(1 - T), atol=1e-13)
    np.testing.assert_allclose(4 * pf.hodograph(pieces)(12.5), whole.hodograph()(0.625), rtol=1e-11)
    low, high = pf.split(pieces, 0, 11.5)
    assert low.window == ((10, 11.5),)
    assert high.counts == (3,)
    assert isinstance(pf.sub(pieces, 0, 12), pf.Form)
    moved = pieces.with_pole(4, (1, 2, 3), weight=2)
    np.testing.assert_allclose(moved.poles[4], (1, 2, 3))
    with pytest.raises(TypeError):
        pf.elevate(3, 1)


def test_arithmetic_is_on_common_knots(whole, pieces):
    form = whole.subdivide(0).on_window(0, 10, 14)
    total = pieces + form
    np.testing.assert_allclose(total(12.3), pieces(12.3), atol=1e-13)
    np.testing.assert_allclose(total.weights[0], 2 * pieces.weights[0])
    half = (3 * pieces - pieces) / 2
    np.testing.assert_allclose(half.homogeneous, pieces.homogeneous, atol=1e-14)
    up = pf.Form.from_homogeneous((0, 0, 1, 0))
    negative = -pieces
    np.testing.assert_allclose((up - negative)(12), (up + pieces)(12), atol=1e-13)
    with pytest.raises(pf.ShapeError, match="window"):
        pieces + whole
    with pytest.raises(TypeError):
        pieces + 3
    assert pf.stack(pieces, pieces).counts == (1, 4)
    np.testing.assert_allclose(pf.midpoint(pieces, form)(11), pieces(11), atol=1e-13)


def test_frames_and_feet(whole, pieces):
    there = 10 + 4 * T
    for kind in ("frenet", "rotation-minimising"):
        a, b = whole.frame(T, kind=kind), pieces.frame(there, kind=kind)
        np.testing.assert_allclose(a.normal, b.normal, atol=1e-8)
        np.testing.assert_allclose(a.speed, 4 * b.speed, rtol=1e-11)
    np.testing.assert_allclose(pieces.curvature(there), whole.curvature(T), rtol=1e-8)
    points = np.random.default_rng(2).uniform(-3, 3, (5, 4, 3))
    a, b = whole.project(points), pieces.project(points)
    assert b.parameters.shape == (5, 4, 1)
    np.testing.assert_allclose(a.distances, b.distances, atol=1e-12)
    with pytest.raises(pf.ShapeError):
        pieces.project([1, 2])


def test_one_mesh_of_all_pieces(make):
    surface = make(4, 4, rational=False)
    mesh = pf.tessellate(surface.subdivide(1), tolerance=0.01)
    corners = mesh.vertices[mesh.triangles]
    sides = {}
    for i, j in ((0, 1), (1, 2), (2, 0)):
        for side in zip(
            map(bytes, corners[:, i] + 0.0), map(bytes, corners[:, j] + 0.0), strict=True
        ):
            key = tuple(sorted(side))
            sides[key] = sides.get(key, 0) + 1
    assert set(sides.values()) == {1, 2}
    line = pf.tessellate(make(5).subdivide(3), segments=4)
    assert len(line.vertices) == 8 * 4 + 1
    listed = pf.tessellate([surface, surface.subdivide(1)], segments=2)
    assert [len(mesh.triangles) for mesh in listed] == [8, 32]


def test_copies_files_and_pickles_are_the_same(pieces, tmp_path):
    assert copy.copy(pieces) is copy.deepcopy(pieces) is pieces
    assert pickle.loads(pickle.dumps(pieces)) == pieces
    path = tmp_path / "both.json"
    pf.save([pieces, pieces.net], path)
    assert pf.load(path) == [pieces, pieces.net]
    pieces.save(tmp_path / "one.json")
    assert pf.load(tmp_path / "one.json") == pieces
    pf.draw(pieces, tmp_path / "spline.glb")
    assert (tmp_path / "spline.glb").read_bytes()[:4] == b"glTF"


def test_forms_end_to_end_and_back(make):
    a, b = make(4).split(0, 0.25)
    whole = pf.Spline.end_to_end([a, b], [0, 0.25, 1])
    assert [piece.kind for piece in whole] == ["pL4", "pL4"]
    assert whole.orders == (7,)
    less, error = whole.remove_knot(0, 0.25)
    assert less.orders == (6,)
    assert error < 1e-13
    again = pf.Spline.from_homogeneous(whole.homogeneous, whole.degrees, whole.knots)
    assert again == whole
    assert whole.bezier() == whole
    with pytest.raises(pf.ShapeError):
        pf.Spline.end_to_end([a, b], [0, 1])
    with pytest.raises(pf.DomainError):
        pf.Spline.end_to_end([a, b], [0, 0, 1])
