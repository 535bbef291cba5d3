"""What a question is, and how one contender's answer is checked and timed."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Native = Any
"""What a peer computes with: its own surfaces, points and lists."""

PARALLEL = frozenset({"pforms", "splinepy"})
"""Libraries that can be told a number of threads."""


class MissingError(Exception):
    """A peer that is not here, or cannot answer."""


@dataclass(frozen=True)
class Report:
    """What a work that measured itself, in another process, returns."""

    seconds: float
    answer: Native


@dataclass(frozen=True)
class Work:
    """What is timed, and how its outcome becomes the array that is checked (not timed)."""

    run: Callable[[], Native]
    read: Callable[[Native], Array] = np.asarray


Answer = Callable[[int], Work]
"""Prepares a contender's own objects for a number of threads."""


@dataclass(frozen=True)
class Question:
    """A task that several libraries solve, and the number of items it counts in."""

    items: int
    unit: str
    answers: Mapping[str, Answer]
    """How each contender answers; the first is ours. `pforms out=` is another way of `pforms`."""
    error: Callable[[Array], float]
    """How far an answer is from the truth, relative to the largest number in it."""
    accuracy: float = 1e-9
    """Largest error of an answer that counts: above the rounding of the worst peer, far below what
    a wrong formula would show."""
    threads: tuple[int, ...] = (1, 2)
    """What it is asked with, of those who can be told."""
    stored: float = 0
    """Bytes written per item, by whoever answers."""
    operations: float = 0
    """Additions and multiplications per item, in the best way that we know."""


class Questions(Protocol):
    """A file of `questions/`."""

    VARIANTS: tuple[str, ...]
    SIZES: tuple[int, ...]
    """Largest first, each about ten times the work of the next. A slow contender gets a smaller
    one: rates stay comparable."""

    def question(self, variant: str, size: int) -> Question:
        """Asks about a variant at a size."""


@dataclass(frozen=True)
class Result:
    """An answer that was right, and its seconds per call."""

    size: int
    items: int
    unit: str
    stored: float
    operations: float
    error: float
    median: float
    least: float


class WrongError(Exception):
    """An answer that differs from the truth: it is not timed."""


def hold(about: Questions, variant: str, contender: str, threads: int, budget: float) -> Result:
    """Lets a contender answer at the largest size that the budget allows, checks and times it."""
    size, question, work, outcome = largest(about, variant, contender, threads, budget)
    error = question.error(work.read(outcome))
    if not error <= question.accuracy:
        raise WrongError(f"differs by {error:.1e}")
    del outcome
    times = seconds(work, time.process_time if threads == 1 else time.perf_counter, budget)
    return Result(
        size,
        question.items,
        question.unit,
        question.stored,
        question.operations,
        error,
        median=float(np.median(times)),
        least=min(times),
    )


def largest(
    about: Questions, variant: str, contender: str, threads: int, budget: float
) -> tuple[int, Question, Work, Native]:
    """Climbs from the smallest size until the next, ten times the work, would take too long."""
    for size in reversed(about.SIZES):
        question = about.question(variant, size)
        work = question.answers[contender](threads)
        taken, outcome = once(work, time.perf_counter)
        if taken * 10 > 4 * budget:
            break
    return size, question, work, outcome


def once(work: Work, clock: Callable[[], float]) -> tuple[float, Native]:
    """Seconds of one call, and its outcome."""
    started = clock()
    outcome = work.run()
    taken = clock() - started
    return (outcome.seconds, outcome.answer) if isinstance(outcome, Report) else (taken, outcome)


def seconds(work: Work, clock: Callable[[], float], budget: float, least: int = 3) -> list[float]:
    """Seconds per call of at least `least` batches, in about `budget` seconds.

    A batch of quick calls is long enough for the clock. Where one thread works the clock is the
    processor's time, which hardly suffers from other load.
    """
    started = time.perf_counter()
    once(work, clock)
    calls = max(1, min(1000, round(0.002 / (time.perf_counter() - started))))
    batches: list[float] = []
    while len(batches) < least or time.perf_counter() - started < budget:
        batches.append(math.fsum(once(work, clock)[0] for _ in range(calls)) / calls)
    return batches


def apart_from(truth: Callable[[], Array]) -> Callable[[Array], float]:
    """The error of an answer that should be this array."""

    def error(answer: Array) -> float:
        expected = truth()
        if answer.shape != expected.shape:
            return math.inf
        return float(np.abs(answer - expected).max() / np.abs(expected).max())

    return error
