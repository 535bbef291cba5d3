"""Whatever is given comes back as a result or an ordinary error: never a panic, never a hang."""

import faulthandler
import inspect
import random
import resource
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

import pforms as pf

FORMS = [
    pf.Form((1, 2, 3)),
    pf.Form([(0, 0), (1, 1)]),
    pf.Form([(1, 0), (0, 1), (-1, 0)], [1, 0, 1]),
    pf.Form([(1,), (2,)], [1, -1]),
    pf.Form(np.zeros((1, 1, 3))),
    pf.Form(np.arange(24.0).reshape(2, 4, 3)),
    pf.Form(np.ones((2, 2, 2, 3)), np.zeros((2, 2, 2))),
    pf.Form(np.linspace(0, 1e300, 27).reshape(3, 3, 3)),
    pf.Form(np.full((3, 2), 5e-324)),
    pf.Form(np.ones((1,) * 6 + (2,))),
    pf.sphere(1, part="octant").subdivide(1),
    pf.Form([(0, 0, 0), (1, 2, 0), (3, 1, 1)]).subdivide(1),
    pf.cube((2, 2, 2), 1.0),
    pf.Mesh.of(
        [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]
    ),
]
LAZY = pf.immerse(pf.Form([(0, 0), (1, 1)]), pf.facet(2, 1.0, ambient=2), lazy=True)
JUNK = [
    None, True, 0, 1, 2, 3, -1, 7, 10**6, 10**18, 2**64, -(2**70), 10**400, 0.0, 0.5, -0.5, 1e308,
    -1e-320,
    float("nan"), float("inf"), -float("inf"), 1j, "all", "", "uniform", "pS33", "x" * 1000,
    b"bytes", bytearray(2),
    object(), int, pf.Form, print, ..., NotImplemented, Fraction(1, 3), (), [], {}, set(), [[]],
    [None], ["a"],
    [1], (0, 1), (1, 0), (0, 0), [0.5, 0.5], [0, 1, 2], [1, [2, 3]], [[1, 2], [3]], [[[1]]],
    [np.nan, 1],
    np.zeros(0), np.zeros((0, 3)), np.zeros((3, 0)), np.zeros(()), np.ones(3), np.ones((2, 2)),
    np.ones((1,) * 30),
    np.array([1, 2], "i8"), np.array(["a"]), np.array([None, 1], object), np.array([1, 2], "c16"),
    np.ones(2, "?"),
    np.array(["2020-01-01"], "M8[D]"), np.ma.masked_array([1.0, 2], [True, False]), np.ones((2,
    3)).T,
    np.broadcast_to(0.5, (10**5, 10**5)), np.float32(0.5), np.int8(-3), range(3), iter([1, 2]),
    memoryview(b"ab"),
    *FORMS,
]  # fmt: skip
EXEMPT = {
    "cap": "takes nothing",
    "threads": "takes nothing",
    "set_cap": "would change what the others may use",
    "set_threads": "would change how the others run",
    "draw": "would write files",
    "load": "would read files, and numbers are open ones",
    "save": "would write files",
}
CLASSES = {"Embedding", "Form", "Immersed", "Sheet", "Spline"}
NAMES = [
    name
    for name in pf.__all__
    if callable(getattr(pf, name))
    and name not in EXEMPT
    and (name in CLASSES or not isinstance(getattr(pf, name), type))
]
METHODS = [
    (kind, name)
    for kind in (pf.Form, pf.Spline, pf.Immersed)
    for name, member in vars(kind).items()
    if not name.startswith("_") and inspect.isroutine(member) and name != "save"
]
KEYWORDS = ["axes", "out", "kind", "unit", "weights", "params", "tolerance", "side", "accuracy"]
WORDS = ["whole", "outer", "frenet", "area", "sponge", "clamped", "gaussian", "union"]


@pytest.fixture(autouse=True, scope="module")
def _bounded():
    """A result may take 64 MB, the process 4 GB more; what hangs is shown and ended."""
    kept, (soft, hard) = pf.cap(), resource.getrlimit(resource.RLIMIT_AS)
    pf.set_cap(1 << 26)
    used = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (used + (4 << 30), hard))
    yield
    resource.setrlimit(resource.RLIMIT_AS, (soft, hard))
    pf.set_cap(kept)


@pytest.fixture(autouse=True)
def _watched():
    faulthandler.dump_traceback_later(300, exit=True)
    yield
    faulthandler.cancel_dump_traceback_later()


def attempt(call, *arguments, **options):
    try:
        result = call(*arguments, **options)
    except (ValueError, TypeError) as error:
        said = str(error)
    except (OverflowError, AttributeError):
        # Raised by Python itself on what it was given for a bare number or a map.
        said = "" if call in (pf.immerse_points, pf.with_pole, pf.Form.with_pole) else "defect"
    else:
        assert not holds_nan(result), (call, arguments, options)
        return
    assert "defect" not in said, (call, arguments, options)


