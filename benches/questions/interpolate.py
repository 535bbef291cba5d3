"""Bézier curves through 15 and 40 points, and a surface through a net of 30 × 30, equally spaced.

The truth is computed with fractions: at order 40 a dense solver in double precision finds other
poles.
"""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from math import comb

import numpy as np

import bernstein
from contest import Array, Question, Work, apart_from

CASES = {"curve of 15": (15,), "curve of 40": (40,), "surface of 30 × 30": (30, 30)}
VARIANTS = tuple(CASES)
SIZES = (100, 10, 1)


def question(variant: str, count: int) -> Question:
    orders = CASES[variant]
    count = 1 if len(orders) > 1 else count
    rng = np.random.default_rng(8)
    nets = list(rng.uniform(-1.0, 1.0, (count, *orders, 3)))
    nodes = np.linspace(0.0, 1.0, orders[0])

    def ours(_: int) -> Work:
        import pforms as pf

        return Work(
            lambda: [pf.interpolate(net) for net in nets],
            lambda forms: np.array([form.poles for form in forms]),
        )

    def numpy(_: int) -> Work:
        def solved(net: Array) -> Array:
            for axis, order in enumerate(orders):
                basis = bernstein.values(order, nodes)
                rows = np.moveaxis(net, axis, 0)
                poles = np.linalg.solve(basis, rows.reshape(order, -1)).reshape(rows.shape)
                net = np.moveaxis(poles.astype(np.float64, copy=False), 0, axis)
            return net

        return Work(lambda: [solved(net) for net in nets], np.array)

    def scipy(_: int) -> Work:
        from scipy.interpolate import make_interp_spline

        def solved(net: Array) -> Array:
            for axis, order in enumerate(orders):
                poles: Array = make_interp_spline(nodes, net, k=order - 1, axis=axis).c
                net = np.moveaxis(poles, 0, axis)
            return net

        return Work(lambda: [solved(net) for net in nets], np.array)

    def truth() -> Array:
        return np.array([exact_poles(net) for net in nets])

    answers = {"pforms": ours, "numpy": numpy, "scipy": scipy}
    return Question(count, "interpolation", answers, apart_from(truth), threads=(1,))


def exact_poles(net: Array) -> Array:
    """Poles in exact arithmetic, rounded once."""
    exact = np.vectorize(Fraction, otypes=[object])(net)
    for axis in range(net.ndim - 1):
        exact = np.moveaxis(np.tensordot(exact_inverse(net.shape[axis]), exact, (1, axis)), 0, axis)
    return exact.astype(np.float64)


@cache
def exact_inverse(order: int) -> Array:
    """Inverse of the Bernstein matrix at equally spaced nodes, by elimination of fractions."""
    n = order - 1
    rows = [
        [Fraction(comb(n, j) * i**j * (n - i) ** (n - j), n**n) for j in range(order)]
        + [Fraction(int(i == j)) for j in range(order)]
        for i in range(order)
    ]
    for k in range(order):
        rows[k] = [number / rows[k][k] for number in rows[k]]
        for i in range(order):
            if i != k and rows[i][k]:
                share = rows[i][k]
                rows[i] = [a - share * b for a, b in zip(rows[i], rows[k], strict=True)]
    return np.array([row[order:] for row in rows], dtype=object)
