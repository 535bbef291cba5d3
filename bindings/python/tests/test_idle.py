"""What is given and has no part in what the other arguments ask for is refused by name."""

import pytest

import pforms as pf

POINTS = [(0, 0), (1, 1), (2, 0), (3, 1)]
TANGENTS = [(1, 0), (0, 1)]
CURVE = pf.Form(POINTS)
FACET = pf.Form([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 1)]])
CAGE = pf.facet(2, 1.0, ambient=2)


@pytest.mark.parametrize(
    ("call", "name"),
    [
        (lambda: pf.interpolating_spline(POINTS, tangents=TANGENTS), "tangents"),
        (lambda: pf.interpolating_spline(POINTS, circle=True), "circle"),
        (lambda: pf.interpolating_spline(POINTS, 2, ends="periodic"), "ends"),
        (lambda: pf.interpolating_spline(POINTS, 2, params="uniform"), "params"),
        (
            lambda: pf.interpolating_spline(POINTS, start=[(0, 1), (1, 2)], tangents=TANGENTS),
            "tangents",
        ),
        (lambda: pf.revolve([(1, 0), (2, 1)], order=4), "order"),
        (lambda: CURVE.revolve(order=4), "order"),
        (lambda: pf.iterate(CURVE, 2, ratio=0.3), "ratio"),
        (lambda: pf.continuity(CURVE, at=((0, 1), (0, 0))), "at"),
        (lambda: pf.continuity(CURVE, CURVE, axis=0), "axis"),
        (lambda: FACET.frame(0, 0, kind="tangent"), "kind"),
        (lambda: pf.centroid(pf.Form([(0, 0, 0), (1, 1, 1)]), filled=True), "filled"),
        (lambda: pf.deform(pf.Form([(0, 0), (1, 1)]), CAGE, outside="error"), "outside"),
    ],
)
def test_it_is_named(call, name):
    with pytest.raises(pf.PformsError, match=f"^{name}: received .*, expected "):
        call()


def test_false_asks_for_nothing():
    assert pf.interpolating_spline(POINTS, circle=False) == pf.interpolating_spline(POINTS)
