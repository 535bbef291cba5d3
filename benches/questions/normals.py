"""Points and unit normals of a bicubic surface on a grid of 1000 × 1000."""

from __future__ import annotations

import numpy as np

import bernstein
from contest import Array, Native, Question, Work, apart_from

VARIANTS = ("polynomial", "rational")
SIZES = (1000, 320, 100, 32, 10)


def question(variant: str, side: int) -> Question:
    net = bernstein.sheet(1, variant, 4, 4)
    at = np.linspace(0.0, 1.0, side)

    def ours(threads: int) -> Work:
        from peers.ours import form

        surface = form(net, threads)
        return Work(lambda: surface.grid(at, at, normals=True), np.stack)

    def ours_into(threads: int) -> Work:
        from peers.ours import form

        surface = form(net, threads)
        out = np.zeros((side, side, 3)), np.zeros((side, side, 3))
        return Work(lambda: surface.grid(at, at, normals=True, out=out), np.stack)

    def numpy(_: int) -> Work:
        return Work(lambda: bernstein.with_normals(net, at, at))

    def scipy(_: int) -> Work:
        from peers.scipy import along

        poles = net.homogeneous

        def run() -> Array:
            rows, slopes = along(poles, 0, at), along(poles, 0, at, 1)
            return bernstein.oriented(
                net, along(rows, 1, at), along(slopes, 1, at), along(rows, 1, at, 1)
            )

        return Work(run)

    def ndsplines(_: int) -> Work:
        from peers.ndsplines import lattice, spline

        surface = spline(net.homogeneous)

        def run() -> Array:
            places = lattice(at, at)
            along_u = surface(places, nus=np.array([1, 0]))
            along_v = surface(places, nus=np.array([0, 1]))
            return bernstein.oriented(net, surface(places), along_u, along_v)

        return Work(run)

    def splinepy(threads: int) -> Work:
        from peers.splinepy import form

        surface = form(net)
        places = np.stack(np.meshgrid(at, at, indexing="ij"), axis=-1).reshape(-1, 2)

        def run() -> Array:
            points = surface.evaluate(places, nthreads=threads)
            tangents = surface.derivative(places, [[1, 0], [0, 1]], nthreads=threads)
            normals = np.cross(tangents[:, 0], tangents[:, 1])
            normals /= np.sqrt(np.einsum("mi,mi->m", normals, normals))[:, None]
            return np.stack([points, normals])

        return Work(run, on_lattice)

    def geomdl(_: int) -> Work:
        from geomdl import operations

        from peers.geomdl import surface

        net_surface, numbers = surface(net), at.tolist()
        places = [(u, v) for u in numbers for v in numbers]
        return Work(
            lambda: operations.normal(net_surface, places, normalize=True),
            lambda pairs: on_lattice(np.array(pairs).swapaxes(0, 1)),
        )

    def occt(_: int) -> Work:
        from OCP.gp import gp_Pnt, gp_Vec

        from peers.occt import coordinates, surface

        jet, numbers = surface(net).D1, at.tolist()

        def run() -> list[Native]:
            points, normals = [], []
            along_u, along_v = gp_Vec(), gp_Vec()
            for u in numbers:
                for v in numbers:
                    point = gp_Pnt()
                    jet(u, v, point, along_u, along_v)
                    points.append(point)
                    normals.append(along_u.Crossed(along_v).Normalized())
            return [points, normals]

        return Work(run, lambda lists: on_lattice(np.stack([coordinates(x) for x in lists])))

    def sisl(_: int) -> Work:
        from peers.sisl import Surface

        surface = Surface(net)

        def run() -> Array:
            both = np.empty((2, side, side, 3))
            surface.call("grid_with_normals", at, side, at, side, both[0], both[1])
            return both

        return Work(run, lambda both: np.swapaxes(both, 1, 2))

    def on_lattice(both: Array) -> Array:
        return both.reshape(2, side, side, 3)

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
        apart_from(lambda: bernstein.with_normals(net, at, at)),
        stored=48,
        operations=90 if net.weights is None else 135,
    )
