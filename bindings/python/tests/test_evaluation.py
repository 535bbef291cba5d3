"""Points and derivatives against the definition in NumPy; broadcasting; arrays of the caller's."""

from functools import partial

import numpy as np
import pytest

import pforms as pf
from bernstein import at

ORDERS = [(), (1,), (4,), (8,), (3, 4), (2, 3, 2), (2, 3, 2, 3)]


@pytest.mark.parametrize("orders", ORDERS)
@pytest.mark.parametrize("rational", [False, True])
@pytest.mark.parametrize("ambient", [1, 2, 3, 4])
def test_agrees_with_the_definition(make, rng, orders, rational, ambient):
    form = make(*orders, ambient=ambient, rational=rational)
    parameters = rng.uniform(0, 1, (len(orders), 5))
    expected = at(form.homogeneous, *parameters)
    np.testing.assert_allclose(form(*parameters), expected, rtol=1e-12, atol=1e-13)
    one = [float(list_[0]) for list_ in parameters]
    np.testing.assert_allclose(form(*one), at(form.homogeneous, *one), rtol=1e-12, atol=1e-13)
    assert form(*one).shape == (ambient,)


@pytest.mark.parametrize("orders", ORDERS)
def test_grids_agree_with_points(make, rng, orders):
    form = make(*orders)
    lists = [rng.uniform(-0.2, 1.2, 3 + axis) for axis in range(len(orders))]
    grid = form.grid(*lists)
    assert grid.shape == (*map(len, lists), 3)
    mesh = np.meshgrid(*lists, indexing="ij")
    np.testing.assert_allclose(grid, form(*mesh), rtol=1e-12, atol=1e-13)
    np.testing.assert_array_equal(form(*np.meshgrid(*lists, indexing="ij", sparse=True)), grid)


def test_counts_are_equal_steps_over_the_window(make):
    form = make(3, 3)
    np.testing.assert_array_equal(form.grid(5, 3), form.grid(np.linspace(0, 1, 5), [0, 0.5, 1]))
    assert form.grid(1, 2).shape == (1, 2, 3)
    assert form.grid(0, 2).shape == (0, 2, 3)
    assert form.grid([], [0.5]).shape == (0, 1, 3)
    assert form.grid(np.int64(3), np.uint8(2)).shape == (3, 2, 3)
    np.testing.assert_array_equal(form.grid(1, 1)[0, 0], form(0, 0))


@pytest.mark.parametrize(
    ("u", "v"),
    [
        ((), ()),
        ((), (5,)),
        ((5,), ()),
        ((4, 1), (1, 3)),
        ((4, 1), (3,)),
        ((3,), (4, 1)),
        ((1, 3), (4, 1)),
        ((2, 3), (3,)),
        ((3,), (2, 3)),
        ((2, 1, 3), (4, 1)),
        ((2, 3, 1, 1), (4, 5)),
        ((0,), ()),
        ((0, 1), (1, 4)),
        ((1,), (1,)),
        ((1, 1), (3, 2)),
    ],
)
def test_parameters_broadcast_as_in_numpy(make, rng, u, v):
    form = make(3, 4)
    u, v = rng.uniform(0, 1, u), rng.uniform(0, 1, v)
    U, V = np.broadcast_arrays(u, v)
    points = form(u, v)
    assert points.shape == (*U.shape, 3)
    np.testing.assert_allclose(points, at(form.homogeneous, U, V), rtol=1e-12)
    np.testing.assert_allclose(form.evaluate(u, v, derivative=(1, 0)).shape, points.shape)


def test_three_parameters_broadcast(make, rng):
    form = make(2, 3, 2)
    u, v, w = rng.uniform(0, 1, (4, 1, 1)), rng.uniform(0, 1, 5), rng.uniform(0, 1, (5, 1))
    U, V, W = np.broadcast_arrays(u, v, w)
    np.testing.assert_allclose(form(u, v, w), at(form.homogeneous, U, V, W), rtol=1e-12)
    np.testing.assert_array_equal(form(u, w, v), form.grid(u.ravel(), w.ravel(), v))


def test_takes_parameters_of_any_layout_and_type(make, rng):
    form = make(3, 3)
    u = rng.uniform(0, 1, (6, 4))
    expected = form(np.ascontiguousarray(u[::2, ::-1]), 0.5)
    np.testing.assert_array_equal(form(u[::2, ::-1], 0.5), expected)
    np.testing.assert_array_equal(form(u.T[::-1, ::2].T, 0.5), expected)
    np.testing.assert_array_equal(form(u[::2, ::-1].tolist(), 0.5), expected)
    np.testing.assert_array_equal(form(np.array([0, 1]), True), form([0.0, 1.0], 1.0))


@pytest.mark.parametrize("orders", [(1,), (0,), (2,), (7,)])
def test_derivatives_of_a_curve_are_those_of_its_hodographs(make, orders):
    curve = make(5)
    t = np.linspace(-0.1, 1.1, 7)
    derived = curve.evaluate(t, derivative=orders)
    np.testing.assert_allclose(derived, curve.derivative(orders)(t), rtol=1e-9, atol=1e-9)
    np.testing.assert_array_equal(curve.evaluate(t, derivative=orders[0]), derived)


