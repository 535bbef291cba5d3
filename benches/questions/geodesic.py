"""Geodesics of a quarter of the outer half of a torus, to 1e-10.

Each starts near the middle of the patch and stays on it. The truth is the equation of geodesics in
the two angles of the torus, integrated with small steps of order 4; the peers that know no forms
solve that too.
"""

from __future__ import annotations

import numpy as np

from bernstein import Net
from contest import Array, Question, Work

VARIANTS = ("",)
SIZES = (10_000, 1_000, 100, 10)

MAJOR, MINOR = 2.0, 1.0


def patch() -> Net:
    """Axis 0 around the axis of the torus, axis 1 around its tube: a quarter turn each."""
    arc = np.array([(1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])
    weights = np.array([1.0, np.sqrt(0.5), 1.0])
    far = MAJOR + MINOR * arc[:, 0]
    points = np.empty((3, 3, 3))
    points[..., 0] = arc[:, :1] * far
    points[..., 1] = arc[:, 1:] * far
    points[..., 2] = MINOR * arc[:, 1]
    return Net(points, np.outer(weights, weights))


def question(_: str, count: int) -> Question:
    net = patch()
    rng = np.random.default_rng(11)
    starts = rng.uniform(0.35, 0.65, (count, 2))
    headings = rng.uniform(0, 2 * np.pi, count)
    # Angles at the parameters: arcs with the weights 1, √½, 1.
    angles = arc_angles(starts)
    velocities = np.stack([np.cos(headings), np.sin(headings)], axis=-1)
    radius = MAJOR + MINOR * np.cos(angles[:, 1])
    tangents = frames(angles, velocities)
    length = 0.5

    def ours(threads: int) -> Work:
        import pforms as pf
        from peers.ours import form

        surface = form(net, threads)
        return Work(
            lambda: pf.geodesic(surface, starts, tangents, length, accuracy=1e-10),
            lambda found: found.points,
        )

    def scipy(_: int) -> Work:
        from scipy.integrate import solve_ivp

        states = np.concatenate(
            [angles, velocities / np.stack([radius, np.full(count, MINOR)], axis=-1)], axis=1
        )

        def run() -> list[Array]:
            return [
                solve_ivp(
                    lambda _, state: slope(state),
                    (0, length),
                    state,
                    method="DOP853",
                    rtol=1e-11,
                    atol=1e-11,
                ).y[:, -1]
                for state in states
            ]

        return Work(run, lambda ends: on_torus(np.array(ends)[:, :2]))

    def error(points: Array) -> float:
        return float(np.abs(points - truth(angles, velocities, length)).max())

    return Question(count, "geodesic", {"pforms": ours, "scipy": scipy}, error)


def arc_angles(parameters: Array) -> Array:
    """The angle of a quarter circle at its parameters."""
    t, root = parameters, np.sqrt(0.5)
    cosine = (1 - t) ** 2 + 2 * root * t * (1 - t)
    sine = t**2 + 2 * root * t * (1 - t)
    return np.asarray(np.arctan2(sine, cosine))


def frames(angles: Array, velocities: Array) -> Array:
    """Directions in space from those along the two angles."""
    (turn, tube), (along, up) = angles.T, velocities.T
    return np.stack(
        [
            -np.sin(turn) * along - np.sin(tube) * np.cos(turn) * up,
            np.cos(turn) * along - np.sin(tube) * np.sin(turn) * up,
            np.cos(tube) * up,
        ],
        axis=-1,
    )


def on_torus(angles: Array) -> Array:
    turn, tube = angles.T
    far = MAJOR + MINOR * np.cos(tube)
    return np.stack([far * np.cos(turn), far * np.sin(turn), MINOR * np.sin(tube)], axis=-1)


def slope(state: Array) -> Array:
    """The equation of geodesics of a torus."""
    _, tube, turning, rising = state
    far = MAJOR + MINOR * np.cos(tube)
    return np.array(
        [
            turning,
            rising,
            2 * MINOR * np.sin(tube) / far * turning * rising,
            -far * np.sin(tube) / MINOR * turning**2,
        ]
    )


def truth(angles: Array, velocities: Array, length: float, steps: int = 1000) -> Array:
    """By many small steps of order 4."""
    radius = MAJOR + MINOR * np.cos(angles[:, 1])
    state = np.stack([*angles.T, velocities[:, 0] / radius, velocities[:, 1] / MINOR])
    by = length / steps
    for _ in range(steps):
        a = slope(state)
        b = slope(state + by / 2 * a)
        c = slope(state + by / 2 * b)
        d = slope(state + by * c)
        state = state + by / 6 * (a + 2 * b + 2 * c + d)
    return on_torus(state[:2].T)