def holds_nan(result):
    if isinstance(result, np.ndarray):
        return result.dtype.kind == "f" and bool(np.isnan(result).any())
    if isinstance(result, tuple | list):
        return any(holds_nan(item) for item in result)
    return isinstance(result, float) and result != result


def keywords(call):
    parameters = inspect.signature(call).parameters.values()
    return [one.name for one in parameters if one.kind is one.KEYWORD_ONLY] + KEYWORDS


def bombard(call, dice, first, times):
    own = keywords(call)
    for _ in range(times):
        arguments = [dice.choice(JUNK) for _ in range(dice.randrange(5))]
        if dice.random() < 0.8:
            arguments.insert(0, first())
        if dice.random() < 0.2:
            arguments.insert(1, dice.choice(FORMS))
        options = {}
        if dice.random() < 0.4:
            options[dice.choice(own)] = dice.choice(JUNK + WORDS)
        attempt(call, *arguments, **options)


@pytest.mark.parametrize("name", NAMES)
def test_no_argument_can_break_it(name):
    dice = random.Random(name)
    call = getattr(pf, name)
    for junk in JUNK:
        attempt(call, junk)
    bombard(call, dice, lambda: dice.choice(FORMS), 200)


@pytest.mark.parametrize(
    ("kind", "name"), METHODS, ids=lambda item: getattr(item, "__name__", item)
)
def test_no_argument_can_break_a_method(kind, name):
    dice = random.Random(f"{kind.__name__}.{name}")
    subjects = [form for form in [*FORMS, LAZY] if isinstance(form, kind)]
    if not callable(getattr(subjects[0], name)):
        return
    bombard(getattr(kind, name), dice, lambda: dice.choice(subjects), 60)


@pytest.mark.parametrize("name", sorted(EXEMPT))
def test_what_is_left_out_is_there(name):
    assert callable(getattr(pf, name))


@pytest.mark.parametrize("form", [f for f in FORMS if isinstance(f, pf.Form)], ids=repr)
def test_nothing_breaks_a_call(form):
    dice = random.Random(repr(form))
    attempt(form)
    for junk in JUNK:
        attempt(form, *[junk] * form.axes)
        attempt(form.subdivide(1), *[junk] * form.axes)
    for _ in range(200):
        attempt(form, *[dice.choice(JUNK) for _ in range(form.axes)])


def test_a_list_inside_itself_is_refused():
    endless = []
    endless.append(endless)
    with pytest.raises(pf.PformsError):
        pf.Form(endless)


def test_ragged_lists_are_named_with_their_lengths():
    with pytest.raises(
        pf.ShapeError, match=r"^poles: received lists of lengths \[3, 2\] at depth 1"
    ):
        pf.Form([(1, 2, 3), (4, 5)])
    with pytest.raises(pf.ShapeError, match=r"lengths \[2, 1\] at depth 1"):
        pf.Form([[(1, 2), (3, 4)], [(5, 6)]])
    with pytest.raises(pf.ShapeError, match=r"^weights: received lists of lengths \[2, 1\]"):
        pf.Form([[(1,), (2,)], [(3,), (4,)]], [[1, 2], [3]])
    with pytest.raises(pf.ShapeError, match=r"^parameters: received lists of lengths"):
        pf.Form([(1, 2), (3, 4)])([[0, 1], [0]])


@pytest.mark.parametrize(
    ("poles", "weights", "error"),
    [
        ([], None, pf.ShapeError),
        ([[]], None, pf.ShapeError),
        (np.zeros((0, 3)), None, pf.ShapeError),
        (3, None, pf.ShapeError),
        ([(1, np.nan)], None, pf.DomainError),
        ([(1, np.inf)], None, pf.DomainError),
        ([(1, 2)], [np.nan], pf.DomainError),
        ([(1e300, 2)], [1e300], pf.DomainError),
        ([(1, 2)], [1, 2], pf.ShapeError),
        ([(1, 2)], 1, pf.ShapeError),
        (None, None, pf.ArgumentError),
        ("poles", None, pf.ArgumentError),
        ([("a", "b")], None, pf.ArgumentError),
        ([(1j, 2)], None, pf.ArgumentError),
        ([(1, 2)], "heavy", pf.ArgumentError),
        (pf.Form([(1, 2)]), None, pf.ArgumentError),
    ],
)
def test_what_is_no_net_is_refused(poles, weights, error):
    with pytest.raises(error, match="(poles|weights): received .*, expected"):
        pf.Form(poles, weights)


@pytest.mark.parametrize(
    "array", [[1.0], [[1.0]], 1.0, [], None, "x", [(1, np.nan)], [(1, 2), (1,)]]
)
def test_what_is_no_homogeneous_net_is_refused(array):
    with pytest.raises(pf.PformsError, match="(array|poles): received"):
        pf.Form.from_homogeneous(array)
