"""Many forms in one call, and many points without copies."""

import numpy as np
import pytest

import pforms as pf


@pytest.fixture
def several(make):
    return [make(3, 4) for _ in range(5)]


def test_unstack_undoes_stack(several):
    host = pf.stack(*several)
    assert host.unstack() == pf.unstack(host) == several
    assert pf.stack(several) == pf.stack(iter(several)) == host
    assert pf.Form([(1, 2), (3, 4)]).unstack() == [pf.Form((1, 2)), pf.Form((3, 4))]
    with pytest.raises(pf.ShapeError, match="axis"):
        pf.Form((1, 2)).unstack()


def test_many_forms_come_from_one_array(rng):
    poles, weights = rng.uniform(-1, 1, (6, 3, 2, 3)), rng.uniform(0.5, 2, (6, 3, 2))
    forms = pf.Form(poles, weights).unstack()
    assert forms == [pf.Form(p, w) for p, w in zip(poles, weights, strict=True)]


@pytest.mark.parametrize("rational", [False, True])
@pytest.mark.parametrize(
    ("together", "alone"),
    [
        (lambda f: f.elevate((0, 2, 1)), lambda f: f.elevate((2, 1))),
        (
            lambda f: f.stretch((0, 0.2, 0.1), (1, 0.7, -2)),
            lambda f: f.stretch((0.2, 0.1), (0.7, -2)),
        ),
        (lambda f: f.split(1, 0.3)[1], lambda f: f.split(0, 0.3)[1]),
        (lambda f: f.diagonal((1, 2)), lambda f: f.diagonal((0, 1))),
        (lambda f: f.sub(2, 0.25), lambda f: f.sub(1, 0.25)),
        (lambda f: f.reverse(1), lambda f: f.reverse(0)),
    ],
)
def test_operators_act_on_a_stack_as_on_each(make, together, alone, rational):
    several = [make(3, 4, rational=rational) for _ in range(4)]
    assert together(pf.stack(several)).unstack() == [alone(form) for form in several]


def test_a_surface_unpacks_into_its_quarters(make):
    form = make(4, 4)
    quarters = low_low, low_high, high_low, high_high = form.subdivide(1)
    assert quarters == form.subdivide(1)
    assert list(quarters) == quarters.pieces
    for piece, u, v in ((low_low, 0, 0), (low_high, 0, 1), (high_low, 1, 0), (high_high, 1, 1)):
        np.testing.assert_allclose(piece(0.25, 0.5), form(u / 2 + 0.125, v / 2 + 0.25), rtol=1e-12)
    together = pf.stack([form, form]).subdivide((0, 1, 1))
    assert [piece.unstack()[1] for piece in together] == list(quarters)


def layouts(table):
    """The columns of a table of parameters, in many guises."""
    yield tuple(np.ascontiguousarray(column) for column in table.T)
    yield tuple(table.T)
    yield tuple(table[::-1][::-1].T)
    yield tuple(np.asfortranarray(table).T)
    yield tuple(column[:, None][::1, ::-1] for column in table.T)
    yield tuple(np.repeat(column, 3)[::3] for column in table.T)
    yield tuple(column.astype(">f8") for column in table.T)
    yield tuple(column.tolist() for column in table.T)
    unaligned = np.frombuffer(b"\0" + table.tobytes(), np.uint8)[1:].view("f8")
    yield tuple(unaligned.reshape(table.shape).T)
    readonly = table.copy()
    readonly.flags.writeable = False
    yield tuple(readonly.T)


@pytest.mark.parametrize("count", [0, 1, 7, 4096, 9001])
def test_columns_of_a_table_are_parameters(make, rng, count):
    form = make(3, 4)
    table = rng.uniform(0, 1, (count, 2))
    points, normals, slopes = (
        form(*np.ascontiguousarray(table.T)),
        form.normals(*np.ascontiguousarray(table.T)),
        form.evaluate(*np.ascontiguousarray(table.T), derivative=(1, 0)),
    )
    for columns in layouts(table):
        np.testing.assert_array_equal(form(*columns).reshape(points.shape), points)
        np.testing.assert_array_equal(form.normals(*columns).reshape(points.shape), normals)
        np.testing.assert_array_equal(
            form.evaluate(*columns, derivative=(1, 0)).reshape(points.shape), slopes
        )


