"""One operation on one bicubic surface: how long a single call takes."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

import bernstein
import pforms as pf
from bernstein import Net
from contest import Answer, Array, Native, Question, Work, apart_from

VARIANTS = tuple(
    f"{kind} {operation}"
    for operation in ("elevate", "split", "stretch", "diagonal")
    for kind in ("polynomial", "rational")
)
SIZES = (1_000, 100, 10)

WINDOW = (0.25, 0.875)
HALVES = ((0.0, 0.5), (0.5, 1.0))


def question(variant: str, count: int) -> Question:
    kind, operation = variant.split()
    nets = [bernstein.sheet(seed, kind, 4, 4) for seed in range(count)]
    matrix = MATRICES[operation]
    shape = {"elevate": (8, 8), "split": (4, 4, 4), "stretch": (4, 4), "diagonal": (7,)}[operation]

    def numpy(_: int) -> Work:
        poles = [net.homogeneous.reshape(16, -1) for net in nets]
        return Work(lambda: [(matrix @ p).reshape(*shape, -1) for p in poles], np.array)

    def truth() -> Array:
        family = np.array([net.homogeneous for net in nets]).reshape(count, 16, -1)
        return np.einsum("ij,njc->nic", matrix, family).reshape(count, *shape, -1)

    answers = {"pforms": ours(operation, nets), "numpy": numpy, **peers(operation, nets)}
    return Question(count, "operation", answers, apart_from(truth), threads=(1,))


def matrices() -> dict[str, Array]:
    """Each operation as one matrix on the sixteen poles."""
    elevation = bernstein.elevation(4, 4)
    halves = [bernstein.restriction(4, a, b) for a, b in HALVES]
    window = bernstein.restriction(4, *WINDOW)
    return {
        "elevate": np.kron(elevation, elevation),
        "split": np.concatenate([np.kron(a, b) for a in halves for b in halves]),
        "stretch": np.kron(window, window),
        "diagonal": bernstein.diagonal(4).reshape(7, 16),
    }


MATRICES = matrices()


def ours(operation: str, nets: list[Net]) -> Answer:
    calls: dict[str, Callable[[pf.Form], object]] = {
        "elevate": lambda form: form.elevate((4, 4)),
        "split": lambda form: list(form.subdivide(1)),
        "stretch": lambda form: form.stretch([WINDOW[0]] * 2, [WINDOW[1]] * 2),
        "diagonal": lambda form: form.diagonal(),
    }
    call = calls[operation]

    def answer(threads: int) -> Work:
        from peers.ours import form, poles

        forms = [form(net, threads) for net in nets]
        rational = nets[0].weights is not None

        def read(results: list[Native]) -> Array:
            if operation == "split":
                return np.array([[poles(part, rational) for part in parts] for parts in results])
            return np.array([poles(result, rational) for result in results])

        return Work(lambda: [call(form) for form in forms], read)

    return answer


def peers(operation: str, nets: list[Net]) -> dict[str, Answer]:
    """Who else can."""

    def splinepy(_: int) -> Work:
        from peers.splinepy import form, poles

        forms = [form(net) for net in nets]

        def elevated(form: Native) -> Native:
            copy = form.copy()
            copy.elevate_degrees([0, 0, 0, 0, 1, 1, 1, 1])
            return copy

        def quarters(form: Native) -> list[Native]:
            return [part for half in form.split(0, [0.5]) for part in half.split(1, [0.5])]

        if operation == "elevate":
            return Work(lambda: [elevated(f) for f in forms], lambda r: np.array([*map(poles, r)]))
        return Work(
            lambda: [quarters(f) for f in forms],
            lambda r: np.array([[poles(part) for part in parts] for parts in r]),
        )

    def occt(_: int) -> Work:
        from OCP.Geom import Geom_BezierSurface

        from peers.occt import poles, surface

        surfaces = [surface(net) for net in nets]
        windows = [(a, b, c, d) for a, b in HALVES for c, d in HALVES]
        if operation == "stretch":
            windows = [WINDOW + WINDOW]

        def elevated(surface: Native) -> Native:
            copy = Geom_BezierSurface(surface)
            copy.Increase(7, 7)
            return copy

        def restricted(surface: Native, window: tuple[float, ...]) -> Native:
            copy = Geom_BezierSurface(surface)
            copy.Segment(*window)
            return copy

        if operation == "elevate":
            return Work(
                lambda: [elevated(s) for s in surfaces], lambda r: np.array([*map(poles, r)])
            )
        return Work(
            lambda: [[restricted(s, window) for window in windows] for s in surfaces],
            lambda r: np.array([[poles(part) for part in parts] for parts in r]).squeeze(),
        )

    who: dict[str, dict[str, Answer]] = {
        "elevate": {"splinepy": splinepy, "occt": occt},
        "split": {"splinepy": splinepy, "occt": occt},
        "stretch": {"occt": occt},
        "diagonal": {},
    }
    return who[operation]
