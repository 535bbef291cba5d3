"""The Bernstein basis in NumPy, as a person would write it: the yardstick of the peers."""

from __future__ import annotations

from math import comb

import numpy as np

from contest import Array


def values(order: int, at: Array) -> Array:
    """Matrix of the Bernstein polynomials of an order, one row per parameter."""
    degree = order - 1
    rows = [comb(degree, i) * at**i * (1 - at) ** (degree - i) for i in range(order)]
    return np.stack(rows, axis=-1)


def elevation(order: int, by: int) -> Array:
    """Matrix that raises a form of an order by some degrees."""
    degree = order - 1
    matrix = np.zeros((order + by, order))
    for j in range(order + by):
        for i in range(max(0, j - by), min(degree, j) + 1):
            matrix[j, i] = comb(degree, i) * comb(by, j - i) / comb(degree + by, j)
    return matrix


def diagonal(poles: Array) -> Array:
    """Poles of the curve `u = v` of a surface with homogeneous poles."""
    n, m, width = poles.shape
    curve = np.zeros((n + m - 1, width))
    for i in range(n):
        for j in range(m):
            share = comb(n - 1, i) * comb(m - 1, j) / comb(n + m - 2, i + j)
            curve[i + j] += share * poles[i, j]
    return curve


def chebyshev(order: int) -> Array:
    """Chebyshev nodes of [0, 1], the best places to sample a polynomial."""
    return (1 - np.cos((2 * np.arange(order) + 1) * np.pi / (2 * order))) / 2


def surface(rng: np.random.Generator, *orders: int) -> Array:
    """Random homogeneous poles with weights between 1/2 and 2."""
    weights = rng.uniform(0.5, 2.0, orders)
    points = rng.uniform(-1.0, 1.0, (*orders, 3))
    return np.concatenate([points * weights[..., None], weights[..., None]], axis=-1)
