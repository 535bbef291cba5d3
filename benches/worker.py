"""One contender answers one question, in a process of its own, and prints a line of JSON.

python benches/worker.py QUESTION VARIANT CONTENDER THREADS BUDGET
"""

from __future__ import annotations

import importlib
import json
import os
import sys
from dataclasses import asdict

import contest


def main() -> None:
    name, variant, contender, threads, budget = sys.argv[1:]
    pin(int(threads))
    about = importlib.import_module(f"questions.{name}")
    print(json.dumps(outcome(about, variant, contender, int(threads), float(budget))), flush=True)
    # Some libraries crash while they unload.
    os._exit(0)


def pin(threads: int) -> None:
    """Keeps the process on as many processors as it may use."""
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, sorted(os.sched_getaffinity(0))[:threads])


def outcome(
    about: contest.Questions, variant: str, contender: str, threads: int, budget: float
) -> dict[str, object]:
    """What there is to say: numbers, or why there are none."""
    try:
        result = contest.hold(about, variant, contender, threads, budget)
    except (ImportError, contest.MissingError) as reason:
        return {"status": "missing", "note": str(reason)}
    except contest.WrongError as reason:
        return {"status": "wrong", "note": str(reason)}
    except Exception as reason:
        return {"status": "failed", "note": f"{type(reason).__name__}: {reason}"[:200]}
    return {"status": "right", **asdict(result)}


if __name__ == "__main__":
    main()
