"""A surface through a net of points."""

from __future__ import annotations

import numpy as np
from scipy.interpolate import make_interp_spline

import bernstein
import pforms as pf
from contest import Array, Question

ORDER = 8


def question() -> Question:
    """Points half-way between the nodes, of the surface through the net."""
    net = np.random.default_rng(5).uniform(-1.0, 1.0, (ORDER, ORDER, 3))
    nodes = np.linspace(0.0, 1.0, ORDER)

    def ours() -> Array:
        return pf.interpolate(net).poles

    def numpy() -> Array:
        basis = bernstein.values(ORDER, nodes)
        along_u = np.linalg.solve(basis, net.reshape(ORDER, -1)).reshape(net.shape)
        across = np.swapaxes(along_u, 0, 1)
        poles = np.linalg.solve(basis, across.reshape(ORDER, -1)).reshape(across.shape)
        return np.swapaxes(poles, 0, 1)

    def scipy() -> Array:
        along_u = make_interp_spline(nodes, net, k=ORDER - 1, axis=0).c
        across = make_interp_spline(nodes, np.swapaxes(along_u, 0, 1), k=ORDER - 1, axis=0).c
        return np.swapaxes(across, 0, 1)

    answers = {"pforms": ours, "numpy": numpy, "scipy": scipy}
    return Question("interpolate", ORDER * ORDER, "point", answers)
