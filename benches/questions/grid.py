"""A bicubic surface on a grid: 1000 × 1000 points."""

from __future__ import annotations

import numpy as np

import bernstein
from contest import Array, Question, Work, apart_from

VARIANTS = ("polynomial", "rational")
SIZES = (1000, 320, 100, 32, 10)


def question(variant: str, side: int) -> Question:
    net = bernstein.sheet(1, variant, 4, 4)
    at = np.linspace(0.0, 1.0, side)

    def ours(threads: int) -> Work:
        from peers.ours import form

        surface = form(net, threads)
        return Work(lambda: surface.grid(at, at))

    def ours_into(threads: int) -> Work:
        from peers.ours import form

        surface, out = form(net, threads), np.zeros((side, side, 3))
        return Work(lambda: surface.grid(at, at, out=out))

    def numpy(_: int) -> Work:
        poles = net.homogeneous

        def run() -> Array:
            basis = bernstein.values(4, at)
            return net.project(bernstein.on_grid(poles, basis, basis))

        return Work(run)

    def scipy(_: int) -> Work:
        from peers.scipy import along

        poles = net.homogeneous
        return Work(lambda: net.project(along(along(poles, 0, at), 1, at)))

    def ndsplines(_: int) -> Work:
        from peers.ndsplines import lattice, spline

        surface = spline(net.homogeneous)
        return Work(lambda: net.project(surface(lattice(at, at))))

    def splinepy(threads: int) -> Work:
        from peers.splinepy import form

        surface = form(net)
        return Work(
            lambda: surface.sample([side, side], nthreads=threads),
            lambda points: np.swapaxes(points.reshape(side, side, 3), 0, 1),
        )

    def geomdl(_: int) -> Work:
        from peers.geomdl import surface

        net_surface = surface(net)
        net_surface.sample_size = side

        def run() -> object:
            net_surface.evaluate()
            return net_surface.evalpts

        return Work(run, lambda points: np.array(points).reshape(side, side, 3))

    def occt(_: int) -> Work:
        from peers.occt import coordinates, surface

        point, numbers = surface(net).Value, at.tolist()
        return Work(
            lambda: [point(u, v) for u in numbers for v in numbers],
            lambda points: coordinates(points).reshape(side, side, 3),
        )

    def sisl(_: int) -> Work:
        from peers.sisl import Surface

        surface = Surface(net)

        def run() -> Array:
            points = np.empty((side, side, 3))
            surface.call("grid", at, side, at, side, points)
            return points

        return Work(run, lambda points: np.swapaxes(points, 0, 1))

    def truth() -> Array:
        parameters = np.stack(np.meshgrid(at, at, indexing="ij"), axis=-1).reshape(-1, 2)
        points = net.project(bernstein.at_points(net.homogeneous, parameters))
        return points.reshape(side, side, 3)

    return Question(
        side * side,
        "point",
        {
            "pforms": ours,
            "pforms out=": ours_into,
            "numpy": numpy,
            "scipy": scipy,
            "ndsplines": ndsplines,
            "splinepy": splinepy,
            "geomdl": geomdl,
            "occt": occt,
            "sisl": sisl,
        },
        apart_from(truth),
        stored=24,
        # The sums along one axis serve a whole row.
        operations=24 if net.weights is None else 36,
    )
