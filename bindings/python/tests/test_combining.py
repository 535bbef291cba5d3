"""Sums of points, products with functions, regular nets, extrusions, ruled forms."""

import numpy as np
import pytest

import pforms as pf

ARC = pf.Form([(1, 0), (1, 1), (0, 1)], [1, 1, 2])
LINE = pf.Form([(0, 0), (2, 2)])
KNOTTED = pf.Spline([(0, 0), (0, 2), (2, 2), (2, 0)], 2, [0, 0, 0, 0.5, 1, 1, 1])
T = np.linspace(0, 1, 7)
NEAR = {"rtol": 0, "atol": 4e-15}


@pytest.mark.parametrize("first", [ARC, LINE, KNOTTED])
@pytest.mark.parametrize("second", [ARC, LINE, KNOTTED])
def test_points_are_combined_whatever_the_weights(first, second):
    both = pf.combine([2, -0.5], first, second, pointwise=True)
    np.testing.assert_allclose(both(T), 2 * first(T) - 0.5 * second(T), **NEAR)
    across = pf.symmetric(first, second, pointwise=True)
    np.testing.assert_allclose(across(T), 2 * first(T) - second(T), **NEAR)


def test_weights_that_agree_are_counted_once():
    twin = 3 * ARC.translate((1, 1))
    assert pf.combine([0.5, 0.5], ARC, twin, pointwise=True).orders == (3,)
    assert pf.combine([0.5, 0.5], [ARC, LINE], pointwise=True).orders == (4,)


def test_a_function_multiplies_a_form():
    bump = pf.Form([(0,), (1,), (0,)])
    np.testing.assert_allclose((bump * ARC)(T), bump(T) * ARC(T), **NEAR)
    assert bump * ARC == ARC * bump
    with pytest.raises(TypeError):
        ARC * LINE


def test_extrusions_add():
    sheet = ARC.extrude(LINE)
    u, v = np.meshgrid(T, T, indexing="ij")
    np.testing.assert_allclose(sheet(u, v), LINE(u) + ARC(v), **NEAR)
    assert LINE.extrude((0, 1)) == LINE.extrude(pf.Form([(0, 0), (0, 1)]))
    spline = KNOTTED.extrude((3, 4))
    assert isinstance(spline, pf.Spline)
    np.testing.assert_allclose(spline(1, 0.3), KNOTTED(0.3) + np.array([3, 4]), **NEAR)


def test_ruled_forms_join():
    strip = pf.ruled(KNOTTED, LINE)
    np.testing.assert_allclose(strip(0.5, 0.3), (KNOTTED(0.3) + LINE(0.3)) / 2, **NEAR)
    assert ARC.ruled((5, 5))(1, 0.2).tolist() == [5, 5]


def test_regular_nets_are_centred():
    for net in (pf.line(4, 3), pf.facet((3, 2), (1, 2)), pf.cube(3, 5), pf.cube((2,) * 5)):
        assert not net(*[0.5] * net.axes).any()
    assert pf.cube((2,) * 5).ambient == 5


@pytest.mark.parametrize(
    "wrong",
    [
        lambda: pf.combine([1], ARC, LINE, pointwise=True),
        lambda: pf.combine([1, 1], ARC, pf.facet()),
        lambda: pf.symmetric(ARC, pf.line()),
        lambda: ARC.extrude((1, 2, 3)),
        lambda: ARC.extrude("up"),
        lambda: ARC.ruled(pf.line()),
        lambda: pf.facet((2, 2, 2)),
        lambda: pf.cube((2, 2), (1, 2, 3)),
        lambda: pf.cube(2, ambient=2),
        lambda: pf.line(0),
    ],
)
def test_what_does_not_fit_is_a_shape_error(wrong):
    with pytest.raises(pf.ShapeError):
        wrong()


def test_what_grows_too_large_is_refused():
    with pytest.raises(pf.LimitError):
        pf.cube(2000)
    wide = [pf.facet(30).with_pole((0, i), (0, 0, 0), weight=2) for i in range(30)]
    with pytest.raises(pf.LimitError):
        pf.combine([1] * 30, wide, pointwise=True)
    assert pf.combine([1] * 30, wide[:1] * 30, pointwise=True).orders == (30, 30)
