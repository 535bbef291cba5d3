"""What a form is made of, and how Python sees it."""

import copy
import gc
import pickle

import numpy as np
import pytest

import pforms as pf


@pytest.mark.parametrize(
    ("orders", "kind"),
    [
        ((), "pP"),
        ((4,), "pL4"),
        ((12,), "pL12"),
        ((3, 4), "pS34"),
        ((2, 2, 2), "pV222"),
        ((2, 2, 2, 2), "pH2222"),
        ((2,) * 5, "pF[2,2,2,2,2]"),
        ((12, 3), "pS[12,3]"),
    ],
)
@pytest.mark.parametrize("ambient", [1, 2, 3, 5])
def test_says_what_it_is(make, orders, kind, ambient):
    form = make(*orders, ambient=ambient, rational=False)
    assert form.orders == orders
    assert form.degrees == tuple(order - 1 for order in orders)
    assert form.axes == len(orders)
    assert form.ambient == ambient
    assert form.kind == kind
    assert not form.is_rational
    assert repr(form) == f"<pforms.Form {kind} in {ambient}D>"
    assert form.poles.shape == (*orders, ambient)
    assert form.weights.shape == orders
    assert form.homogeneous.shape == (*orders, ambient + 1)


def test_gives_back_its_poles_and_weights(rng):
    poles, weights = rng.normal(size=(3, 4, 2)), rng.uniform(1, 2, (3, 4))
    form = pf.Form(poles, weights)
    assert form.is_rational
    assert repr(form) == "<pforms.Form pS34 in 2D, rational>"
    np.testing.assert_array_equal(form.weights, weights)
    np.testing.assert_allclose(form.poles, poles, rtol=1e-15)
    np.testing.assert_array_equal(form.homogeneous[..., :2], poles * weights[..., None])
    np.testing.assert_array_equal(form.homogeneous[..., 2], weights)


def test_a_weight_of_zero_makes_a_direction():
    half = pf.Form([(1, 0), (0, 1), (-1, 0)], weights=[1, 0, 1])
    assert half.homogeneous.tolist() == [[1, 0, 1], [0, 1, 0], [-1, 0, 1]]
    assert half.poles[1].tolist() == [0, 1]
    assert pf.Form(half.poles, half.weights) == half
    np.testing.assert_allclose(np.hypot(*half(np.linspace(0, 1, 9)).T), 1)


def test_negative_weights_are_kept():
    form = pf.Form([(1, 0), (0, 1)], weights=[-1, 2])
    assert form.homogeneous.tolist() == [[-1, 0, -1], [0, 2, 2]]


def test_takes_any_layout_and_type():
    poles = np.arange(24.0).reshape(2, 4, 3)
    form = pf.Form(poles)
    assert pf.Form(poles.tolist()) == form
    assert pf.Form(np.asfortranarray(poles)) == form
    assert pf.Form(np.repeat(poles, 2, axis=1)[:, ::2]) == form
    for kind in ("f4", "i2", "u8", ">f8", "O", "g"):
        assert pf.Form(poles.astype(kind)) == form
    unaligned = np.frombuffer(b"\0" + poles.tobytes(), np.uint8)[1:].view("f8").reshape(2, 4, 3)
    assert pf.Form(unaligned) == form
    assert pf.Form(poles[::-1, :, ::-1]).poles.tolist() == poles[::-1, :, ::-1].tolist()


def test_homogeneous_poles_are_lent_not_copied(make):
    form = make(3, 4)
    first, second = form.homogeneous, form.homogeneous
    assert first is not second
    assert np.shares_memory(first, second)
    expected = first.copy()
    # The array keeps the numbers alive after the form is gone.
    del form, second
    gc.collect()
    np.testing.assert_array_equal(first, expected)
    net = pf.Form(first[..., :3]).subdivide(1)
    assert np.shares_memory(net.homogeneous, net.net.homogeneous)


def test_nothing_outside_can_change_it():
    poles = np.zeros((2, 2))
    form = pf.Form(poles)
    poles[:] = 7
    form.poles[:] = 8
    form.weights[:] = 9
    with pytest.raises(ValueError, match="read-only"):
        form.homogeneous[:] = 9
    with pytest.raises(ValueError, match="WRITEABLE"):
        form.homogeneous.flags.writeable = True
    assert form == pf.Form([(0, 0), (0, 0)])
    with pytest.raises(AttributeError):
        form.poles = poles
    with pytest.raises(AttributeError):
        form.colour = "red"


def test_is_equal_to_the_same_poles_and_nothing_else(make):
    form = make(3, 2)
    twin = pf.Form.from_homogeneous(form.homogeneous)
    assert form == twin
    assert hash(form) == hash(twin)
    assert form != form.reverse(0)
    assert form != form.homogeneous.tolist()
    assert form != None  # noqa: E711
    assert len({form, twin, form.reverse(0)}) == 2
    assert pf.Form((0.0, 1)) == pf.Form((-0.0, 1))
    assert hash(pf.Form((0.0, 1))) == hash(pf.Form((-0.0, 1)))


@pytest.mark.parametrize("orders", [(), (3,), (2, 3, 2)])
@pytest.mark.parametrize("protocol", range(pickle.HIGHEST_PROTOCOL + 1))
def test_survives_pickling_to_the_bit(make, orders, protocol):
    form = make(*orders)
    assert pickle.loads(pickle.dumps(form, protocol)) == form


def test_a_copy_is_itself(make):
    form = make(2, 2)
    assert copy.copy(form) is form
    assert copy.deepcopy([form])[0] is form


def test_pieces_and_lazy_forms_survive_pickling(make):
    pieces = make(3, 3).subdivide((1, 2))
    assert pickle.loads(pickle.dumps(pieces)) == pieces
    lazy = pf.immerse(make(3, ambient=2), make(3, 3), lazy=True)
    assert pickle.loads(pickle.dumps(lazy)) == lazy


def test_a_pole_is_moved(make):
    form = make(3, 4)
    moved = form.with_pole((1, 2), (7, 8, 9))
    assert moved.weights.tolist() == form.weights.tolist()
    np.testing.assert_allclose(moved.poles[1, 2], (7, 8, 9), rtol=1e-15)
    others = [net.homogeneous.reshape(12, 4)[np.arange(12) != 6] for net in (moved, form)]
    np.testing.assert_array_equal(*others)
    assert form.with_pole((0, 0), (1, 2, 3), weight=0).homogeneous[0, 0].tolist() == [1, 2, 3, 0]
    assert make(5).with_pole(4, (1, 1, 1)).kind == "pL5"
    assert pf.Form((1, 2)).with_pole((), (3, 4)) == pf.Form((3, 4))


def test_a_form_equals_no_other_thing(make):
    for thing in (make(3), make(3, 3).subdivide(1), pf.Immersed(make(3, ambient=2), make(3, 3))):
        assert (thing == 1) is False
        assert (thing != None) is True  # noqa: E711


def test_what_a_mask_hides_is_not_used():
    points = np.ma.masked_array([(0.0, 0), (1, 1)], [(False, False), (True, False)])
    with pytest.raises(pf.ArgumentError, match="poles: .* none of which is masked"):
        pf.Form(points)
    assert pf.Form(points[:1]).kind == "pL1"


def test_a_weight_that_is_no_number_is_named():
    with pytest.raises(pf.DomainError, match="^weights: received NaN"):
        pf.Form([(0, 0), (1, 1)], [1, np.nan])
