"""SciPy: B-splines without interior knots are Bézier forms."""

from __future__ import annotations

import numpy as np
from scipy.interpolate import BSpline, NdBSpline

from contest import Array


def knots(order: int) -> Array:
    return np.repeat([0.0, 1.0], order)


def along(poles: Array, axis: int, at: Array, derivative: int = 0) -> Array:
    """Evaluates one axis, the others being left as they are."""
    order = poles.shape[axis]
    curve = BSpline(knots(order), poles, order - 1, axis=axis)
    return np.asarray(curve(at, nu=derivative))


def spline(poles: Array) -> NdBSpline:
    """A spline in as many parameters as there are axes."""
    orders = poles.shape[:-1]
    degrees = tuple(order - 1 for order in orders)
    return NdBSpline(tuple(map(knots, orders)), poles, degrees)
