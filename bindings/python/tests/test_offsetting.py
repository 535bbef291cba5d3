"""Parallels, shells, developable surfaces and unrolling."""

import numpy as np
import pytest

import pforms as pf

CUBIC = pf.Form([(0, 0), (1, 2), (3, -2), (4, 1)])
SADDLE = pf.Form([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 1)]])
TWISTED = pf.Form([(0, 0, 0), (1, 0, 0), (2, 1, 0), (3, 3, 1)])


def test_the_reported_error_holds():
    t = np.linspace(0, 1, 201)
    frame = CUBIC.frame(t)
    left = np.stack([-frame.tangent[:, 1], frame.tangent[:, 0]], axis=-1)
    for tolerance in (1e-3, 1e-7):
        found = CUBIC.parallel(0.15, tolerance=tolerance, report=True)
        gaps = np.linalg.norm(found.spline(t) - frame.point - 0.15 * left, axis=-1)
        assert gaps.max() <= found.error <= tolerance
        assert found.gap == 0


def test_every_shape_goes_through_the_same_door():
    whole = pf.parallel(CUBIC, 0.1)
    assert isinstance(whole, pf.Spline)
    assert isinstance(pf.parallel(CUBIC.subdivide(1), 0.1), pf.Spline)
    assert isinstance(pf.parallel([(0, 0), (1, 0)], 0.1), pf.Spline)
    assert isinstance(pf.offset_poles(CUBIC, 0.1), pf.Form)
    assert isinstance(CUBIC.subdivide(1).offset_poles(0.1), pf.Spline)
    assert isinstance(TWISTED.subdivide(1).tangent_developable(), pf.Spline)
    assert TWISTED.subdivide(1).tangent_developable().is_developable()
    assert SADDLE.subdivide(1).unroll(report=True).area > 0


def test_a_distance_may_be_a_form():
    wedge = pf.parallel([(0, 0), (4, 3)], pf.Form([(0,), (5,)]))
    np.testing.assert_allclose(wedge([0, 1]), [(0, 0), (1, 7)], atol=1e-12)


def test_a_curve_in_space_states_its_side():
    with pytest.raises(pf.ShapeError, match=r"^side: "):
        TWISTED.parallel(0.1)
    assert TWISTED.parallel(0.1, side="principal").net.axes == 1
    assert TWISTED.parallel(0.1, side=(0, 0, 1)).net.axes == 1


def test_folds_are_refused_unless_accepted():
    with pytest.raises(pf.DegenerateError, match="radius of curvature at parameters"):
        CUBIC.parallel(3)
    assert CUBIC.parallel(3, folds=True, report=True).error <= 1e-6


def test_an_unrolled_developable_keeps_its_lengths():
    surface = TWISTED.tangent_developable(0.5)
    flat = surface.unroll()
    ends = np.array([(0.2, 0.3), (0.9, 0.3)])
    in_space = np.linalg.norm(np.diff(surface(*ends.T), axis=0))
    np.testing.assert_allclose(np.linalg.norm(np.diff(flat(*ends.T), axis=0)), in_space, rtol=1e-10)


@pytest.mark.parametrize(
    ("call", "error", "argument"),
    [
        (lambda: CUBIC.parallel("far"), pf.ArgumentError, "distance"),
        (lambda: CUBIC.parallel(0.1, tolerance=-1), pf.DomainError, "tolerance"),
        (lambda: CUBIC.parallel(0.1, tolerance=1e-20), pf.AccuracyError, "tolerance"),
        (lambda: CUBIC.parallel(np.nan), pf.DomainError, "distance"),
        (lambda: CUBIC.parallel(0.1, folds="x"), pf.ArgumentError, "folds"),
        (lambda: TWISTED.parallel(0.1, side=(1, 0)), pf.ShapeError, "side"),
        (lambda: TWISTED.parallel(0.1, side="left"), pf.DomainError, "side"),
        (lambda: CUBIC.shell(0), pf.DegenerateError, "distance"),
        (lambda: CUBIC.is_developable(), pf.ShapeError, "form"),
        (lambda: SADDLE.unroll(accuracy=0), pf.DomainError, "accuracy"),
        (lambda: pf.tangent_developable(SADDLE), pf.ShapeError, "curve"),
        (lambda: pf.tangent_developable([(0, 0), (1, 1)]), pf.DegenerateError, "curve"),
        (lambda: pf.tangent_developable(TWISTED, np.inf), pf.DomainError, "length"),
    ],
)
def test_what_cannot_be_is_refused_by_name(call, error, argument):
    with pytest.raises(error, match=f"^{argument}: "):
        call()
