"""A trilinear volume immersed in a triquadratic one: pV222 in pV333 is a pV777.

The peer samples the composition at Chebyshev nodes and solves for the poles, as one does without an
exact product of forms.
"""

from __future__ import annotations

import numpy as np

import bernstein
import pforms as pf
from contest import Array, Question


def question() -> Question:
    """Poles of the immersed volume, homogeneous."""
    rng = np.random.default_rng(4)
    inner = rng.uniform(0.0, 1.0, (2, 2, 2, 3))
    host = bernstein.surface(rng, 3, 3, 3)
    inner_form = pf.Form(inner)
    host_form = pf.Form.from_homogeneous(host)
    nodes = bernstein.chebyshev(7)

    def ours() -> Array:
        return pf.immerse(inner_form, host_form).homogeneous

    def numpy() -> Array:
        basis = bernstein.values(2, nodes)
        solve = np.linalg.inv(bernstein.values(7, nodes))
        places = np.einsum("ai,bj,ck,ijkx->xabc", basis, basis, basis, inner, optimize=True)
        x, y, z = (bernstein.values(3, place) for place in places)
        samples = np.einsum("abci,abcj,abck,ijkx->abcx", x, y, z, host, optimize=True)
        return np.einsum("ia,jb,kc,abcx->ijkx", solve, solve, solve, samples, optimize=True)

    return Question("immerse", 7**3, "pole", {"pforms": ours, "numpy": numpy})
