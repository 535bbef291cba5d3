"""A million scattered points of a bicubic surface and of a tricubic volume."""

from __future__ import annotations

import numpy as np

import bernstein
from contest import Array, Question, Work, apart_from

VARIANTS = ("polynomial surface", "rational surface", "polynomial volume", "rational volume")
SIZES = (1_000_000, 100_000, 10_000, 1_000)

# Basis, products of the basis, and a multiplication and an addition for each pole and coordinate.
OPERATIONS = dict(zip(VARIANTS, (140, 180, 540, 680), strict=True))


def question(variant: str, count: int) -> Question:
    axes = 2 if "surface" in variant else 3
    net = bernstein.sheet(2, variant, *[4] * axes)
    parameters = np.random.default_rng(3).random((count, axes))
    columns = list(np.ascontiguousarray(parameters.T))

    def ours(threads: int) -> Work:
        from peers.ours import form

        host = form(net, threads)
        return Work(lambda: host(*columns))

    def ours_into(threads: int) -> Work:
        from peers.ours import form

        host, out = form(net, threads), np.zeros((count, 3))
        return Work(lambda: host.evaluate(*columns, out=out))

    def numpy(_: int) -> Work:
        poles = net.homogeneous
        return Work(lambda: net.project(bernstein.at_points(poles, parameters)))

    def scipy(_: int) -> Work:
        from peers.scipy import spline

        host = spline(net.homogeneous)
        return Work(lambda: net.project(host(parameters)))

    def ndsplines(_: int) -> Work:
        from peers.ndsplines import spline

        host = spline(net.homogeneous)
        return Work(lambda: net.project(host(parameters)))

    def splinepy(threads: int) -> Work:
        from peers.splinepy import form

        host = form(net)
        return Work(lambda: host.evaluate(parameters, nthreads=threads))

    def geomdl(_: int) -> Work:
        from peers import geomdl

        host = geomdl.surface(net) if axes == 2 else geomdl.volume(net)
        places = parameters.tolist()
        return Work(lambda: host.evaluate_list(places))

    def occt(_: int) -> Work:
        from peers.occt import coordinates, surface

        point, places = surface(net).Value, parameters.tolist()
        return Work(lambda: [point(u, v) for u, v in places], coordinates)

    def sisl(_: int) -> Work:
        from peers.sisl import Surface

        surface = Surface(net)

        def run() -> Array:
            points = np.empty((count, 3))
            surface.call("scattered", parameters, count, points)
            return points

        return Work(run)

    answers = {
        "pforms": ours,
        "pforms out=": ours_into,
        "numpy": numpy,
        "scipy": scipy,
        "ndsplines": ndsplines,
        "splinepy": splinepy,
        "geomdl": geomdl,
    }
    if axes == 2:
        answers |= {"occt": occt, "sisl": sisl}

    def truth() -> Array:
        return net.project(nested(net.homogeneous, columns))

    return Question(
        count,
        "point",
        answers,
        apart_from(truth),
        stored=24,
        operations=OPERATIONS[variant],
    )


def nested(poles: Array, columns: list[Array]) -> Array:
    """Homogeneous values by one axis after another, otherwise than the contenders do."""
    basis = [bernstein.values(order, at) for order, at in zip(poles.shape, columns, strict=False)]
    sums = np.tensordot(basis[0], poles, axes=1)
    for along in basis[1:]:
        sums = np.einsum("mi,mi...->m...", along, sums)
    return sums
