"""Every operator as a method and as a function: what it promises, and the shapes it refuses."""

import inspect
import re
from itertools import pairwise
from math import comb

import numpy as np
import pytest

import pforms as pf
from bernstein import at, basis, homogeneous_at

OPERATORS = [
    "blossom",
    "curvature",
    "derivative",
    "diagonal",
    "elevate",
    "evaluate",
    "frame",
    "hodograph",
    "normals",
    "reduce",
    "reparametrise",
    "reverse",
    "split",
    "stretch",
    "sub",
    "subdivide",
    "transpose",
    "unstack",
    "whole_line",
    "with_pole",
]


def close(a, b):
    np.testing.assert_allclose(a.homogeneous, b.homogeneous, rtol=1e-12, atol=1e-12)
    assert a.is_rational == b.is_rational


@pytest.mark.parametrize("name", OPERATORS)
def test_every_method_is_a_function(name):
    assert inspect.unwrap(getattr(pf, name)) is getattr(pf.Form, name)


def test_functions_take_the_form_first(make):
    form = make(3, 3)
    assert pf.elevate(form, 1) == form.elevate(1)
    assert pf.diagonal(form) == form.diagonal()
    with pytest.raises(TypeError):
        pf.elevate([(0, 0), (1, 1)], 1)


def test_midpoint_is_a_row_of_the_triangle(make):
    forms = [make(2, 3) for _ in range(4)]
    weighted = sum(comb(3, i) * form.homogeneous for i, form in enumerate(forms)) / 8
    np.testing.assert_allclose(pf.midpoint(*forms).homogeneous, weighted, rtol=1e-14)
    assert pf.midpoint(*forms) == pf.stack(*forms).sub(0, 0.5)


def test_stack_puts_forms_along_a_new_axis(make):
    forms = [make(2, 3) for _ in range(4)]
    stacked = pf.stack(*forms)
    assert stacked.kind == "pV423"
    np.testing.assert_array_equal(stacked.homogeneous, [form.homogeneous for form in forms])
    assert pf.stack(make(2), make(4)).orders == (2, 4)
    assert pf.stack(pf.Form((1, 2))).orders == (1,)


@pytest.mark.parametrize("operator", [pf.stack, pf.midpoint])
def test_forms_that_differ_are_refused(make, operator):
    with pytest.raises(pf.ShapeError, match="forms"):
        operator()
    with pytest.raises(pf.ShapeError):
        operator(make(2), make(2, 2))
    with pytest.raises(pf.ShapeError):
        operator(make(2, ambient=2), make(2, ambient=3))
    with pytest.raises(pf.ArgumentError, match=r"forms: received a tuple, expected a pforms\.Form"):
        operator(make(2), (1, 2, 3))


def test_diagonal_identifies_axes(make):
    form, t = make(2, 3, 4), np.linspace(0, 1, 5)
    s = t[::-1]
    np.testing.assert_allclose(form.diagonal()(s, t), form(s, t, t), rtol=1e-12)
    np.testing.assert_allclose(form.diagonal((0, 2))(t, s), form(t, s, t), rtol=1e-12)
    assert form.diagonal((2, 0)) == form.diagonal((0, 2))
    np.testing.assert_allclose(form.diagonal("all")(t), form(t, t, t), rtol=1e-12)
    assert form.diagonal().orders == (2, 6)
    assert make(2, 2, 2, 2).diagonal("all").kind == "pL5"


@pytest.mark.parametrize("axes", [(0, 0), (0, 2), (0,), (0, 1, 1)])
def test_a_diagonal_needs_two_axes(make, axes):
    with pytest.raises(pf.ShapeError):
        make(2, 2).diagonal(axes)
    with pytest.raises(pf.ShapeError):
        make(2).diagonal()


