"""Elevation of a surface along both axes."""

from __future__ import annotations

import numpy as np

import bernstein
import pforms as pf
from contest import Array, Question

ORDER, BY = 13, 4


def question() -> Question:
    """Poles of the elevated surface, homogeneous."""
    poles = bernstein.surface(np.random.default_rng(2), ORDER, ORDER)
    form = pf.Form.from_homogeneous(poles)

    def ours() -> Array:
        return form.elevate((BY, BY)).homogeneous

    def numpy() -> Array:
        matrix = bernstein.elevation(ORDER, BY)
        return np.einsum("ai,bj,ijc->abc", matrix, matrix, poles, optimize=True)

    return Question("elevate", (ORDER + BY) ** 2, "pole", {"pforms": ours, "numpy": numpy})
