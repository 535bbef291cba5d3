"""Holds the contest: all questions, or those named.

python benches/run.py [--budget SECONDS] [QUESTION ...]
"""

from __future__ import annotations

import argparse
import importlib
import json
import pkgutil
import sys
from pathlib import Path

import contest
import questions

HERE = Path(__file__).parent


def main() -> int:
    known = sorted(module.name for module in pkgutil.iter_modules(questions.__path__))
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("questions", nargs="*", metavar="QUESTION", help=", ".join(known))
    parser.add_argument("--budget", type=float, default=0.5, help="seconds for each contender")
    options = parser.parse_args()
    unknown = sorted(set(options.questions) - set(known))
    if unknown:
        parser.error(f"no question {unknown[0]}; there are {', '.join(known)}")

    results = []
    for name in options.questions or known:
        question = importlib.import_module(f"questions.{name}").question()
        results.append(contest.hold(question, options.budget))
    print(table(results))
    keep(results)
    return 0


def table(results: list[contest.Result]) -> str:
    """Draws one line per contender: time of a call, time of an item, ratio to pforms."""
    lines = [f"{'question':12} {'contender':10} {'call':>12} {'item':>18} {'ratio':>8}"]
    for result in results:
        question = result.question
        for name, seconds in result.seconds.items():
            call = f"{seconds * 1e6:.1f} µs"
            item = f"{seconds / question.items * 1e9:.1f} ns/{question.unit}"
            ratio = f"{result.ratio(name):.2f}"
            lines.append(f"{question.name:12} {name:10} {call:>12} {item:>18} {ratio:>8}")
    return "\n".join(lines)


def keep(results: list[contest.Result]) -> None:
    """Writes the seconds per call where a later run can compare."""
    folder = HERE / "results"
    folder.mkdir(exist_ok=True)
    numbers = {result.question.name: dict(result.seconds) for result in results}
    (folder / "latest.json").write_text(json.dumps(numbers, indent=2) + "\n")


if __name__ == "__main__":
    sys.exit(main())
