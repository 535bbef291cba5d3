"""Every question at its smallest: pforms and NumPy give the right answer. Nothing is timed."""

import importlib
import pkgutil
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[1]))

import contest
import questions
import table

# These start other programs.
APART = {"browser", "start"}


def asked():
    for module in pkgutil.iter_modules(questions.__path__):
        about = importlib.import_module(f"questions.{module.name}")
        for variant in about.VARIANTS:
            if module.name not in APART:
                yield pytest.param(about, variant, id=f"{module.name}, {variant}")


@pytest.mark.parametrize(("about", "variant"), list(asked()))
def test_our_answer_is_right(about, variant):
    question = about.question(variant, about.SIZES[-1])
    ours = [name for name in question.answers if name.startswith("pforms")]
    assert ours
    for name in ours:
        work = question.answers[name](1)
        assert question.error(work.read(work.run())) <= question.accuracy


def test_a_wrong_answer_is_not_timed():
    about = importlib.import_module("questions.interpolate")
    with pytest.raises(contest.WrongError, match="differs by"):
        contest.hold(about, "curve of 40", "numpy", 1, 0.0)


def test_a_table_tells_ratios_and_limits():
    entry = {
        "question": "grid",
        "variant": "rational",
        "threads": 1,
        "status": "right",
        "unit": "point",
        "items": 1000,
        "stored": 24,
        "operations": 36,
        "error": 1e-16,
    }
    results = [
        entry | {"contender": "pforms", "median": 1e-6},
        entry | {"contender": "numpy", "median": 4e-6},
    ]
    limits = {"1": {"stores_again": 48e9, "stores": 24e9, "multiply_add": 48e9}}
    drawn = table.text({"results": results, "limits": limits})
    assert "4 ×" in drawn
    assert "75% arithmetic" in drawn
