"""A rational bicubic surface, sampled on a fine grid."""

from __future__ import annotations

import numpy as np
from scipy.interpolate import BPoly

import bernstein
import pforms as pf
from contest import Array, Question

SIDE = 400


def question() -> Question:
    """Points of the surface at SIDE × SIDE parameters."""
    poles = bernstein.surface(np.random.default_rng(1), 4, 4)
    form = pf.Form.from_homogeneous(poles)
    at = np.linspace(0.0, 1.0, SIDE)

    def ours() -> Array:
        return form.grid(at, at)

    def numpy() -> Array:
        basis = bernstein.values(4, at)
        points = np.einsum("ui,vj,ijc->uvc", basis, basis, poles, optimize=True)
        return points[..., :3] / points[..., 3:]

    def scipy() -> Array:
        curves = BPoly(poles[:, None], [0.0, 1.0])(at)
        points = BPoly(np.moveaxis(curves, 1, 0)[:, None], [0.0, 1.0])(at)
        points = np.moveaxis(points, 0, 1)
        return points[..., :3] / points[..., 3:]

    answers = {"pforms": ours, "numpy": numpy, "scipy": scipy}
    return Question("grid", SIDE * SIDE, "point", answers)