def test_sub_form_and_split(make):
    form, t = make(3, 4), np.linspace(0, 1, 5)
    np.testing.assert_allclose(form.sub(0, 0.3)(t), form(0.3, t), rtol=1e-12)
    np.testing.assert_allclose(form.sub(1, -0.5)(t), form(t, -0.5), rtol=1e-10)
    low, high = form.split(1, 0.25)
    np.testing.assert_allclose(low(t, t), form(t, t / 4), rtol=1e-12)
    np.testing.assert_allclose(high(t, t), form(t, 0.25 + 0.75 * t), rtol=1e-12)
    np.testing.assert_array_equal(low.homogeneous[:, -1], high.homogeneous[:, 0])
    assert make(2).sub(0, 0).kind == "pP"


def test_elevation_and_reduction(make):
    form = make(3, 4)
    up = form.elevate((1, 2))
    assert up.orders == (4, 6)
    close(form.elevate(1), form.elevate((1, 1)))
    u, v = np.linspace(-0.2, 1.2, 6), np.linspace(0, 1, 6)
    np.testing.assert_allclose(up(u, v), form(u, v), rtol=1e-11)
    down, bound = up.reduce((1, 2))
    close(down, form)
    assert 0 <= bound < 1e-10
    assert form.elevate(0) == form
    bent, bound = make(5, rational=False), None
    rough, bound = bent.reduce(2)
    t = np.linspace(0, 1, 200)
    assert np.linalg.norm(rough(t) - bent(t), axis=-1).max() <= bound


def test_subdivision_gives_the_net_of_the_pieces(make):
    form = make(3, 4)
    assert form.subdivide(2).homogeneous.shape == (9, 13, 4)
    low, high = form.split(0, 0.5)
    net = form.subdivide((1, 0)).homogeneous
    np.testing.assert_allclose(net[:3], low.homogeneous, rtol=1e-14)
    np.testing.assert_allclose(net[2:], high.homogeneous, rtol=1e-14)


def test_stretching(make):
    form = make(3, 4)
    s, t = np.linspace(0, 1, 5), np.linspace(0, 1, 5) ** 2
    window = form.stretch((0.5, 2), (-1, 3))
    np.testing.assert_allclose(window(s, t), form(0.5 - 1.5 * s, 2 + t), rtol=1e-9)
    assert form.stretch(0, 1) == form
    close(form.stretch(1, 0), form.reverse(0).reverse(1))
    np.testing.assert_allclose(form.stretch(0.25, 0.25).poles, np.tile(form(0.25, 0.25), (3, 4, 1)))


def test_relabelling(make):
    form = make(2, 3, 4)
    np.testing.assert_array_equal(form.reverse(1).homogeneous, form.homogeneous[:, ::-1])
    np.testing.assert_array_equal(
        form.transpose((2, 0, 1)).homogeneous, form.homogeneous.transpose(2, 0, 1, 3)
    )
    assert form.transpose().orders == (4, 3, 2)
    assert form.transpose().transpose() == form


def test_projective_parameters(make):
    form, s = make(4), np.linspace(0, 1, 7)
    for c in (0.5, 3):
        np.testing.assert_allclose(
            form.reparametrise(0, c)(s), form(c * s / ((1 - s) + c * s)), rtol=1e-12
        )
    with pytest.raises(pf.DegenerateError):
        form.reparametrise(0, 0)
    quarter = pf.Form([(1, 0), (1, 1), (0, 1)], [1, 1, 2])
    circle = np.concatenate([part(s) for part in quarter.whole_line(0)])
    np.testing.assert_allclose(np.hypot(*circle.T), 1, rtol=1e-14)
    angles = np.unwrap(np.arctan2(circle[:, 1], circle[:, 0]))
    assert np.ptp(angles) == pytest.approx(2 * np.pi)


