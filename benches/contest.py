"""What a question is, and how a call is timed."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Answer = Callable[[], Array]


@dataclass(frozen=True)
class Question:
    """A task that several libraries solve, and the number of items it counts in."""

    name: str
    items: int
    unit: str
    answers: Mapping[str, Answer]
    """How each contender answers; the first is pforms."""
    accuracy: float = 1e-9
    """Largest difference between answers, relative to the largest number in them: above the
    rounding of the worst peer, far below what a wrong formula would show."""


@dataclass(frozen=True)
class Result:
    """Seconds per call for each contender."""

    question: Question
    seconds: Mapping[str, float]
    differences: Mapping[str, float] = field(default_factory=dict)

    def ratio(self, peer: str) -> float:
        """Says how many times longer the peer takes than the first contender."""
        ours = next(iter(self.seconds.values()))
        return self.seconds[peer] / ours


def hold(question: Question, budget: float) -> Result:
    """Compares the answers, then times each contender for `budget` seconds.

    Raises
    ------
    ValueError
        When two contenders disagree by more than the question's accuracy.
    """
    answers = {name: answer() for name, answer in question.answers.items()}
    reference = next(iter(answers.values()))
    size = float(np.abs(reference).max())
    differences = {name: difference(reference, other) / size for name, other in answers.items()}
    for name, apart in differences.items():
        if not apart <= question.accuracy:
            raise ValueError(f"{question.name}: {name} differs by {apart:.1e}")
    seconds = {name: seconds_of(answer, budget) for name, answer in question.answers.items()}
    return Result(question, seconds, differences)


def difference(a: Array, b: Array) -> float:
    """Largest absolute difference; infinite when the shapes differ."""
    return float(np.abs(a - b).max()) if a.shape == b.shape else math.inf


def seconds_of(answer: Answer, budget: float, least: int = 3) -> float:
    """Median time of one call, over at least `least` batches and about `budget` seconds."""
    calls = max(1, round(0.002 / max(stopwatch(answer, 1), 1e-7)))
    batches: list[float] = []
    started = time.perf_counter()
    while len(batches) < least or time.perf_counter() - started < budget:
        batches.append(stopwatch(answer, calls) / calls)
    return float(np.median(batches))


def stopwatch(answer: Answer, calls: int) -> float:
    """Processor time of some calls in a row: it hardly suffers from other load."""
    started = time.process_time()
    for _ in range(calls):
        answer()
    return time.process_time() - started
