"""Cages: shapes of answers, what follows, refusals."""

import numpy as np
import pytest

import pforms as pf


@pytest.fixture
def cage():
    rng = np.random.default_rng(1)
    lattice = np.stack(np.meshgrid(*[np.arange(4.0)] * 3, indexing="ij"), axis=-1)
    points = lattice + rng.uniform(-0.1, 0.1, lattice.shape)
    return pf.Form(points, rng.uniform(0.8, 1.2, (4, 4, 4)))


def test_shapes_follow_the_points(cage):
    places = np.random.default_rng(2).random((5, 2, 3))
    points = cage(*np.moveaxis(places, -1, 0))
    found = pf.embed(points, cage)
    assert isinstance(found, pf.Embedding)
    assert len(found) == 10
    np.testing.assert_allclose(found.parameters, places, atol=1e-13)
    np.testing.assert_array_equal(found.points, points)
    assert found.inside.shape == found.residual.shape == found.counts.shape == (5, 2)
    assert found.complete.all()
    assert found.inside.all()
    assert not found.extended.any()
    assert found.residual.max() < 1e-13
    np.testing.assert_allclose(found.at(cage), points, atol=1e-13)
    alone = pf.embed(points[3, 1], cage)
    np.testing.assert_array_equal(alone.parameters, found.parameters[3, 1])
    assert pf.embed(np.empty((0, 3)), cage).parameters.shape == (0, 3)
    out = np.empty((5, 2, 3))
    assert found.at(cage, out=out) is out


def test_many_points_are_found_in_slices(cage):
    places = np.random.default_rng(3).random((100_000, 3))
    points = cage(*places.T)
    found = pf.embed(points, cage)
    assert np.abs(found.parameters - places).max() < 1e-13
    assert (found.counts == 1).all()


def test_points_outside(cage):
    beyond = np.array([(-5.0, 1.0, 1.0), (1.5, 1.5, 1.5)])
    found = pf.embed(beyond, cage)
    assert found.inside.tolist() == [False, True]
    moved = pf.Form(cage.poles + 1.0, cage.weights)
    np.testing.assert_array_equal(found.at(moved)[0], beyond[0])
    near = cage(-0.05, 0.5, 0.5)
    extended = pf.embed(near, cage, outside="extend")
    assert extended.extended
    assert not extended.inside
    np.testing.assert_allclose(extended.at(moved), near + 1.0, atol=1e-12)
    with pytest.raises(pf.DomainError, match="outside the cage"):
        pf.embed(beyond, cage, outside="error")


def test_sensitivities_are_differences(cage):
    points = cage(*np.random.default_rng(4).random((3, 20)))
    found = pf.embed(points, cage)
    matrix = found.sensitivities(cage)
    assert matrix.shape == (20, 64)
    poles = cage.poles.copy()
    poles[1, 2, 3, 0] += 1.0
    moved = found.at(pf.Form(poles, cage.weights)) - found.at(cage)
    column = 16 + 8 + 3
    np.testing.assert_allclose(matrix.toarray()[:, column], moved[:, 0], atol=1e-13)
    assert (found.jacobians(cage) > 0).all()


def test_everything_follows():
    box = [(0, 0, 0), (1, 1, 1)]
    lattice = np.stack(np.meshgrid(*[np.arange(2.0)] * 3, indexing="ij"), axis=-1)
    bent = pf.Form(2 * lattice)
    segment = pf.Form([(0, 0, 0), (1, 1, 1)])
    assert pf.deform(segment, bent, rest=box)(1.0).tolist() == [2.0, 2.0, 2.0]
    assert segment.deform(bent)(0.5).tolist() == [1.0, 1.0, 1.0]
    assert isinstance(pf.deform(segment.subdivide(1), bent), pf.Spline)
    lazy = pf.immerse(pf.Form([[0.0], [1.0]]), segment, lazy=True)
    assert pf.deform(lazy, bent)(1.0).tolist() == [2.0, 2.0, 2.0]
    both = pf.deform([segment, segment], bent)
    assert [type(one) for one in both] == [pf.Form, pf.Form]
    mesh = pf.tessellate(pf.Form([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]]), segments=2)
    moved = pf.deform(mesh, bent, rest=box)
    np.testing.assert_allclose(moved.vertices, 2 * mesh.vertices)
    np.testing.assert_array_equal(moved.triangles, mesh.triangles)
    cloud = pf.deform(np.array([(0.5, 0.5, 0.5), (3, 3, 3)]), bent)
    assert cloud.tolist() == [[1.0, 1.0, 1.0], [3.0, 3.0, 3.0]]


@pytest.mark.parametrize(
    ("call", "error"),
    [
        (lambda cage: pf.embed([(0.0, 0.0)], cage), pf.ShapeError),
        (lambda cage: pf.embed([(np.nan, 0.0, 0.0)], cage), pf.DomainError),
        (lambda cage: pf.embed([(0.0, 0.0, 0.0)], cage, outside="lose"), pf.DomainError),
        (lambda cage: pf.embed([(0.0, 0.0, 0.0)], cage, accuracy=2), pf.DomainError),
        (lambda cage: pf.embed("points", cage), pf.ArgumentError),
        (lambda cage: pf.embed([0.0], pf.Form([(0, 0, 0), (1, 1, 1)])), pf.ShapeError),
        (lambda cage: pf.deform(pf.Form([(0, 0, 0), (1, 1, 1)]), cage, rest=cage), pf.DomainError),
        (lambda cage: pf.deform("form", cage), pf.ArgumentError),
        (lambda cage: pf.deform([(0, 0, 0)], cage, rest=[(0, 0), (1, 1)]), pf.ShapeError),
    ],
)
def test_refusals(cage, call, error):
    with pytest.raises(error):
        call(cage)
