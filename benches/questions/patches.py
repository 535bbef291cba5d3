"""Many small bicubic patches: 10,000 of them, on 17 × 17 points each."""

from __future__ import annotations

import numpy as np

import bernstein
from bernstein import Net
from contest import Array, Question, Work, apart_from

VARIANTS = ("polynomial", "rational")
SIZES = (10_000, 1_000, 100, 10)
SIDE = 17


def question(variant: str, count: int) -> Question:
    base = bernstein.sheet(1, variant, 4, 4)
    rng = np.random.default_rng(4)
    points = base.points + rng.uniform(-0.2, 0.2, (count, 4, 4, 3))
    weights = None if base.weights is None else rng.uniform(0.5, 2.0, (count, 4, 4))
    family = Net(points, weights)
    nets = [Net(p, None if weights is None else weights[i]) for i, p in enumerate(points)]
    at = np.linspace(0.0, 1.0, SIDE)

    def ours(threads: int) -> Work:
        import pforms as pf
        from peers.ours import form

        surfaces = [form(net, threads) for net in nets]
        return Work(lambda: pf.grid(surfaces, at, at))

    def ours_into(threads: int) -> Work:
        import pforms as pf
        from peers.ours import form

        surfaces, out = [form(net, threads) for net in nets], np.zeros((count, SIDE, SIDE, 3))
        return Work(lambda: pf.grid(surfaces, at, at, out=out))

    def numpy(_: int) -> Work:
        poles = family.homogeneous.reshape(count, 16, -1)

        def run() -> Array:
            basis = bernstein.values(4, at)
            both = np.einsum("ui,vj->uvij", basis, basis).reshape(SIDE**2, 16)
            points = np.empty((count, SIDE**2, 3))
            for start in range(0, count, 256):
                part = slice(start, start + 256)
                points[part] = family.project(both @ poles[part])
            return points

        return Work(run, lambda points: points.reshape(count, SIDE, SIDE, 3))

    def scipy(_: int) -> Work:
        from peers.scipy import along

        poles = family.homogeneous
        return Work(lambda: family.project(along(along(poles, 1, at), 2, at)))

    def splinepy(threads: int) -> Work:
        from splinepy import Multipatch

        from peers.splinepy import form

        patches = Multipatch([form(net) for net in nets])
        return Work(
            lambda: patches.sample(SIDE, nthreads=threads),
            lambda points: points.reshape(count, SIDE, SIDE, 3).swapaxes(1, 2),
        )

    def occt(_: int) -> Work:
        from peers.occt import coordinates, surface

        surfaces, numbers = [surface(net).Value for net in nets], at.tolist()
        return Work(
            lambda: [point(u, v) for point in surfaces for u in numbers for v in numbers],
            lambda points: coordinates(points).reshape(count, SIDE, SIDE, 3),
        )

    def sisl(_: int) -> Work:
        from peers.sisl import Surface, grids

        surfaces = [Surface(net) for net in nets]

        def run() -> Array:
            points = np.empty((count, SIDE, SIDE, 3))
            grids(surfaces, at, points)
            return points

        return Work(run, lambda points: points.swapaxes(1, 2))

    def truth() -> Array:
        basis = bernstein.values(4, at)
        return family.project(bernstein.on_grid(family.homogeneous, basis, basis))

    return Question(
        count * SIDE**2,
        "point",
        {
            "pforms": ours,
            "pforms out=": ours_into,
            "numpy": numpy,
            "scipy": scipy,
            "splinepy": splinepy,
            "occt": occt,
            "sisl": sisl,
        },
        apart_from(truth),
        stored=24,
        operations=30 if weights is None else 44,
    )
