"""pforms."""

from __future__ import annotations

import pforms as pf
from bernstein import Net
from contest import Array


def form(net: Net, threads: int = 1) -> pf.Form:
    """Makes a form, and lets the library use so many threads."""
    pf.set_threads(threads)
    return pf.Form(net.points, net.weights)


def poles(form: pf.Form, rational: bool) -> Array:
    """Poles as the peers keep them: with a weight only when rational."""
    return form.homogeneous if rational else form.poles