@pytest.mark.parametrize("rational", [False, True])
def test_derivatives_are_forms(make, rational):
    form, h = make(4, 3, rational=rational), 1e-6
    u, v = np.linspace(0.1, 0.9, 5), np.linspace(0.2, 0.8, 5)
    slope = (form(u + h, v) - form(u - h, v)) / (2 * h)
    np.testing.assert_allclose(form.hodograph(0)(u, v), slope, rtol=1e-6, atol=1e-7)
    assert form.derivative((0, 0)) == form
    assert form.derivative((1, 0)) == form.hodograph(0)
    assert make(4, 3, rational=False).derivative((1, 1)).orders == (3, 2)


def test_blossom(make):
    curve = make(4)
    t = 0.3
    np.testing.assert_allclose(curve.blossom([t] * 3), homogeneous_at(curve.homogeneous, t))
    np.testing.assert_allclose(curve.blossom([0, 0, 1]), curve.homogeneous[1])
    np.testing.assert_allclose(curve.blossom([1, 2, 3]), curve.blossom([3, 1, 2]))
    surface = make(2, 3)
    np.testing.assert_allclose(surface.blossom([1], [0, 1]), surface.homogeneous[1, 1])
    assert pf.Form((1, 2)).blossom().tolist() == [1, 2, 1]


def test_tables():
    np.testing.assert_array_equal(pf.partition(-1, 1, 3), np.linspace(-1, 1, 9))
    t = np.linspace(-1, 2, 7).reshape(7, 1)
    for i in range(6):
        np.testing.assert_allclose(
            pf.bernstein(5, i, t), basis(6, t)[..., i], rtol=1e-12, atol=1e-14
        )
    assert pf.bernstein(5, 2, t).shape == (7, 1)
    assert pf.bernstein(5, 2, 0.5).shape == ()
    for n in (0, 1, 7, 70, 300):
        assert pf.pascal(n) == [comb(n, k) for k in range(n + 1)]


def test_explains_any_operator():
    assert "q2 = (p02 + 4·p11 + p20)/6" in pf.explain("DIAG", "pS33").splitlines()
    assert pf.explain("diagonal", "pS22") == pf.explain("DIAG", "pS22")
    assert pf.explain("MI", "pP", "pP") == "q = (a + b)/2"
    assert "q1 = (p0 + 2·p1)/3" in pf.explain("ELEVATE", "pL3", 1).splitlines()
    with pytest.raises(pf.DomainError, match='^operator: received "NOSUCH", expected the name'):
        pf.explain("NOSUCH", "pS33")
    with pytest.raises(pf.DomainError, match=r'"DIAGO", .* \(did you mean DIAG\?\)'):
        pf.explain("DIAGO", "pS33")
    assert pf.explain("SUB", "pL3", 0, 1 / 3) == "q = (4·p0 + 4·p1 + p2)/9"
    with pytest.raises(pf.PformsError):
        pf.explain("DIAG", "banana")


@pytest.mark.parametrize("axis", [-1, 2, 99, 0.5, 10**30])
def test_an_axis_that_is_not_there_is_refused(make, axis):
    form = make(3, 3)
    for call in (
        lambda: form.sub(axis, 0.5),
        lambda: form.split(axis, 0.5),
        lambda: form.reverse(axis),
        lambda: form.hodograph(axis),
        lambda: form.reparametrise(axis, 2),
        lambda: form.whole_line(axis),
    ):
        with pytest.raises(pf.ShapeError, match="axis: received .*, expected 0 to 1 for a pS33"):
            call()


@pytest.mark.parametrize("name", ["elevate", "reduce", "subdivide"])
def test_counts_per_axis(make, name):
    operator = getattr(make(3, 3), name)
    operator(1), operator((1, 0)), operator(np.array([0, 1])), operator([np.int8(1), 1.0])
    for wrong in (-1, 0.5, (1, -1), np.nan):
        with pytest.raises(pf.DomainError, match="received .*, expected"):
            operator(wrong)
    for wrong in ((1,), (1, 1, 1), [[1, 1]], ()):
        with pytest.raises(pf.ShapeError, match="received .*, expected"):
            operator(wrong)
    for wrong in (None, "1", object(), {}, 1j, [None]):
        with pytest.raises(pf.PformsError, match="received"):
            operator(wrong)


