"""All crossings of pairs of plane Bézier curves of degree 3, 5 and 8.

One curve runs along x, the other along y, each with random poles: they cross once to many times.
Only pairs whose crossings are clear are asked (apart, at an angle, inside), so that a count is
right or wrong.
"""

from __future__ import annotations

import numpy as np

import bernstein
from contest import Array, Native, Question, Work

VARIANTS = ("degree 3", "degree 5", "degree 8")
SIZES = (1_000, 100, 10)

SAMPLES = 257
"""Points of the polylines whose crossings start Newton's steps, for the truth."""


def question(variant: str, count: int) -> Question:
    degree = int(variant.split()[-1])
    first, second, truth = pairs(degree, count)

    def ours(threads: int) -> Work:
        import pforms as pf

        pf.set_threads(threads)
        return Work(lambda: pf.intersect_many(first, second), lambda found: padded(found.pairs()))

    def occt(_: int) -> Work:
        from OCP.Geom2d import Geom2d_BezierCurve
        from OCP.Geom2dAPI import Geom2dAPI_InterCurveCurve
        from OCP.gp import gp_Pnt2d
        from OCP.TColgp import TColgp_Array1OfPnt2d

        def curve(points: Array) -> Native:
            poles = TColgp_Array1OfPnt2d(1, len(points))
            for i, (x, y) in enumerate(points.tolist()):
                poles.SetValue(i + 1, gp_Pnt2d(x, y))
            return Geom2d_BezierCurve(poles)

        curves = [(curve(a), curve(b)) for a, b in zip(first, second, strict=True)]

        def crossings(a: Native, b: Native) -> Array:
            search = Geom2dAPI_InterCurveCurve(a, b, 1e-9)
            found = [search.Intersector().Point(i + 1) for i in range(search.NbPoints())]
            return np.array([(p.ParamOnFirst(), p.ParamOnSecond()) for p in found]).reshape(-1, 2)

        return Work(lambda: [crossings(a, b) for a, b in curves], padded)

    def numpy(_: int) -> Work:
        return Work(
            lambda: [crossings_of(a, b)[0] for a, b in zip(first, second, strict=True)], padded
        )

    def error(found: Array) -> float:
        """The farthest parameter; infinite for a wrong count."""
        expected = padded(truth)
        if found.shape != expected.shape or (np.isnan(found) != np.isnan(expected)).any():
            return np.inf
        return float(np.nanmax(np.abs(found - expected)))

    return Question(count, "pair", {"pforms": ours, "numpy": numpy, "occt": occt}, error)


def padded(pairs: list[Array]) -> Array:
    """One row for each pair, its crossings in order, then NaN."""
    rows = np.full((len(pairs), max(len(pair) for pair in pairs), 2), np.nan)
    for row, pair in zip(rows, pairs, strict=True):
        row[: len(pair)] = pair[np.argsort(pair[:, 0])]
    return rows


def pairs(degree: int, count: int) -> tuple[Array, Array, list[Array]]:
    """Poles of pairs with clear crossings, and these."""
    rng = np.random.default_rng(degree)
    along = np.linspace(0.0, 1.0, degree + 1)
    first, second = [], []
    truth: list[Array] = []
    while len(truth) < count:
        near, far = rng.uniform(-0.1, 0.1, (2, degree + 1)), rng.uniform(-0.5, 1.5, (2, degree + 1))
        a = np.stack([along + near[0], far[0]], axis=-1)
        b = np.stack([far[1], along + near[1]], axis=-1)
        found, sines = crossings_of(a, b)
        inside = (found > 0.01).all() and (found < 0.99).all()
        if len(found) and inside and (np.diff(found[:, 0]) > 0.02).all() and (sines > 0.1).all():
            first.append(a)
            second.append(b)
            truth.append(found)
    return np.array(first), np.array(second), truth


def crossings_of(a: Array, b: Array) -> tuple[Array, Array]:
    """Crossings of polylines, refined by Newton's steps, and the sines of their angles."""
    t = np.linspace(0.0, 1.0, SAMPLES)
    basis = bernstein.values(len(a), t)
    p, q = basis @ a, basis @ b
    u, v = np.diff(p, axis=0)[:, None], np.diff(q, axis=0)[None]
    gap = q[None, :-1] - p[:-1, None]
    with np.errstate(divide="ignore", invalid="ignore"):
        area = cross(u, v)
        x, y = cross(gap, v) / area, cross(gap, u) / area
    rows, columns = np.nonzero((x >= 0) & (x < 1) & (y >= 0) & (y < 1))
    found = np.stack([t[rows] + x[rows, columns] * t[1], t[columns] + y[rows, columns] * t[1]], -1)
    sines = np.ones(len(found))
    for _ in range(8):
        (p, dp), (q, dq) = jet(a, found[:, 0]), jet(b, found[:, 1])
        area = cross(dp, dq)
        found = found + np.stack([cross(q - p, dq), cross(q - p, dp)], -1) / area[:, None]
        sines = np.abs(area) / np.linalg.norm(dp, axis=1) / np.linalg.norm(dq, axis=1)
    order = np.argsort(found[:, 0])
    return found[order], sines[order]


def jet(poles: Array, t: Array) -> tuple[Array, Array]:
    """Points and derivatives."""
    degree = len(poles) - 1
    slopes = degree * np.diff(poles, axis=0)
    return bernstein.values(degree + 1, t) @ poles, bernstein.values(degree, t) @ slopes


def cross(a: Array, b: Array) -> Array:
    return np.asarray(a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0])
