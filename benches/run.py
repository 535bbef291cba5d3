"""Holds the contest: all questions, or those named; `grid/rational` names a variant.

python benches/run.py [QUESTION ...] [--peers NAMES] [--threads 1,2] [--budget SECONDS] [--quick]
"""

from __future__ import annotations

import argparse
import importlib
import json
import os
import pkgutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any, cast

import contest
import machine
import questions
import table

HERE = Path(__file__).parent
PATIENCE = 300
"""Seconds after which a contender is stopped."""


def main() -> int:
    options = arguments()
    asked = list(chosen(options.questions))
    everyone = {name.split()[0] for about, variant in asked for name in contenders(about, variant)}
    record: dict[str, Any] = {
        "machine": machine.description(sorted(everyone)),
        "limits": {} if options.quick else machine.limits(),
        "titles": {name: title(name) for name, _ in asked},
        "results": [],
    }
    for name, variant in asked:
        for contender in contenders(name, variant):
            for threads in options.threads:
                if competes(name, variant, contender, threads, options.peers):
                    entry = held(name, variant, contender, threads, options.budget)
                    record["results"].append(entry)
                    print(table.line(entry), flush=True)
    options.json.parent.mkdir(exist_ok=True)
    options.json.write_text(json.dumps(record, indent=1) + "\n")
    print("\n" + table.text(record))
    return 0


def arguments() -> argparse.Namespace:
    known = ", ".join(sorted(names()))
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("questions", nargs="*", metavar="QUESTION", help=known)
    parser.add_argument("--peers", type=words, default=[], help="only these; ours is always there")
    parser.add_argument("--threads", type=whole_numbers, default=[1, 2], help="default: 1,2")
    parser.add_argument("--budget", type=float, default=0.5, help="seconds for each contender")
    parser.add_argument("--quick", action="store_true", help="one thread, no time to speak of")
    parser.add_argument("--json", type=Path, default=HERE / "results" / "latest.json")
    options = parser.parse_args()
    if options.quick:
        options.budget, options.threads = 0.0, [1]
    unknown = {name.split("/")[0] for name in options.questions} - names()
    if unknown:
        parser.error(f"no question {unknown.pop()}; there are {known}")
    return options


def words(text: str) -> list[str]:
    return text.split(",")


def whole_numbers(text: str) -> list[int]:
    return [int(word) for word in words(text)]


def names() -> set[str]:
    """The questions there are."""
    return {module.name for module in pkgutil.iter_modules(questions.__path__)}


def chosen(asked: list[str]) -> Iterator[tuple[str, str]]:
    """Questions and variants that are meant."""
    for name in sorted(asked or names()):
        question, _, part = name.partition("/")
        for variant in about(question).VARIANTS:
            if part in variant:
                yield question, variant


def about(name: str) -> contest.Questions:
    return cast(contest.Questions, importlib.import_module(f"questions.{name}"))


def title(name: str) -> str:
    """The question in a line."""
    return (about(name).__doc__ or "").splitlines()[0]


def contenders(name: str, variant: str) -> list[str]:
    """Who knows an answer, installed or not; ours first."""
    return list(smallest(name, variant).answers)


def smallest(name: str, variant: str) -> contest.Question:
    return about(name).question(variant, about(name).SIZES[-1])


def competes(name: str, variant: str, contender: str, threads: int, peers: list[str]) -> bool:
    library = contender.split()[0]
    alone = threads == 1 or library not in contest.PARALLEL
    if threads not in smallest(name, variant).threads or (alone and threads > 1):
        return False
    return not peers or library in ("pforms", *peers)


def held(name: str, variant: str, contender: str, threads: int, budget: float) -> dict[str, Any]:
    """Sends a contender into a process of its own."""
    entry: dict[str, Any] = {"question": name, "variant": variant, "contender": contender}
    entry["threads"] = threads
    command = [sys.executable, str(HERE / "worker.py"), name, variant, contender, str(threads)]
    pools = ("OMP", "OPENBLAS", "MKL", "RAYON")
    environment = os.environ | {f"{pool}_NUM_THREADS": str(threads) for pool in pools}
    try:
        worker = subprocess.run(
            [*command, str(budget)],
            capture_output=True,
            text=True,
            env=environment,
            timeout=PATIENCE,
            check=True,
        )
    except subprocess.TimeoutExpired:
        return entry | {"status": "failed", "note": f"took more than {PATIENCE} s"}
    except subprocess.CalledProcessError as stopped:
        return entry | {"status": "failed", "note": stopped.stderr.strip()[-200:]}
    entry.update(json.loads(worker.stdout.splitlines()[-1]))
    return entry


if __name__ == "__main__":
    sys.exit(main())