def test_what_is_too_large_is_refused_before_it_is_made(make):
    form = make(3, 3)
    for call in (
        lambda: form.elevate(10**6),
        lambda: form.grid(10**6, 10**6),
        lambda: form(np.broadcast_to(0.5, (10**6, 1)), np.broadcast_to(0.5, 10**6)),
        lambda: form.derivative((10**9, 1)),
        lambda: form.evaluate(0, 0, derivative=(10**5, 10**5)),
        lambda: pf.immerse(make(99, 99, 99, ambient=3), make(99, 99, 99)),
    ):
        with pytest.raises(pf.LimitError, match=r"refused, the cap is"):
            call()
    for call in (lambda: form.subdivide(60), lambda: pf.partition(0, 1, 60)):
        with pytest.raises(pf.PformsError):
            call()


@pytest.mark.parametrize("number", [10**20, 1e30, 10**300, float("inf")])
def test_a_number_beyond_all_memory_is_named(make, number):
    form = make(3, 3)
    for name, call in {
        "by": lambda: form.elevate(number),
        "r": lambda: form.subdivide((1, number)),
        "parameters": lambda: form.grid(2, np.float64(number)),
        "n": lambda: pf.pascal(number),
        "counts": lambda: pf.tile(make(2, ambient=2), form, number),
    }.items():
        received = re.escape(f"{name}: received {number:.0e}".replace("+", ""))
        with pytest.raises(pf.LimitError, match=f"^{received}, expected at most"):
            call()
    with pytest.raises(pf.LimitError, match="^r: received 1e10, expected at most"):
        form.subdivide(10**10)


def test_pieces_join(make):
    pieces = make(3).subdivide(3).pieces
    for left, right in pairwise(pieces):
        np.testing.assert_array_equal(left.homogeneous[-1], right.homogeneous[0])


def test_points_agree_after_every_operator(make, rng):
    form = make(3, 3)
    u, v = rng.uniform(0, 1, (2, 20))
    for same in (form.elevate(2), form.stretch(0, 1), form.transpose().transpose()):
        np.testing.assert_allclose(same(u, v), at(form.homogeneous, u, v), rtol=1e-12)


def test_the_cap_can_be_changed(make):
    form, before = make(3), pf.cap()
    try:
        pf.set_cap(10**4)
        assert pf.cap() == 10**4
        with pytest.raises(pf.LimitError, match="the cap is 10 kB"):
            form.grid(1000)
        pf.set_cap(10**5)
        assert form.grid(1000).shape == (1000, 3)
        for wrong in (0, -1, 0.5):
            with pytest.raises(pf.DomainError, match="bytes: received"):
                pf.set_cap(wrong)
    finally:
        pf.set_cap(before)


def test_splines_are_immersed_across_knots() -> None:
    host = pf.Spline(
        np.random.default_rng(5).random((4, 5, 3)),
        (2, 3),
        [[0, 0, 0, 0.4, 1, 1, 1], [0] * 4 + [0.3] + [1] * 4],
    )
    inner = pf.Form([(0, 0), (0.2, 1), (1, 1)])
    curve = host(inner)
    assert isinstance(curve, pf.Spline)
    assert curve == pf.immerse(inner, host)
    assert curve.degrees == (10,)
    assert len(curve) == 3
    for t in np.linspace(0, 1, 41):
        # Degree 10 over poles below 1: some hundred roundings.
        assert abs(curve(t) - host(*inner(t))).max() < 1e-13
    joined = pf.Spline([(0, 0), (1, 1), (0, 1)], 1, [0, 0, 0.5, 1, 1])
    surface = pf.Form([[(0, 0), (0, 1)], [(1, 0), (1, 2)]])
    assert surface(joined).breaks[0].tolist() == [0, 0.5, 1]
    assert surface(joined)(0.75).tolist() == surface(*joined(0.75)).tolist()
