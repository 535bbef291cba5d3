"""Splines from poles and points, joints, lengths: what the golden cases do not say."""

import numpy as np
import pytest

import pforms as pf

CIRCLE = pf.Form([(1, 0), (1, 1), (0, 1)], weights=[1, 1, 2])


def test_knots_for_each_axis(rng):
    net = rng.uniform(-1, 1, (4, 5, 3))
    surface = pf.bspline(net, (2, 3), ("clamped", [0, 0, 0, 0, 1, 2, 2, 2, 2]))
    assert surface.degrees == (2, 3)
    np.testing.assert_allclose(surface(0, 0), net[0, 0])
    np.testing.assert_allclose(surface(2, 2), net[-1, -1])
    tube = pf.bspline(net, (2, 3), closed=(True, False))
    np.testing.assert_allclose(tube(0, 0.5), tube(4, 0.5), atol=1e-15)
    assert pf.bspline(pf.Form(net[0]), 3) == pf.bspline(net[0])


def test_a_nurbs_from_its_pieces(rng):
    knots = [0, 0, 0, 0.3, 0.3, 0.7, 1, 1, 1]
    spline = pf.nurbs(rng.uniform(-1, 1, (6, 2)), rng.uniform(0.5, 2, 6), knots)
    again = pf.concatenate(spline.pieces, breaks=spline.breaks[0]).remove_knots(0.7)
    np.testing.assert_allclose(again.homogeneous, spline.homogeneous, atol=1e-14)
    assert again.knots[0].tolist() == spline.knots[0].tolist()


@pytest.mark.parametrize("ends", ["natural", "not-a-knot", "periodic"])
@pytest.mark.parametrize("params", ["chord", "uniform", "centripetal"])
def test_passes_through_the_points(rng, ends, params):
    points = rng.uniform(-1, 1, (7, 3))
    spline = pf.interpolating_spline(points, ends=ends, params=params)
    np.testing.assert_allclose(spline(spline.breaks[0][:7]), points, atol=1e-14)
    for _, joint in spline.continuity():
        assert joint.parametric == 2


def test_a_net_is_interpolated(rng):
    net = rng.uniform(-1, 1, (5, 4, 3))
    surface = pf.interpolating_spline(net, ends=("natural", "not-a-knot"), params="uniform")
    u, v = np.meshgrid(np.linspace(0, 1, 5), np.linspace(0, 1, 4), indexing="ij")
    np.testing.assert_allclose(surface(u, v), net, atol=1e-13)


def test_lengths_there_and_back():
    total, error = CIRCLE.arc_length(report=True)
    assert abs(total - np.pi / 2) <= error
    lengths = np.linspace(0, total, 12).reshape(3, 4)
    parameters = CIRCLE.parameter_at_length(lengths)
    assert parameters.shape == (3, 4)
    there = CIRCLE(parameters)
    np.testing.assert_allclose(np.arctan2(there[..., 1], there[..., 0]), lengths, atol=1e-14)
    assert CIRCLE.arc_length(0.25, 0.25) == 0
    assert CIRCLE.arc_length(0.75, 0.25) == CIRCLE.arc_length(0.25, 0.75)


def test_unit_speed():
    even = CIRCLE.by_arc_length(accuracy=1e-12)
    s = np.linspace(0, np.pi / 2, 50)
    np.testing.assert_allclose(even(s), np.stack([np.cos(s), np.sin(s)], -1), atol=1e-12)


def test_ends_that_meet(rng):
    low, high = pf.Form(rng.uniform(-1, 1, (4, 3, 3))).split(1, 0.25)
    for at in [((1, 1), (1, 0)), [[1, 1], [1, 0]], (1, 1, 1, 0)]:
        joint = pf.continuity(low, high, at=at, accuracy=1e-9)
        assert (joint.parametric, joint.geometric) == (0, 2)
        assert joint.gaps.shape == joint.geometric_gaps.shape == (3,)
    moved = pf.join(low, high, 1, kind="parametric", at=((1, 1), (1, 0)))
    assert pf.continuity(moved.f, moved.g, at=((1, 1), (1, 0))).parametric >= 1


@pytest.mark.parametrize(
    ("call", "error"),
    [
        (lambda: pf.bspline([(0, 0), (1, 1)], 1, "round"), pf.DomainError),
        (lambda: pf.bspline([(0, 0), (1, 1)], 1, closed="yes"), pf.ArgumentError),
        (lambda: pf.bspline([(0, 0), (1, 1)], 1, closed=[True, True]), pf.ShapeError),
        (lambda: pf.nurbs([(0, 0), (1, 1)], [1], [0, 0, 1, 1]), pf.ShapeError),
        (lambda: pf.interpolating_spline([(0, 0), (1, 1)], 4), pf.DomainError),
        (lambda: pf.interpolating_spline([(0, 0), (1, 1)], ends="clamped"), pf.ShapeError),
        (lambda: pf.interpolating_spline([(0, 0), (1, 1)], start=(0, 0)), pf.ShapeError),
        (lambda: pf.continuity("a line", CIRCLE), pf.ArgumentError),
        (lambda: pf.continuity(CIRCLE, CIRCLE, at=(2, 0)), pf.DomainError),
        (lambda: pf.join_forms(CIRCLE, CIRCLE, moving=(1, 2, 3)), pf.ShapeError),
        (lambda: pf.arc_length(CIRCLE, accuracy=float("nan")), pf.DomainError),
        (lambda: pf.parameter_at_length(CIRCLE, 9), pf.DomainError),
        (lambda: pf.insert_knots(CIRCLE, 0.5, axis=1), pf.ShapeError),
        (lambda: pf.remove_knots(pf.bspline([(0, 0), (1, 1), (2, 0)], 1), 1), pf.AccuracyError),
    ],
)
def test_what_goes_wrong_is_named(call, error):
    with pytest.raises(error):
        call()