@pytest.mark.parametrize("shape", [(3, 5, 7), (1, 9, 1), (2, 1, 4), (0, 3)])
def test_tables_have_any_shape(make, rng, shape):
    form = make(2, 3, 2)
    table = rng.uniform(0, 1, (*shape, 3))
    expected = form(*(np.ascontiguousarray(table[..., k]) for k in range(3)))
    assert expected.shape == (*shape, 3)
    columns = [table[..., k] for k in range(3)]
    np.testing.assert_array_equal(form(*columns), expected)
    turned = [np.asfortranarray(column) for column in columns]
    np.testing.assert_array_equal(form(*turned), expected)
    mixed = form(columns[0], 0.25, columns[2])
    np.testing.assert_allclose(mixed, form(columns[0], np.full(shape, 0.25), columns[2]))
    last = rng.uniform(0, 1, shape[-1])
    wide = np.ascontiguousarray(np.broadcast_to(last, shape))
    # Some of these are grids, which are summed in another order.
    np.testing.assert_allclose(form(columns[0], last, 0.5), form(columns[0], wide, 0.5))
    out = np.empty((*shape, 3))
    assert form.evaluate(*columns, out=out) is out
    np.testing.assert_array_equal(out, expected)


@pytest.mark.parametrize(
    ("u", "v"),
    [
        ((5, 70), (70,)),
        ((5, 70), (5, 1)),
        ((3, 5, 70), (5, 1)),
        ((3, 5, 70), (3, 1, 70)),
        ((3, 5, 70), (1, 1, 70)),
        ((3, 1, 70), (1, 5, 70)),
        ((200, 70), (70,)),
        ((0, 70), (70,)),
    ],
)
def test_arrays_repeat_along_the_axes_they_lack(make, rng, u, v):
    form = make(3, 4)
    u, v = rng.uniform(0, 1, u), rng.uniform(0, 1, v)
    U, V = (np.ascontiguousarray(array) for array in np.broadcast_arrays(u, v))
    # Not quite grids: some of the parameters differ from all others.
    np.testing.assert_allclose(form(u, v), form(U, V), rtol=1e-13)
    for given in (np.asfortranarray(u), u[::-1][::-1], np.repeat(u, 2, axis=-1)[..., ::2]):
        np.testing.assert_allclose(form(given, v), form(U, V), rtol=1e-13)
        np.testing.assert_allclose(form(v, given), form(V, U), rtol=1e-13)
    np.testing.assert_array_equal(form(u, V), form(U, V))
    np.testing.assert_array_equal(form(U, v), form(U, V))


def test_parameters_that_are_the_result_are_refused(make):
    table = np.zeros((5, 2))
    with pytest.raises(pf.ShapeError, match="one of the arguments"):
        make(2, 2, ambient=2).evaluate(*table.T, out=table)


def test_not_a_number_is_found_in_any_block(make):
    table = np.zeros((20_000, 2))
    table[17_000, 1] = np.nan
    with pytest.raises(pf.DomainError, match="NaN"):
        make(3, 3)(*table.T)


def test_a_list_of_forms_has_a_grid_for_each(make):
    several = [make(4, 4), make(3, 2), make(4, 4, rational=False), make(4, 4)]
    u, v = np.linspace(0, 1, 5), [0.25, 0.75]
    expected = np.stack([form.grid(u, v) for form in several])
    np.testing.assert_array_equal(pf.grid(several, u, v), expected)
    np.testing.assert_array_equal(pf.grid(tuple(several), 5, v), expected)
    np.testing.assert_array_equal(pf.grid(iter(several), u, v), expected)
    np.testing.assert_array_equal(pf.grid(several[:1], u, v), expected[:1])
    np.testing.assert_array_equal(pf.grid(several[0], u, v), expected[0])
    out = np.empty((2, *expected.shape))
    assert np.shares_memory(pf.grid(several, u, v, out=out[1]), out)
    np.testing.assert_array_equal(out[1], expected)
    assert pf.grid(several, 0, 3).shape == (4, 0, 3, 3)


def test_lists_of_points_and_curves_too(make):
    points = [make(), make()]
    np.testing.assert_array_equal(pf.grid(points), [point() for point in points])
    curves = [make(2, ambient=1), make(7, ambient=1)]
    np.testing.assert_array_equal(pf.grid(curves, 4), [curve.grid(4) for curve in curves])


