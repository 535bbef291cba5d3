"""ndsplines: tensor-product splines with compiled loops."""

from __future__ import annotations

import ndsplines
import numpy as np

from contest import Array, Native


def spline(poles: Array) -> Native:
    orders = poles.shape[:-1]
    knots = [np.repeat([0.0, 1.0], order) for order in orders]
    return ndsplines.NDSpline(knots, np.ascontiguousarray(poles), [order - 1 for order in orders])


def lattice(*at: Array) -> Array:
    """Parameters on a grid, as the library wants them."""
    return np.stack(np.meshgrid(*at, indexing="ij"), axis=-1)
