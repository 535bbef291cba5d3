"""Importing a library in a fresh interpreter, and its first point of a bicubic surface."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Mapping

import numpy as np

from contest import Answer, Question, Report, Work, apart_from

VARIANTS = ("import", "import and first point")
SIZES = (1,)

NET = "net = [[[i, j, i * j] for j in range(4)] for i in range(4)]"
KNOTS = "knots = [0.0] * 4 + [1.0] * 4"

# What is imported, what is made ready, and the point at (0.3, 0.4).
SCRIPTS: Mapping[str, tuple[str, str, str]] = {
    "pforms": ("import pforms", NET, "pforms.Form(net)(0.3, 0.4)"),
    "numpy": (
        "import numpy",
        f"{NET}; b = lambda t: [(1-t)**3, 3*t*(1-t)**2, 3*t*t*(1-t), t**3]",
        "numpy.einsum('i,j,ijk', b(0.3), b(0.4), numpy.array(net))",
    ),
    "scipy": (
        "from scipy.interpolate import NdBSpline",
        f"import numpy; {NET}; {KNOTS}",
        "NdBSpline((knots, knots), numpy.array(net, float), 3)([[0.3, 0.4]])[0]",
    ),
    "ndsplines": (
        "import ndsplines",
        f"import numpy; {NET}; {KNOTS}",
        "ndsplines.NDSpline([numpy.array(knots)] * 2, numpy.array(net, float), [3, 3])"
        "(numpy.array([[0.3, 0.4]]))[0]",
    ),
    "splinepy": (
        "import splinepy",
        "net = [[i, j, i * j] for j in range(4) for i in range(4)]",
        "splinepy.Bezier(degrees=[3, 3], control_points=net).evaluate([[0.3, 0.4]])[0]",
    ),
    "geomdl": (
        "from geomdl import BSpline",
        f"{NET}; {KNOTS}; s = BSpline.Surface(); s.degree_u = s.degree_v = 3; "
        "s.set_ctrlpts([pole for row in net for pole in row], 4, 4); "
        "s.knotvector_u = s.knotvector_v = knots",
        "s.evaluate_single((0.3, 0.4))",
    ),
    "occt": (
        "from OCP.Geom import Geom_BezierSurface",
        "from OCP.collections import Array2_gp_Pnt; from OCP.gp import gp_Pnt; "
        "a = Array2_gp_Pnt(1, 4, 1, 4); "
        "[a.SetValue(i+1, j+1, gp_Pnt(i, j, i*j)) for i in range(4) for j in range(4)]",
        "(lambda p: (p.X(), p.Y(), p.Z()))(Geom_BezierSurface(a).Value(0.3, 0.4))",
    ),
}

PROGRAM = """
from time import process_time
started = process_time()
{imported}
loaded = process_time()
{ready}
begun = process_time()
point = {point}
ended = process_time()
print(loaded - started, ended - begun, *point)
"""


def question(variant: str, _: int) -> Question:
    # The point of the net z = i·j over the lattice is where its parameters say.
    truth = np.array([0.9, 1.2, 1.08])
    answers = {name: in_fresh_interpreter(name, variant) for name in SCRIPTS}
    return Question(1, "start", answers, apart_from(lambda: truth), threads=(1,))


def in_fresh_interpreter(name: str, variant: str) -> Answer:
    imported, ready, point = SCRIPTS[name]
    program = PROGRAM.format(imported=imported, ready=ready, point=point)

    def run() -> Report:
        command = [sys.executable, "-c", program]
        words = subprocess.run(command, check=True, capture_output=True, text=True).stdout.split()
        to_import, to_point, *place = map(float, words)
        return Report(to_import if variant == "import" else to_import + to_point, place)

    return lambda _: Work(run)
