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


def test_parameters_that_are_the_result_are_refused(make):
    table = np.zeros((5, 2))
    with pytest.raises(pf.ShapeError, match="one of the arguments"):
        make(2, 2, ambient=2).evaluate(*table.T, out=table)


def test_not_a_number_is_found_in_any_block(make):
    table = np.zeros((20_000, 2))
    table[17_000, 1] = np.nan
    with pytest.raises(pf.DomainError, match="NaN"):
        make(3, 3)(*table.T)
