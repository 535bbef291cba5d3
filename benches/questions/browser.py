"""The same works in WebAssembly, as browsers run it, and natively, with one thread.

The answers must be the same to the last bit.
"""

from __future__ import annotations

import subprocess
from collections.abc import Callable
from pathlib import Path

import numpy as np

from contest import Array, MissingError, Question, Report, Work
from machine import ROOT

# In the order of `native/works.rs`.
WORKS = {
    "grid": 1_000_000,
    "scattered surface": 100_000,
    "scattered volume": 100_000,
    "pL4 in pS44": 1,
    "pS22 in pS44": 1,
    "pS44 in pV222": 1,
    "pV222 in pV333": 1,
    "pV444 in pV444": 1,
}
VARIANTS = tuple(f"{kind} {work}" for work in WORKS for kind in ("polynomial", "rational"))
SIZES = (1,)

PASSES = 10
NATIVE = ROOT / "target" / "release" / "measure"
MODULE = ROOT / "target" / "works.wasm"
SCRIPT = ROOT / "benches" / "native" / "run.mjs"


def question(variant: str, _: int) -> Question:
    number = str(VARIANTS.index(variant))
    items = WORKS[variant.split(maxsplit=1)[1]]

    def native(_: int) -> Work:
        return Work(measured(NATIVE, number))

    def node(_: int) -> Work:
        # The optimising compiler at once, as a browser comes to use it for what runs often.
        return Work(measured(MODULE, number, "node", "--no-liftoff", str(SCRIPT)))

    def error(answer: Array) -> float:
        return 0.0 if np.array_equal(answer, native(1).run().answer) else np.inf

    unit = "immersion" if items == 1 else "point"
    answers = {"pforms": native, "pforms in WebAssembly": node}
    return Question(items, unit, answers, error, accuracy=0.0, threads=(1,))


def measured(program: Path, number: str, *before: str) -> Callable[[], Report]:
    """Runs a program that prints seconds and a sum."""

    def run() -> Report:
        if not program.exists():
            raise MissingError(f"no {program.relative_to(ROOT)}")
        command = [*before, str(program), number, str(PASSES)]
        printed = subprocess.run(command, check=True, capture_output=True, text=True).stdout
        seconds, *answer = map(float, printed.split())
        return Report(seconds, answer)

    return run
