"""The closest points of a bicubic surface to 10,000 points in space.

Half of the points lie near the surface, half anywhere around it: of those many are closest to a
border. An answer must be the closest point for every one; the truth is found by brute force.
"""

from __future__ import annotations

import numpy as np

import bernstein
from bernstein import Net
from contest import Array, Native, Question, Work

VARIANTS = ("polynomial", "rational")
SIZES = (10_000, 1_000, 100, 10)


def question(variant: str, count: int) -> Question:
    net = bernstein.sheet(1, variant, 4, 4)
    points = around(net, count)

    def ours(threads: int) -> Work:
        import pforms as pf
        from peers.ours import form

        surface = form(net, threads)
        return Work(lambda: pf.project(surface, points), lambda found: found.parameters)

    def splinepy(threads: int) -> Work:
        from peers.splinepy import form

        surface = form(net)
        return Work(
            lambda: surface.proximities(
                points,
                initial_guess_sample_resolutions=[33, 33],
                tolerance=1e-12,
                nthreads=threads,
            )
        )

    def occt(_: int) -> Work:
        from OCP.GeomAPI import GeomAPI_ProjectPointOnSurf
        from OCP.gp import gp_Pnt

        from peers.occt import surface

        places = [gp_Pnt(*point) for point in points.tolist()]
        search = GeomAPI_ProjectPointOnSurf()
        search.Init(surface(net), 0.0, 1.0, 0.0, 1.0, 1e-10)

        def closest(point: Native) -> tuple[float, ...]:
            search.Perform(point)
            found = search.NbPoints() > 0
            return tuple(search.LowerDistanceParameters())[:2] if found else (np.inf, np.inf)

        return Work(lambda: [closest(point) for point in places], np.array)

    def sisl(_: int) -> Work:
        from peers.sisl import Surface

        surface = Surface(net)

        def run() -> Array:
            parameters = np.full((count, 2), np.inf)
            surface.call("closest", points, count, 1e-10, parameters)
            return parameters

        return Work(run)

    def numpy(_: int) -> Work:
        return Work(lambda: brute_force(net, points)[0])

    def error(parameters: Array) -> float:
        """The longest detour, relative to the surface's size."""
        _, shortest = brute_force(net, points)
        if not np.all((parameters >= 0) & (parameters <= 1)):
            return np.inf
        size = np.linalg.norm(np.ptp(net.points, axis=(0, 1)))
        return float(np.max(distances(net, parameters, points) - shortest) / size)

    answers = {"pforms": ours, "numpy": numpy, "splinepy": splinepy, "occt": occt, "sisl": sisl}
    return Question(count, "point", answers, error)


def around(net: Net, count: int) -> Array:
    """Half near the surface, half in a box twice its size."""
    rng = np.random.default_rng(9)
    near = net.project(bernstein.at_points(net.homogeneous, rng.random((count // 2, 2))))
    near += rng.uniform(-0.2, 0.2, near.shape)
    low, high = net.points.min(axis=(0, 1)), net.points.max(axis=(0, 1))
    middle, half = (low + high) / 2, (high - low) / 2
    anywhere = rng.uniform(middle - 2 * half, middle + 2 * half, (count - len(near), 3))
    return np.concatenate([near, anywhere])


def distances(net: Net, parameters: Array, points: Array) -> Array:
    feet = net.project(bernstein.at_points(net.homogeneous, parameters))
    return np.asarray(np.linalg.norm(feet - points, axis=-1))


def brute_force(net: Net, points: Array, side: int = 65, starts: int = 4) -> tuple[Array, Array]:
    """Parameters and distances, by steps from the closest points of a grid."""
    at = np.linspace(0.0, 1.0, side)
    lattice = np.stack(np.meshgrid(at, at, indexing="ij"), axis=-1).reshape(-1, 2)
    samples = net.project(bernstein.at_points(net.homogeneous, lattice))
    best, shortest = np.zeros((len(points), 2)), np.full(len(points), np.inf)
    for start in range(0, len(points), 500):
        part = slice(start, start + 500)
        apart = ((points[part, None] - samples[None]) ** 2).sum(axis=-1)
        for place in np.argpartition(apart, starts, axis=1)[:, :starts].T:
            found, length = descend(net, lattice[place], points[part], 1 / (side - 1))
            closer = length < shortest[part]
            best[part][closer], shortest[part][closer] = found[closer], length[closer]
    return best, shortest


def descend(net: Net, parameters: Array, points: Array, step: float) -> tuple[Array, Array]:
    """Goes to the best of eight neighbours, by ever smaller steps.

    Needs no derivative, and borders are no exception.
    """
    steps = np.array([(i, j) for i in (-1, 0, 1) for j in (-1, 0, 1)], dtype=np.float64)
    everyone = np.arange(len(points))
    length = distances(net, parameters, points)
    while step > 1e-9:
        tries = np.clip(parameters[:, None] + step * steps, 0, 1)
        flat = distances(net, tries.reshape(-1, 2), np.repeat(points, len(steps), axis=0))
        lengths = flat.reshape(len(points), -1)
        choice = lengths.argmin(axis=1)
        moved = lengths[everyone, choice] < length
        parameters = np.where(moved[:, None], tries[everyone, choice], parameters)
        length = np.minimum(length, lengths[everyone, choice])
        # Halved only when nobody gains: a long way at one width costs less than a wrong valley.
        if moved.mean() < 0.01:
            step /= 2
    return parameters, length
