"""Nearest points: shapes, proofs, refusals."""

import numpy as np
import pytest

import pforms as pf


@pytest.fixture
def saddle(make):
    return make(4, 4)


def test_shapes_follow_the_points(saddle):
    rng = np.random.default_rng(1)
    points = rng.normal(size=(5, 2, 3))
    found = pf.project(saddle, points)
    assert isinstance(found, pf.Projection)
    assert found.parameters.shape == (5, 2, 2)
    assert found.points.shape == (5, 2, 3)
    assert found.distances.shape == found.gaps.shape == found.unique.shape == (5, 2)
    assert found.unique.dtype == bool
    one = saddle.project(points[3, 1])
    for all_of_them, alone in zip(found, one, strict=True):
        np.testing.assert_array_equal(all_of_them[3, 1], alone)
    none = saddle.project(np.empty((0, 3)))
    assert none.parameters.shape == (0, 2)
    assert none.distances.shape == (0,)


def test_feet_are_points_of_the_form_and_nothing_is_nearer(saddle):
    points = np.random.default_rng(2).normal(size=(300, 3)) * 2
    found = saddle.project(points)
    u, v = found.parameters.T
    np.testing.assert_array_equal(saddle(u, v), found.points)
    np.testing.assert_allclose(np.linalg.norm(points - found.points, axis=1), found.distances)
    samples = saddle.grid(60, 60).reshape(-1, 3)
    nearest = np.linalg.norm(points[:, None] - samples, axis=-1).min(1)
    assert (found.distances - found.gaps <= nearest).all()
    assert found.gaps.max() < 1e-11


def test_arrays_of_any_layout_and_type(saddle):
    points = np.arange(24, dtype=np.float32).reshape(3, 8).T
    found = saddle.project(points)
    np.testing.assert_array_equal(found.distances, saddle.project(points.tolist()).distances)
    assert saddle.project(pf.Form((0.0, 0.0, 0.0))).distances.shape == ()


def test_accuracy_says_what_counts_as_the_same():
    ends = pf.Form([(-1, 0), (0, 1), (1, 0)])
    off = (1e-6, -3)
    assert ends.project(off).unique
    assert not ends.project(off, accuracy=1e-3).unique


@pytest.mark.parametrize(
    ("points", "error"),
    [
        ((0.0, 0.0), pf.ShapeError),
        (1.0, pf.ShapeError),
        ((0.0, 0.0, np.nan), pf.DomainError),
        ((0.0, 0.0, np.inf), pf.DomainError),
        ("abc", pf.ArgumentError),
        (None, pf.ArgumentError),
    ],
)
def test_what_are_no_points(saddle, points, error):
    with pytest.raises(error, match="points"):
        saddle.project(points)


@pytest.mark.parametrize("accuracy", [-1, 2, np.nan])
def test_accuracies_out_of_range(saddle, accuracy):
    with pytest.raises(pf.DomainError, match="accuracy"):
        saddle.project((0, 0, 0), accuracy=accuracy)


def test_a_weight_that_vanishes_is_named():
    through_infinity = pf.Form([(0, 0), (1, 0)], weights=[1, -1])
    with pytest.raises(pf.DomainError, match="weight"):
        through_infinity.project((0, 1))
