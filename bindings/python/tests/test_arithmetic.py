"""Homogeneous combinations: a + b, 2*a - b, a/2."""

import operator
from fractions import Fraction

import numpy as np
import pytest

import pforms as pf


def test_combines_homogeneous_poles(make):
    a, b = make(3, 4), make(3, 4)
    np.testing.assert_array_equal((a + b).homogeneous, a.homogeneous + b.homogeneous)
    np.testing.assert_array_equal((2 * a - b).homogeneous, 2 * a.homogeneous - b.homogeneous)
    np.testing.assert_array_equal((a / 3).homogeneous, a.homogeneous / 3)
    np.testing.assert_array_equal((-a).homogeneous, -a.homogeneous)
    assert +a is a
    assert (a + b) / 2 == pf.combine([0.5, 0.5], [a, b])


@pytest.mark.parametrize("two", [2, 2.0, np.float64(2), np.int32(2), np.array(2.0), Fraction(2)])
def test_any_number_is_a_factor(make, two):
    form = make(2, 2)
    assert two * form == form * two == form + form
    assert form / two == form * 0.5


def test_raises_orders_and_spreads_points(make):
    curve, longer, point = make(2), make(4), make()
    assert (curve + longer).orders == (4,)
    np.testing.assert_allclose(
        (curve + longer).homogeneous, curve.elevate(2).homogeneous + longer.homogeneous
    )
    np.testing.assert_allclose((longer - point).homogeneous, longer.homogeneous - point.homogeneous)


@pytest.mark.parametrize("other", [1, 1.5, "a", None, [1, 2], np.ones(3), object()])
def test_a_sum_needs_two_forms(make, other):
    form = make(2)
    for compute in (operator.add, operator.sub):
        with pytest.raises(TypeError):
            compute(form, other)
        with pytest.raises(TypeError):
            compute(other, form)


@pytest.mark.parametrize("other", ["a", None, [1, 2], np.ones(3), object(), 1j])
def test_a_product_needs_a_number(make, other):
    form = make(2)
    for a, b in ((form, other), (other, form)):
        with pytest.raises(TypeError):
            a * b
    with pytest.raises(TypeError):
        form / other
    with pytest.raises(TypeError):
        form * form


def test_numbers_without_sense_are_refused(make):
    form = make(2)
    with pytest.raises(pf.DomainError, match="divisor: received 0"):
        form / 0
    for number in (np.nan, np.inf):
        with pytest.raises(pf.DomainError):
            form * number
    with pytest.raises(pf.ShapeError, match="one for each form"):
        pf.combine([1], [form, form])
    with pytest.raises(pf.ShapeError):
        form + make(2, ambient=2)
    with pytest.raises(pf.ShapeError):
        form + make(2, 2)
