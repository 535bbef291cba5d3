"""Interpolation, fitting, immersion and drawing in hosts."""

import numpy as np
import pytest

import pforms as pf
from bernstein import at


@pytest.mark.parametrize("orders", [(1,), (2,), (7,), (3, 4), (2, 3, 3)])
@pytest.mark.parametrize("nodes", ["uniform", "chebyshev", "lobatto"])
def test_passes_through_the_points(rng, orders, nodes):
    net = rng.uniform(-1, 1, (*orders, 3))
    form = pf.interpolate(net, nodes)
    where = {
        "uniform": lambda n: np.linspace(0, 1, n),
        "chebyshev": lambda n: np.sin(np.pi * (2 * np.arange(n) + 1) / (4 * n)) ** 2,
        "lobatto": lambda n: np.sin(np.pi * np.arange(n) / (2 * (n - 1))) ** 2,
    }[nodes]
    lists = [where(n) if n > 1 else [0.5] for n in orders]
    np.testing.assert_allclose(form.grid(*lists), net, atol=1e-12)
    assert not form.is_rational
    assert form == pf.interpolate(pf.Form(net), nodes=nodes)


def test_nodes_may_be_given(rng):
    net = rng.uniform(-1, 1, (3, 4, 2))
    nodes = [[0.1, 0.5, 2], np.array([3.0, 2, 1, 0])]
    np.testing.assert_allclose(pf.interpolate(net, nodes).grid(*nodes), net, atol=1e-11)
    line = rng.uniform(-1, 1, (4, 2))
    for given in (
        [0, 0.1, 0.5, 1],
        (0, 0.1, 0.5, 1),
        np.array([0, 0.1, 0.5, 1]),
        [[0, 0.1, 0.5, 1]],
    ):
        np.testing.assert_allclose(pf.interpolate(line, given)([0, 0.1, 0.5, 1]), line, atol=1e-12)


def test_homogeneous_coordinates_may_be_interpolated(make):
    net = make(4, 3)
    form = pf.interpolate(net.homogeneous, homogeneous=True)
    assert form == pf.interpolate(net, homogeneous=True)
    assert form.is_rational
    np.testing.assert_allclose(form.grid(4, 3), net.poles, rtol=1e-11)
    np.testing.assert_allclose(pf.interpolate(net).grid(4, 3), net.poles, rtol=1e-11)


def test_wrong_nodes_are_refused(rng):
    net = rng.uniform(-1, 1, (3, 2))
    for nodes in ([0, 0, 1], [0, np.nan, 1], [0, 1], "equal", [[0, 1, 2], [0, 1]], 3, [["a"]]):
        with pytest.raises(pf.PformsError, match="nodes: received"):
            pf.interpolate(net, nodes)


def test_a_fit_of_as_many_points_interpolates(rng):
    points = rng.uniform(-1, 1, (5, 3))
    params = [0, 0.2, 0.5, 0.7, 1]
    np.testing.assert_allclose(pf.fit(points, 5, params)(params), points, atol=1e-12)
    grid = rng.uniform(-1, 1, (4, 5, 3))
    fitted = pf.fit(grid, (4, 5), "uniform")
    np.testing.assert_allclose(fitted.grid(4, 5), grid, atol=1e-11)


def test_a_fit_is_the_least_squares_solution():
    t = np.linspace(0, 1, 30)
    points = np.column_stack([t, np.sin(5 * t)])
    report = pf.fit(points, 6, t, report=True)
    matrix = np.array([pf.bernstein(5, i, t) for i in range(6)]).T
    expected = np.linalg.lstsq(matrix, points, rcond=None)[0]
    np.testing.assert_allclose(report.form.poles, expected, atol=1e-11)
    errors = np.linalg.norm(report.form(t) - points, axis=1)
    assert report.max_error == pytest.approx(errors.max())
    assert report.rms_error == pytest.approx(np.sqrt((errors**2).mean()))
    np.testing.assert_array_equal(report.parameters[0], t)
    form, *_ = report
    assert form == pf.fit(points, 6, [t])


def test_a_fit_takes_weights_ends_and_scattered_points(rng):
    points = rng.uniform(-1, 1, (12, 2))
    ends = pf.fit(points, 4, "centripetal", ends=True)
    np.testing.assert_allclose(ends([0, 1]), points[[0, -1]], atol=1e-15)
    heavy = np.ones(12)
    heavy[5] = 1e12
    t = np.linspace(0, 1, 12)
    np.testing.assert_allclose(pf.fit(points, 4, t, weights=heavy)(t[5]), points[5], atol=1e-6)
    u, v = rng.uniform(0, 1, (2, 40))
    surface = pf.Form(rng.uniform(-1, 1, (3, 3, 3)))
    found = pf.fit(surface(u, v), (3, 3), (u, v))
    np.testing.assert_allclose(found.poles, surface.poles, atol=1e-10)


