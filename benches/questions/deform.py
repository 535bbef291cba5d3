"""200,000 points in a tricubic volume: their parameters, and where they go when the net moves.

The truth is known: the points were made from parameters.
"""

from __future__ import annotations

import numpy as np

import bernstein
from bernstein import Net
from contest import Array, Question, Work

VARIANTS = ("embed", "embed rational", "move", "move rational")
SIZES = (200_000, 20_000, 2_000, 200)


def question(variant: str, count: int) -> Question:
    task, *kind = variant.split()
    net = cage(rational=bool(kind))
    rng = np.random.default_rng(17)
    places = rng.uniform(0.02, 0.98, (count, 3))
    if task == "embed":
        return embedding(net, places)
    points = net.points + rng.uniform(-0.5, 0.5, net.points.shape)
    return moving(net, Net(points, net.weights), places)


def cage(*, rational: bool) -> Net:
    rng = np.random.default_rng(16)
    lattice = np.stack(np.meshgrid(*[np.arange(4.0)] * 3, indexing="ij"), axis=-1)
    points = lattice + rng.uniform(-0.1, 0.1, lattice.shape)
    return Net(points, rng.uniform(0.9, 1.1, (4, 4, 4)) if rational else None)


def embedding(net: Net, places: Array) -> Question:
    points = net.project(bernstein.at_points(net.homogeneous, places))

    def ours(threads: int) -> Work:
        import pforms as pf
        from peers.ours import form

        volume = form(net, threads)
        return Work(lambda: pf.embed(points, volume), lambda found: found.parameters)

    def splinepy(threads: int) -> Work:
        from peers.splinepy import form

        volume = form(net)
        return Work(
            lambda: volume.proximities(
                points,
                initial_guess_sample_resolutions=[9, 9, 9],
                tolerance=1e-12,
                nthreads=threads,
            )
        )

    def error(parameters: Array) -> float:
        return float(np.abs(parameters - places).max())

    answers = {"pforms": ours, "splinepy": splinepy}
    return Question(len(places), "point", answers, error)


def moving(net: Net, moved: Net, places: Array) -> Question:
    points = net.project(bernstein.at_points(net.homogeneous, places))
    truth = moved.project(bernstein.at_points(moved.homogeneous, places))

    def ours(threads: int) -> Work:
        import pforms as pf
        from peers.ours import form

        embedded, volume = pf.embed(points, form(net, threads)), form(moved, threads)
        out = np.empty_like(points)
        return Work(lambda: embedded.at(volume, out=out))

    def splinepy(threads: int) -> Work:
        from peers.splinepy import form

        volume = form(moved)
        return Work(lambda: volume.evaluate(places, nthreads=threads))

    def numpy(_: int) -> Work:
        return Work(lambda: moved.project(bernstein.at_points(moved.homogeneous, places)))

    def error(found: Array) -> float:
        return float(np.abs(found - truth).max() / np.abs(truth).max())

    answers = {"pforms": ours, "numpy": numpy, "splinepy": splinepy}
    return Question(len(places), "point", answers, error)
