"""Forms immersed in forms: curves and surfaces in a surface, surfaces and volumes in a volume."""

from __future__ import annotations

from math import comb

import numpy as np

import bernstein
import pforms as pf
from bernstein import Net
from contest import Array, Question, Work, apart_from

CASES = {
    "pL4 in pS44": ((4,), (4, 4)),
    "pS22 in pS44": ((2, 2), (4, 4)),
    "pS44 in pV222": ((4, 4), (2, 2, 2)),
    "pV222 in pV333": ((2, 2, 2), (3, 3, 3)),
    "pV444 in pV444": ((4, 4, 4), (4, 4, 4)),
}
VARIANTS = tuple(f"{kind} {case}" for case in CASES for kind in ("polynomial", "rational"))
SIZES = (1_000, 100, 10)
CHECKED = 10
"""Immersions that are compared with the slow composition below."""


def question(variant: str, count: int) -> Question:
    kind, case = variant.split(maxsplit=1)
    inner_orders, host_orders = CASES[case]
    host = bernstein.sheet(5, kind, *host_orders)
    # The degree of the largest case is 27 along each axis: one form is work enough.
    count = max(1, count // 1_000) if case == "pV444 in pV444" else count
    inners = [
        inside(bernstein.net(6 + i, kind, *inner_orders, low=0.0), host) for i in range(count)
    ]

    def read(results: list[pf.Form]) -> Array:
        from peers.ours import poles

        return np.array([poles(result, host.weights is not None) for result in results])

    def ours(threads: int) -> Work:
        from peers.ours import form

        host_form, forms = form(host, threads), [form(inner, threads) for inner in inners]
        return Work(lambda: [host_form(form) for form in forms], read)

    def ours_at_once(threads: int) -> Work:
        from peers.ours import form

        host_form, forms = form(host, threads), [form(inner, threads) for inner in inners]
        return Work(lambda: pf.immerse(forms, host_form), read)

    def numpy(_: int) -> Work:
        return Work(lambda: [sampled(inner, host) for inner in inners], np.array)

    def splinepy(_: int) -> Work:
        from peers.splinepy import form, poles

        host_form, forms = form(host), [form(inner) for inner in inners]
        return Work(
            lambda: [host_form.compose(form) for form in forms],
            lambda results: np.array([*map(poles, results)]),
        )

    def error(answer: Array) -> float:
        checked = inners[:CHECKED]
        if len(answer) != len(inners):
            return np.inf
        return apart_from(lambda: np.array([composed(inner, host) for inner in checked]))(
            answer[: len(checked)]
        )

    answers = {"pforms": ours, "pforms list": ours_at_once, "numpy": numpy, "splinepy": splinepy}
    return Question(count, "immersion", answers, error, threads=(1,))


def inside(inner: Net, host: Net) -> Net:
    """The net with as many coordinates as the host has axes."""
    return Net(inner.points[..., : len(host.orders)], inner.weights)


def composed(inner: Net, host: Net) -> Array:
    """Homogeneous poles by products of polynomials, one pole of the host after the other.

    Poles times binomials multiply as the coefficients of plain polynomials do.
    """
    scaled = inner.homogeneous * binomials(inner.orders)[..., None]
    rational = inner.weights is not None
    weights = scaled[..., -1] if rational else binomials(inner.orders)

    def summed(poles: Array, axis: int) -> Array:
        if axis == len(host.orders):
            return poles.reshape((1,) * len(inner.orders) + (-1,))
        x, n = scaled[..., axis], host.orders[axis] - 1
        terms = []
        for i, below in enumerate(poles):
            factor = product(power(x, i), power(weights - x, n - i)) * comb(n, i)
            terms.append(product(factor[..., None], summed(below, axis + 1)))
        return np.sum(terms, axis=0)

    total = summed(host.homogeneous, 0)
    poles: Array = total / binomials(total.shape[:-1])[..., None]
    return poles


def binomials(orders: tuple[int, ...]) -> Array:
    """Products of binomials, of the shape of a net."""
    rows = [np.array([comb(order - 1, i) for i in range(order)], float) for order in orders]
    grid: Array = np.prod(np.stack(np.meshgrid(*rows, indexing="ij")), axis=0)
    return grid


def product(a: Array, b: Array) -> Array:
    """Coefficients of a product of polynomials in so many variables."""
    axes = [n + m - 1 for n, m in zip(a.shape, b.shape, strict=True)]
    out = np.zeros(axes)
    for place in np.ndindex(*a.shape):
        window = tuple(slice(i, i + m) for i, m in zip(place, b.shape, strict=True))
        out[window] += a[place] * b
    return out


def power(a: Array, exponent: int) -> Array:
    return product(a, power(a, exponent - 1)) if exponent else np.ones((1,) * a.ndim)


def sampled(inner: Net, host: Net) -> Array:
    """Homogeneous poles by values at Chebyshev nodes, as one does without an exact product."""
    degree = sum(order - 1 for order in host.orders)
    orders = [degree * (order - 1) + 1 for order in inner.orders]
    places = inner.homogeneous
    for axis, order in enumerate(orders):
        basis = bernstein.values(inner.orders[axis], bernstein.chebyshev(order))
        places = np.moveaxis(np.tensordot(basis, places, (1, axis)), 0, axis)
    flat = places.reshape(-1, places.shape[-1])
    samples = homogeneous_values(flat, inner.weights is not None, host)
    poles = samples.reshape(*orders, -1)
    for axis, order in enumerate(orders):
        solve = np.linalg.inv(bernstein.values(order, bernstein.chebyshev(order)))
        poles = np.moveaxis(np.tensordot(solve, poles, (1, axis)), 0, axis)
    return poles


def homogeneous_values(places: Array, rational: bool, host: Net) -> Array:
    """The host at homogeneous places: sums of Cⁿᵢ xⁱ (w − x)ⁿ⁻ⁱ, free of divisions."""
    weights = places[:, -1] if rational else 1.0
    basis = np.ones((len(places), 1))
    for axis, order in enumerate(host.orders):
        x, n = places[:, axis], order - 1
        rows = [comb(n, i) * x**i * (weights - x) ** (n - i) for i in range(order)]
        basis = (basis[:, :, None] * np.stack(rows, axis=-1)[:, None, :]).reshape(len(places), -1)
    values: Array = basis @ host.homogeneous.reshape(basis.shape[1], -1)
    return values