@pytest.mark.parametrize(
    ("call", "error"),
    [
        (lambda: pf.fit([[0, 0], [1, 1]], 3), pf.DegenerateError),
        (lambda: pf.fit([[0, 0], [0, 0]], 2), pf.DegenerateError),
        (lambda: pf.fit([[0, 0], [1, np.nan]], 2), pf.DomainError),
        (lambda: pf.fit([[0, 0], [1, 1]], -2), pf.DomainError),
        (lambda: pf.fit([[0, 0], [1, 1]], 2, weights=[1, -1]), pf.DomainError),
        (lambda: pf.fit([[0, 0], [1, 1]], 2, weights=[1]), pf.ShapeError),
        (lambda: pf.fit([[0, 0], [1, 1]], 2, [0, 0.5, 1]), pf.ShapeError),
        (lambda: pf.fit([0, 1], 2), pf.ShapeError),
        (lambda: pf.fit([], 2), pf.ShapeError),
        (lambda: pf.fit([[0, 0], [1]], 2), pf.ShapeError),
        (lambda: pf.fit([[0, 0], [1, 1]], 2, "best"), pf.DomainError),
        (lambda: pf.fit("points", 2), pf.ArgumentError),
        (lambda: pf.fit([[0, 0], [1, 1]], None), pf.ArgumentError),
    ],
)
def test_what_cannot_be_fitted_is_refused(call, error):
    with pytest.raises(error, match="received .*, expected"):
        call()


@pytest.mark.parametrize(
    ("inner", "host"), [((3,), (2, 3)), ((2, 2), (3, 2)), ((2, 3), (2, 2, 2)), ((3, 2), (4,))]
)
def test_immersion_is_composition(rng, make, inner, host):
    inner = pf.Form(rng.uniform(0, 1, (*inner, len(host))), rng.uniform(0.5, 2, inner))
    host = make(*host)
    drawn = host(inner)
    degree = sum(host.degrees)
    assert drawn.orders == tuple(degree * n + 1 for n in inner.degrees)
    parameters = rng.uniform(0, 1, (inner.axes, 20))
    inside = at(inner.homogeneous, *parameters)
    np.testing.assert_allclose(
        drawn(*parameters), at(host.homogeneous, *inside.T), rtol=1e-9, atol=1e-12
    )
    assert pf.immerse(inner, host) == drawn


def test_lines_in_a_host(make):
    host, t = make(3, 4), np.linspace(0, 1, 5)
    line = pf.segment(host, (0.1, 0.9), (0.5, 0.2))
    np.testing.assert_allclose(line(t), host(0.1 + 0.4 * t, 0.9 - 0.7 * t), rtol=1e-11)
    parts = pf.polyline(host, [(0.1, 0.9), (0.5, 0.2), (1, 1)])
    assert parts[0] == line
    assert [part.kind for part in parts] == ["pL6", "pL6"]
    assert pf.polyline(host, [(0, 0)]) == []
    for call in (
        lambda: pf.segment(host, 0, 1),
        lambda: pf.segment(host, (0, 0, 0), (1, 1)),
        lambda: pf.polyline(host, [(0, 0, 0), (1, 1, 1)]),
        lambda: pf.polyline(host, [0, 1]),
        lambda: pf.polyline(host, [(0, 0), (1,)]),
    ):
        with pytest.raises(pf.ShapeError, match="received"):
            call()


def test_tiles_fill_the_cage(make):
    cage, cell = make(2, 3), pf.Form([(0, 0), (1, 1)])
    tiles = pf.tile([cell], cage, (2, 3))
    assert len(tiles) == 6
    np.testing.assert_allclose(tiles[0](0), cage(0, 0), rtol=1e-12)
    np.testing.assert_allclose(tiles[5](1), cage(1, 1), rtol=1e-12)
    np.testing.assert_allclose(tiles[4](0), cage(0.5, 1 / 3), rtol=1e-12)
    assert pf.tile(iter([cell]), cage, 1)[0] == cage(cell)
    for counts, error in (
        (0, pf.ShapeError),
        (-1, pf.DomainError),
        (10**9, pf.LimitError),
        ((1,), pf.ShapeError),
    ):
        with pytest.raises(error):
            pf.tile([cell], cage, counts)
    with pytest.raises(pf.ShapeError):
        pf.tile([make(2)], cage, 1)


