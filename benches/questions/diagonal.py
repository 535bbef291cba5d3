"""The diagonal curve of a surface."""

from __future__ import annotations

import numpy as np

import bernstein
import pforms as pf
from contest import Array, Question

ORDER = 14


def question() -> Question:
    """Poles of the diagonal, homogeneous."""
    poles = bernstein.surface(np.random.default_rng(3), ORDER, ORDER)
    form = pf.Form.from_homogeneous(poles)

    def ours() -> Array:
        return form.diagonal().homogeneous

    def numpy() -> Array:
        return bernstein.diagonal(poles)

    return Question("diagonal", 2 * ORDER - 1, "pole", {"pforms": ours, "numpy": numpy})
