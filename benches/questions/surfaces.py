"""Where two bicubic surfaces cross: all branches, for many pairs.

Both are graphs over one square, the second tilted. Every branch must lie on both surfaces, and
every pair must have the length of its branches, which the truth adds up in the cells of a fine
grid.
"""

from __future__ import annotations

from typing import cast

import numpy as np

import bernstein
from bernstein import Net
from contest import Array, Native, Question, Work

VARIANTS = ("polynomial",)
SIZES = (200, 20, 2)

SAMPLES = 50
"""Points of a branch that are checked."""


def question(variant: str, count: int) -> Question:
    del variant
    pairs = [graphs(seed) for seed in range(count)]

    def ours(threads: int) -> Work:
        import pforms as pf
        from peers.ours import form

        firsts = [form(one, threads) for one, _ in pairs]
        seconds = [form(other, threads) for _, other in pairs]

        def read(found: Native) -> Array:
            lines = [[sampled(b.curve) for b in found.whole[i].curves] for i in range(count)]
            return stacked(lines)

        return Work(lambda: pf.intersect_many(firsts, seconds), read)

    def sampled(curve: Native) -> Array:
        start, end = curve.window[0]
        return cast("Array", curve(np.linspace(start, end, SAMPLES)))

    def occt(_: int) -> Work:
        from OCP.GeomAPI import GeomAPI_IntSS

        from peers.occt import coordinates, surface

        native = [(surface(one), surface(other)) for one, other in pairs]

        def run() -> Native:
            found = [GeomAPI_IntSS(one, other, 1e-7) for one, other in native]
            return [[each.Line(k + 1) for k in range(each.NbLines())] for each in found]

        def points(line: Native) -> Array:
            at = np.linspace(line.FirstParameter(), line.LastParameter(), SAMPLES)
            return coordinates(line.Value(t) for t in at.tolist())

        return Work(run, lambda found: stacked([[points(x) for x in each] for each in found]))

    lengths = np.array([crossing_length(one, other) for one, other in pairs])

    def error(answer: Array) -> float:
        """The largest distance along z from either surface; infinite where a length is wrong."""
        worst = 0.0
        for i, (one, other) in enumerate(pairs):
            mine = answer[answer[:, 0] == i]
            total = 0.0
            for k in np.unique(mine[:, 1]):
                line = mine[mine[:, 1] == k, 2:]
                total += float(np.linalg.norm(np.diff(line, axis=0), axis=1).sum())
                for net in (one, other):
                    heights = bernstein.at_points(net.homogeneous, line[:, :2] / 3)[:, 2]
                    worst = max(worst, float(np.abs(heights - line[:, 2]).max()))
            # Chords of the grid and of the samples: a branch too few is a larger share.
            if abs(total - lengths[i]) > 0.02 * lengths[i]:
                return np.inf
        return worst

    return Question(count, "pair", {"pforms": ours, "occt": occt}, error, accuracy=1e-6)


def graphs(seed: int) -> tuple[Net, Net]:
    rng = np.random.default_rng(1300 + seed)
    x, y = np.meshgrid(np.arange(4.0), np.arange(4.0), indexing="ij")
    low, high = rng.uniform(-0.4, 0.4, (2, 4, 4))
    nets = low, high + 0.5 * (x - 1.5)
    first, second = (Net(np.stack([x, y, z], axis=-1), None) for z in nets)
    return first, second


def stacked(lines: list[list[Array]]) -> Array:
    """Rows: number of the pair, of the branch, and a point."""
    rows = [np.empty((0, 5))]
    for i, branches in enumerate(lines):
        for k, line in enumerate(branches):
            rows.append(np.column_stack([np.full((len(line), 2), (i, k)), line]))
    return np.concatenate(rows)


def crossing_length(one: Net, other: Net, side: int = 200) -> float:
    """The length of the curve where heights agree: chords in the triangles of a grid."""
    at = np.linspace(0.0, 1.0, side + 1)
    places = np.stack(np.meshgrid(at, at, indexing="ij"), axis=-1).reshape(-1, 2)
    p = bernstein.at_points(one.homogeneous, places).reshape(side + 1, side + 1, 3)
    q = bernstein.at_points(other.homogeneous, places).reshape(side + 1, side + 1, 3)
    gap = (p - q)[..., 2]
    corners = p[:-1, :-1], p[1:, :-1], p[1:, 1:], p[:-1, 1:]
    gaps = gap[:-1, :-1], gap[1:, :-1], gap[1:, 1:], gap[:-1, 1:]
    total = 0.0
    for i, j, k in ((0, 1, 2), (0, 2, 3)):
        ends = []
        for a, b in ((i, j), (j, k), (k, i)):
            crossed = (gaps[a] > 0) != (gaps[b] > 0)
            share = np.where(crossed, gaps[a] / np.where(crossed, gaps[a] - gaps[b], 1), np.nan)
            ends.append(corners[a] + share[..., None] * (corners[b] - corners[a]))
        for a, b in ((0, 1), (1, 2), (2, 0)):
            chords = np.linalg.norm(ends[a] - ends[b], axis=-1)
            total += float(np.nansum(chords))
    return total
