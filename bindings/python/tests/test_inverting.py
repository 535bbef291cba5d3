"""Parameters of points, and all feet: shapes, proofs, refusals."""

import numpy as np
import pytest

import pforms as pf


@pytest.fixture
def volume():
    return pf.Form(
        np.stack(np.meshgrid(*[np.linspace(0, 1, n) for n in (3, 4, 2)], indexing="ij"), -1)
        + np.random.default_rng(5).normal(size=(3, 4, 2, 3)) * 0.03
    )


def test_every_parameter_comes_back(volume):
    rng = np.random.default_rng(1)
    places = rng.random((4, 50, 3))
    points = volume(*np.moveaxis(places, -1, 0))
    found = pf.invert(volume, points)
    assert isinstance(found, pf.Inversion)
    assert found.inside.shape == found.complete.shape == (4, 50)
    assert found.inside.all()
    assert found.complete.all()
    assert found.proved.all()
    np.testing.assert_array_equal(np.diff(found.starts), 1)
    gaps = np.abs(found.parameters - places.reshape(-1, 3)).max(1)
    assert (gaps <= found.errors + 1e-13).all()
    assert found.distances.max() < 1e-14


def test_outside_is_told_and_shapes_stay(volume):
    found = volume.invert([(9.0, 9.0, 9.0)])
    assert found.parameters.shape == (0, 3)
    assert found.starts.tolist() == [0, 0]
    assert not found.inside.any()
    assert found.complete.all()
    none = volume.invert(np.empty((0, 3)))
    assert none.parameters.shape == (0, 3)
    assert none.starts.tolist() == [0]
    one = volume.invert(volume(0.5, 0.5, 0.5))
    assert one.inside.shape == ()


def test_a_collapsed_edge_is_a_doubt():
    triangle = pf.Form([[(0, 0), (0, 1)], [(0, 0), (1, 1)]])
    found = triangle.invert([(0, 0), (0.25, 0.5)])
    assert found.complete.tolist() == [False, True]
    assert found.doubtful.tolist() == [0]
    np.testing.assert_allclose(found.doubts[0, :, 0], [0, 1])


def test_splines_have_their_own_windows():
    curve = pf.Spline([(0, 0), (2, 0), (2, 2), (0, 2)], 1, [0, 0, 1, 2, 3, 3])
    np.testing.assert_array_equal(pf.invert(curve, [(2, 0), (1, 2)]).parameters.T, [[1, 2.5]])


def test_all_feet_of_an_ellipse():
    ellipse = pf.ellipse(2, 1, part="pieces")
    feet = pf.project(ellipse, [(0.3, 0.2, 0), (1.2, 0.9, 0)], all=True)
    assert isinstance(feet, pf.Feet)
    assert np.diff(feet.starts).tolist() == [4, 2]
    assert feet.complete.all()
    assert feet.kinds[:4].count("minimum") == 2
    nearest = ellipse.project([(0.3, 0.2, 0), (1.2, 0.9, 0)])
    for i, distance in enumerate(nearest.distances):
        part = feet.distances[feet.starts[i] : feet.starts[i + 1]]
        np.testing.assert_allclose(part.min(), distance, rtol=1e-13)


def test_the_centre_of_a_circle_is_a_doubt():
    feet = pf.circle(1, part="pieces").project((0, 0, 0), all=True)
    assert not feet.complete
    assert feet.doubts.shape[1:] == (2, 1)


@pytest.mark.parametrize("call", [pf.invert, lambda f, p, **k: pf.project(f, p, all=True, **k)])
def test_bad_input_is_named(volume, call):
    with pytest.raises(pf.ShapeError):
        call(volume, (1, 2))
    with pytest.raises(pf.DomainError):
        call(volume, (1, 2, np.nan))
    with pytest.raises(pf.DomainError):
        call(volume, (1, 2, 3), accuracy=-1)
