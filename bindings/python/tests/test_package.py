"""The package as a whole: names, errors, types, and how long it takes to import."""

import os
import pickle
import subprocess
import sys

import pytest

import pforms as pf

FAMILY = [
    "AccuracyError",
    "DegenerateError",
    "DomainError",
    "FormatError",
    "LimitError",
    "ShapeError",
]


def test_names_are_there_once_and_in_order():
    assert pf.__all__ == sorted(pf.__all__)
    assert all(hasattr(pf, name) for name in pf.__all__)
    public = {name for name in vars(pf) if not name.startswith("_")} - {
        "either",
        "errors",
        "files",
        "records",
        "sensitivity",
        "solids",
        "sparse",
    }
    assert public <= set(pf.__all__)
    assert pf.__version__.count(".") == 2


@pytest.mark.parametrize("name", FAMILY)
def test_errors_are_one_family(name):
    error = getattr(pf, name)
    assert issubclass(error, pf.PformsError)
    assert issubclass(error, ValueError)
    assert error.__module__ == "pforms"
    again = pickle.loads(pickle.dumps(error("what", "ever")))
    assert type(again) is error
    assert again.args == ("what", "ever")


def test_an_argument_of_the_wrong_type_is_a_type_error_too():
    assert issubclass(pf.ArgumentError, pf.ShapeError)
    assert issubclass(pf.ArgumentError, TypeError)


def run(code):
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return done.stdout


def test_imports_quickly():
    clock = "time.perf_counter()"
    code = f"import time, numpy; t = {clock}; import pforms; print({clock} - t)"
    # 60 ms beyond NumPy's own is the promise; a busy machine gets some mercy.
    mercy = 3 if os.getloadavg()[0] > os.cpu_count() else 1
    assert min(float(run(code)) for _ in range(5)) < 0.06 * mercy


def test_imports_nothing_but_numpy():
    code = """
import sys, numpy
before = set(sys.modules)
import pforms
print(*sorted(set(sys.modules) - before))
"""
    assert set(run(code).split()) - {"__future__"} == {
        "pforms",
        "pforms._pforms",
        "pforms.either",
        "pforms.errors",
        "pforms.files",
        "pforms.records",
        "pforms.records.drawn",
        "pforms.records.geodesics",
        "pforms.records.made",
        "pforms.records.measures",
        "pforms.records.planks",
        "pforms.records.searches",
        "pforms.sensitivity",
        "pforms.solids",
        "pforms.sparse",
    }


def test_stubs_say_what_is_there():
    stubtest = pytest.importorskip("mypy.stubtest")
    done = subprocess.run(
        [sys.executable, "-m", stubtest.__name__, "pforms", "--concise"],
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stdout + done.stderr
