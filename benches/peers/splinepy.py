"""splinepy: C++. The first parameter runs fastest in its arrays."""

from __future__ import annotations

import numpy as np
import splinepy

from bernstein import Net
from contest import Array, Native


def form(net: Net) -> Native:
    degrees = [order - 1 for order in net.orders]
    points = fastest_first(net.points, len(degrees)).reshape(-1, net.points.shape[-1])
    if net.weights is None:
        return splinepy.Bezier(degrees=degrees, control_points=points)
    weights = fastest_first(net.weights, len(degrees)).reshape(-1, 1)
    return splinepy.RationalBezier(degrees=degrees, control_points=points, weights=weights)


def poles(form: Native) -> Array:
    """Homogeneous poles of a form, the last parameter running fastest."""
    orders = tuple(int(degree) + 1 for degree in form.degrees)
    points = np.asarray(form.control_points)
    if "weights" in form.required_properties:
        weights = np.asarray(form.weights).reshape(-1, 1)
        points = np.concatenate([points * weights, weights], axis=1)
    return fastest_first(points.reshape(*orders[::-1], -1), len(orders))


def fastest_first(array: Array, axes: int) -> Array:
    """Reverses the first axes."""
    order = (*reversed(range(axes)), *range(axes, array.ndim))
    return np.ascontiguousarray(np.transpose(array, order))
