"""Whatever is given comes back as a result or an ordinary error: never a panic, never a hang."""

import random
from fractions import Fraction

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
]
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
NAMES = [
    "bernstein", "blossom", "combine", "coons", "curvature", "derivative", "diagonal", "elevate",
    "evaluate", "explain",
    "fit", "frame", "gordon", "grid", "hodograph", "immerse", "immerse_points", "interpolate",
    "midpoint", "normals",
    "partition", "pascal", "polyline", "reduce", "reparametrise", "reverse", "segment", "split",
    "stack",
    "stretch", "sub", "subdivide", "tile", "transpose", "whole_line", "with_pole", "Form",
    "Immersed",
    "cube", "extrude", "facet", "line", "ruled", "symmetric",
    "mirror", "project_to_plane", "rotate", "scale", "shear", "transform", "translate",
    "geodesic", "geodesic_between",
    "is_developable", "offset_poles", "parallel", "shell", "tangent_developable", "unroll",
]  # fmt: skip
KEYWORDS = [
    "axes",
    "derivative",
    "out",
    "kind",
    "unit",
    "weights",
    "nodes",
    "homogeneous",
    "lazy",
    "params",
    "ends",
    "tolerance",
    "side",
    "folds",
    "report",
    "accuracy",
]


def attempt(call, *arguments, **options):
    try:
        call(*arguments, **options)
    except (ValueError, TypeError) as error:
        said = str(error)
    except (OverflowError, AttributeError):
        # Raised by Python itself on what it was given for a bare number or a map.
        said = "" if call in (pf.immerse_points, pf.Form.with_pole) else "defect"
    else:
        return
    assert "defect" not in said, (call, arguments, options)


@pytest.mark.parametrize("name", NAMES)
def test_no_argument_can_break_it(name):
    dice = random.Random(name)
    call = getattr(pf, name)
    for junk in JUNK:
        attempt(call, junk)
    for _ in range(400):
        arguments = [dice.choice(JUNK) for _ in range(dice.randrange(5))]
        if dice.random() < 0.8:
            arguments.insert(0, dice.choice(FORMS))
        options = {dice.choice(KEYWORDS): dice.choice(JUNK)} if dice.random() < 0.3 else {}
        attempt(call, *arguments, **options)


@pytest.mark.parametrize("form", FORMS, ids=repr)
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