def test_derivatives_agree_with_differences(make):
    form, h = make(4, 3), 1e-5
    u, v = np.linspace(0.2, 0.8, 4)[:, None], np.linspace(0.2, 0.8, 3)
    along = (form(u + h, v) - form(u - h, v)) / (2 * h)
    np.testing.assert_allclose(form.evaluate(u, v, derivative=(1, 0)), along, rtol=1e-6, atol=1e-7)
    mixed = (
        form.evaluate(u, v + h, derivative=(1, 0)) - form.evaluate(u, v - h, derivative=(1, 0))
    ) / (2 * h)
    np.testing.assert_allclose(form.evaluate(u, v, derivative=(1, 1)), mixed, rtol=1e-6, atol=1e-6)


def test_writes_into_the_array_given(make):
    form = make(3, 3)
    u, v = np.linspace(0, 1, 4)[:, None], np.linspace(0, 1, 5)
    for compute in (form.evaluate, form.normals):
        out = np.full((4, 5, 3), np.nan)
        assert compute(u, v, out=out) is out
        np.testing.assert_array_equal(out, compute(u, v))
    out = np.empty((4, 5, 3))
    assert form.grid(4, v, out=out) is out
    np.testing.assert_array_equal(out, form.grid(4, 5))
    large = np.zeros((2, 4, 5, 3))
    form.grid(4, 5, out=large[1])
    np.testing.assert_array_equal(large[1], out)
    assert not large[0].any()


@pytest.mark.parametrize(
    "out",
    [
        np.empty((4, 5, 2)),
        np.empty((20, 3)),
        np.empty((4, 5, 3), "f4"),
        np.empty((4, 5, 3), ">f8"),
        np.empty((4, 5, 3), order="F"),
        np.empty((4, 10, 3))[:, ::2],
        [[0.0]],
        "out",
    ],
)
def test_an_array_that_does_not_fit_is_refused(make, out):
    with pytest.raises(pf.ShapeError, match=r"^out: received .*, expected a C-contiguous float64"):
        make(3, 3).grid(4, 5, out=out)


def test_a_read_only_or_shared_array_is_refused(make):
    out = np.empty((4, 3))
    out.flags.writeable = False
    with pytest.raises(pf.ShapeError, match="out: received a read-only array"):
        make(3).grid(4, out=out)
    line = np.linspace(0, 1, 4)
    with pytest.raises(pf.ShapeError, match="one of the arguments"):
        make(3, ambient=1).evaluate(line, out=line[:, None])


def test_a_failure_is_said_where_the_weight_vanishes():
    form = pf.Form([(0, 0), (1, 1)], weights=[1, -1])
    with pytest.raises(pf.DomainError, match="weight vanishes"):
        form([0, 0.5, 1])
    with pytest.raises(pf.DomainError, match="weight vanishes"):
        form.grid(3)


def test_pieces_are_the_form(make, rng):
    form = make(3, 4)
    pieces = form.subdivide((2, 1))
    u, v = rng.uniform(-0.1, 1.1, (2, 50))
    np.testing.assert_allclose(pieces(u, v), form(u, v), rtol=1e-10, atol=1e-12)
    assert pieces.counts == (4, 2)
    assert len(pieces) == len(pieces.pieces) == 8
    assert pieces.homogeneous.shape == (9, 7, 4)
    assert [list_.tolist() for list_ in pieces.breaks] == [[0, 0.25, 0.5, 0.75, 1], [0, 0.5, 1]]
    local = pieces.pieces[3]
    np.testing.assert_allclose(local(0.5, 0.5), form(0.375, 0.75), rtol=1e-12)
    assert pieces == form.subdivide((2, 1)) != form.subdivide(1)
    assert (pieces.axes, pieces.ambient, pieces.degrees) == (2, 3, (2, 3))


def test_lazy_immersion_is_the_immersion(make, rng):
    inner, host = pf.Form(rng.uniform(0, 1, (3, 2))), make(3, 4)
    lazy = pf.immerse(inner, host, lazy=True)
    drawn = pf.immerse(inner, host)
    t = np.linspace(0, 1, 9)
    np.testing.assert_allclose(lazy(t), drawn(t), rtol=1e-12)
    np.testing.assert_allclose(
        lazy.evaluate(t, derivative=2), drawn.evaluate(t, derivative=2), rtol=1e-9
    )
    assert lazy.expand() == drawn == host(inner)
    assert lazy.forecast() == {"orders": drawn.orders, "poles": 11, "bytes": 352}
    assert (lazy.host, lazy.inner, lazy.kind, lazy.axes, lazy.ambient) == (
        host,
        inner,
        "ipL3",
        1,
        3,
    )


def test_slices_are_the_whole(make, rng):
    form, same = make(9, 9), partial(np.testing.assert_allclose, rtol=1e-10, atol=1e-14)
    u, v = rng.uniform(0, 1, (2, 200_000))
    some = slice(None, None, 9973)
    same(form(u, v)[some], form(u[some], v[some]))
    same(form.normals(u, v)[some], form.normals(u[some], v[some]))
    for call in (form.evaluate, form.normals):
        for rows, columns in ((1, 200_000), (200_000, 1), (500, 400), (3, 70_001)):
            s, t = u[:rows, None], v[:columns]
            whole = call(s, t)
            part = slice(None, None, max(1, columns // 7))
            same(whole[::101, part], call(s[::101], t[part]))