def test_long_lists_are_cut_without_a_trace(make):
    several = [make(6, 6), make(9, 9)] * 9
    t = np.linspace(0, 1, 500)
    all_ = pf.grid(several, t, t)
    for form, grid in zip(several, all_, strict=True):
        np.testing.assert_array_equal(form.grid(t, t), grid)
    points, normals = pf.grid(several, t, t, normals=True)
    np.testing.assert_array_equal(points, all_)
    np.testing.assert_array_equal(normals[-1], several[-1].normals(t[:, None], t))


@pytest.mark.parametrize(
    ("forms", "said"),
    [
        ([], "forms: received none, expected at least one"),
        (None, "forms: received None, expected a list of forms"),
        ([1], "forms: received an int, expected a pforms.Form"),
        (np.zeros((2, 4, 4, 3)), "forms: received a ndarray, expected a pforms.Form"),
        ([pf.Form(np.zeros((2, 2, 3))), pf.Form(np.zeros((2, 2, 2)))], "forms in 3D and 2D"),
        ([pf.Form(np.zeros((2, 2, 3))), pf.Form(np.zeros((2, 3)))], "parameters: received 2"),
    ],
)
def test_lists_that_do_not_go_together_are_refused(forms, said):
    with pytest.raises(pf.ShapeError, match=said):
        pf.grid(forms, 3, 3)


def test_points_and_normals_come_in_one_pass(make, octant):
    u, v = np.linspace(0, 1, 7), np.linspace(0, 1, 4)
    for form in (make(4, 4), make(2, 5, rational=False), octant):
        points, normals = form.grid(u, v, normals=True)
        np.testing.assert_allclose(points, form.grid(u, v), rtol=1e-13, atol=1e-14)
        np.testing.assert_allclose(normals, form.normals(u[:, None], v), rtol=1e-13, atol=1e-14)
        places = np.empty((7, 4, 3)), np.empty((7, 4, 3))
        one, other = form.grid(u, v, normals=True, out=places)
        assert one is places[0]
        assert other is places[1]
        np.testing.assert_array_equal(one, points)
        np.testing.assert_array_equal(other, normals)
    both = pf.grid([octant, octant], u, v, normals=True)
    np.testing.assert_array_equal(both[1], [normals, normals])
    np.testing.assert_array_equal(octant.grid(u, v, normals=False), points)


@pytest.mark.parametrize(
    "out",
    [
        np.empty((4, 5, 3)),
        (np.empty((4, 5, 3)),),
        (np.empty((4, 5, 3)), np.empty((4, 5, 2))),
        (np.empty((4, 5, 3)), None),
        (np.empty((4, 5, 3)), np.empty((4, 5, 3), "f4")),
        (SAME := np.empty((4, 5, 3)), SAME),
        "out",
    ],
)
def test_places_for_normals_must_fit(make, out):
    with pytest.raises(pf.ShapeError, match="^out: received"):
        make(3, 3).grid(4, 5, normals=True, out=out)


def test_only_surfaces_in_space_have_normals(make):
    for form, counts in (
        (make(3), (4,)),
        (make(3, 3, ambient=2), (4, 4)),
        (make(2, 2, 2), (0, 1, 1)),
    ):
        with pytest.raises(pf.ShapeError, match="a surface in"):
            form.grid(*counts, normals=True)
    with pytest.raises(pf.ArgumentError, match="normals: received an int"):
        make(3, 3).grid(2, 2, normals=7)


def test_a_list_is_immersed_in_one_call(make, rng):
    host = make(3, 4)
    inners = [pf.Form(rng.uniform(0, 1, (n, 2))) for n in (2, 4, 4)]
    inners.append(pf.Form(rng.uniform(0, 1, (2, 3, 2)), rng.uniform(0.5, 2, (2, 3))))
    expected = [pf.immerse(inner, host) for inner in inners]
    assert pf.immerse(inners, host) == pf.immerse(iter(inners), host) == expected
    assert pf.immerse([], host) == []
    assert [lazy.expand() for lazy in pf.immerse(inners, host, lazy=True)] == expected
    assert pf.immerse(inners * 500, host) == expected * 500
    with pytest.raises(pf.ShapeError, match="^inner: received"):
        pf.immerse([*inners, make(2, ambient=3)], host)
    with pytest.raises(pf.ArgumentError, match=r"inner: received an int, expected a pforms\.Form"):
        pf.immerse([*inners, 1], host)