def test_poles_are_mapped_by_anything(make):
    curve, host = pf.Form([(0, 0), (0.5, 1), (1, 0)], [1, 2, 1]), make(3, 3)
    mapped = pf.immerse_points(host, curve)
    np.testing.assert_allclose(mapped.poles, host(*curve.poles.T), rtol=1e-12)
    assert mapped.weights.tolist() == [1, 2, 1]
    assert pf.immerse_points(lambda x, y: [x + y], curve).ambient == 1
    with pytest.raises(ZeroDivisionError):
        pf.immerse_points(lambda x, y: 1 / 0, curve)
    with pytest.raises(pf.ShapeError, match="map: received"):
        pf.immerse_points(lambda x, y: [x] * (1 + (x > 0)), curve)
    for wrong in (lambda x, y: x, lambda x, y: "x", lambda x, y: None, 7):
        with pytest.raises(pf.ShapeError, match="map: received"):
            pf.immerse_points(wrong, curve)
    with pytest.raises(pf.DomainError):
        pf.immerse_points(lambda x, y: (np.nan, 0), curve)
    with pytest.raises(pf.DomainError):
        pf.immerse_points(lambda x, y: (x, y), pf.Form([(0, 0), (1, 1)], [1, 0]))


def test_nodes_may_be_an_array_with_a_row_for_each_axis():
    net = np.arange(18.0).reshape(3, 3, 2) ** 2
    nodes = [[0, 0.25, 1], [0, 0.5, 2]]
    assert pf.interpolate(net, nodes=np.array(nodes)) == pf.interpolate(net, nodes=nodes)


def test_what_would_take_too_long_is_refused(make):
    inner, host = make(30, 30, ambient=2), make(30, 30)
    for call in (
        lambda: pf.immerse(inner, host),
        lambda: host(inner),
        lambda: pf.immerse(inner, host, lazy=True).expand(),
        lambda: pf.tile([make(9, 9, ambient=2)], make(9, 9), 100),
        lambda: pf.interpolate(np.zeros((10**4, 1))),
    ):
        with pytest.raises(pf.LimitError, match="multiplications: refused, the cap is 1e11"):
            call()


@pytest.mark.parametrize(
    ("name", "call"),
    [
        ("params", lambda: pf.fit([(0, 0), (1, 1)], 2, [0, np.nan])),
        ("params", lambda: pf.fit([(0, 0), (1, 1)], 2, [0, 0.5, 1])),
        ("ends", lambda: pf.fit([(0, 0), (1, 1)], 2, ends="x")),
        ("report", lambda: pf.fit([(0, 0), (1, 1)], 2, report="x")),
        ("net", lambda: pf.interpolate([(0, 0), (1, np.nan)])),
        ("homogeneous", lambda: pf.interpolate([(0, 0), (1, 1)], homogeneous="x")),
        ("a", lambda: pf.segment(pf.Form([(0, 0), (1, 1)]), [np.nan], [1])),
        ("b", lambda: pf.segment(pf.Form([(0, 0), (1, 1)]), [0], [np.inf])),
        ("points", lambda: pf.polyline(pf.Form([(0, 0), (1, 1)]), [[0], [np.nan]])),
        ("lazy", lambda: pf.immerse(pf.Form([(0,), (1,)]), pf.Form([(0, 0), (1, 1)]), lazy="x")),
        ("array", lambda: pf.Form.from_homogeneous([(0, np.nan)])),
        ("point", lambda: pf.Form([(0, 0), (1, 1)]).with_pole(0, (np.nan, 0))),
        ("weight", lambda: pf.Form([(0, 0), (1, 1)]).with_pole(0, (0, 0), weight="a")),
        ("weight", lambda: pf.Form([(0, 0), (1, 1)]).with_pole(0, (0, 0), weight=np.nan)),
        ("unit", lambda: pf.Form([(0, 0), (1, 1)]).frame(0.5, unit="x")),
        ("factor", lambda: pf.Form([(0, 0), (1, 1)]) * np.nan),
        ("divisor", lambda: pf.Form([(0, 0), (1, 1)]) / np.nan),
    ],
)
def test_a_wrong_argument_is_named(name, call):
    with pytest.raises(pf.PformsError, match=f"^{name}: received .*, expected"):
        call()
