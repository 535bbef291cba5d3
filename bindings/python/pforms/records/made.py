"""What is made, and how near it comes to what was meant."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from numpy import float64
    from numpy.typing import NDArray

    from pforms._pforms import Form, Spline


class Fit(NamedTuple):
    """A fitted form and how near it comes.

    >>> import pforms as pf
    >>> fit = pf.fit([(0, 0), (1, 2), (2, 4)], 2, params="uniform", report=True)
    >>> fit.form, fit.parameters[0].tolist()
    (<pforms.Form pL2 in 2D>, [0.0, 0.5, 1.0])
    """

    form: Form
    parameters: tuple[NDArray[float64], ...]
    """Those of the points, a list for each axis."""
    max_error: float
    """Largest distance between a point and the form at its parameters."""
    rms_error: float
    """Root of the mean square of these distances."""


class Bicubic(NamedTuple):
    """A polynomial patch and how far it is from the surface it stands for.

    >>> import pforms as pf
    >>> patch = pf.bezier_sphere(2)
    >>> patch.form, round(patch.error, 6)
    (<pforms.Form pS44 in 3D>, 0.001033)
    """

    form: Form
    error: float
    """The largest distance to the surface."""
    outside: float
    """How far it goes outside."""
    inside: float
    """How far it goes inside."""


class Minimal(NamedTuple):
    """A surface on a given boundary, and how near it is to a minimal one.

    >>> import pforms as pf
    >>> saddle = [[(x, y, x * y) for y in (-1, 0, 1)] for x in (-1, 0, 1)]
    >>> found = pf.minimal(pf.Form(saddle), report=True)
    >>> found.surface == pf.Form(saddle), round(found.area, 6), found.laplacian < 1e-15
    (True, 5.123157, True)
    """

    surface: Form | Spline
    area: float
    error: float
    """The true area differs by this much at most."""
    coons_area: float | None
    """The area of the Coons patch on the same boundary; None where its weights change sign."""
    energy: float
    """½∫|∇S|²: at least the area, and equal to it if the parameters keep angles."""
    laplacian: float
    """The root of the mean square of ΔS: 0 if the surface is harmonic."""
    curvature: float
    """The root of the mean square of the mean curvature: 0 if the surface is minimal."""
    slope: float
    """How much the area still falls with the free poles, as a part of it."""
    steps: int
    """Steps of a descent."""


class Network(NamedTuple):
    """A surface through a network of curves, and how well it keeps them.

    >>> import pforms as pf
    >>> us = [pf.Form([(0, 0), (1, 0)]), pf.Form([(0, 1), (1, 2)])]
    >>> vs = [pf.Form([(0, 0), (0, 1)]), pf.Form([(1, 0), (1, 2)])]
    >>> found = pf.gordon(us, vs, report=True)
    >>> found.surface, found.gap
    (<pforms.Form pS22 in 2D>, 0.0)
    """

    surface: Form | Spline
    """The surface."""
    error: float
    """Largest distance found between a curve and the surface at its parameter."""
    gap: float
    """Largest distance between two curves where they cross."""
    u: NDArray[float64]
    """The parameters of the curves along v."""
    v: NDArray[float64]
    """The parameters of the curves along u."""


class Parallel(NamedTuple):
    """A parallel form, or a shell, and how near it is to the true one.

    >>> import pforms as pf
    >>> found = pf.parallel(pf.Form([(0, 0), (1, 1), (2, 0)]), 0.1, report=True)
    >>> found.error <= 1e-6, found.gap
    (True, 0.0)
    """

    spline: Spline
    error: float
    """No point of the window is farther than this from its true place."""
    gap: float
    """Largest distance between pieces that met before: 0 unless there was a corner."""


class Pipe(NamedTuple):
    """A tube and how near it comes to the true one.

    >>> import pforms as pf
    >>> bend = pf.Form([(0, 0), (1, 0), (1, 1)])
    >>> tube = pf.pipe(bend, [(-0.1, 0), (0.1, 0)], report=True)
    >>> tube.error < 1e-7, round(tube.bending, 3)
    (True, 0.141)
    """

    spline: Spline
    """The parameter of the path first, then those of the section."""
    error: float
    """No point is further from that of the true tube at the same parameters: proved."""
    bending: float
    """Curvature times distance towards its centre, the most at samples: from 1 on it folds."""
    closing: float
    """The angle spread evenly over a closed path, so that its end meets its beginning."""


class Unrolling(NamedTuple):
    """A surface laid out flat, and the largest changes that made.

    >>> import pforms as pf
    >>> facet = pf.Form([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 1)]])
    >>> pf.unroll(facet, report=True).length > 0.01  # a saddle does not lie flat
    True
    """

    spline: Spline
    length: float
    """Of a length: how much its ratio differs from 1, over all directions."""
    angle: float
    """Of an angle between two directions, in radians."""
    area: float
    """Of an area: how much its ratio differs from 1."""


class UnitSpeed(NamedTuple):
    """A curve by its own length.

    >>> import pforms as pf
    >>> even = pf.by_arc_length(pf.Form([(0, 0), (3, 4)]), report=True)
    >>> even.length, even.error < 1e-9
    (5.0, True)
    """

    spline: Spline
    length: float
    error: float
    """How far its speed is from 1, at most, as measured."""


class Simplified(NamedTuple):
    """A spline with fewer knots, and how far its poles are from those it replaces.

    >>> import pforms as pf
    >>> halves = pf.Form([(0, 0), (1, 2), (2, 0)]).subdivide(1)
    >>> pf.remove_knots(halves, report=True)
    Simplified(spline=<pforms.Spline of 1 piece pL3 in 2D>, error=0.0)
    """

    spline: Spline
    error: float
    """How far a homogeneous pole is, at most, when the knots are inserted again."""


class Joined(NamedTuple):
    """Two forms made to meet.

    >>> import pforms as pf
    >>> f, g = pf.Form([(0, 0), (1, 0)]), pf.Form([(1, 1), (2, 0)])
    >>> round(pf.join_forms(f, g, 0).moved, 12)
    0.5
    """

    f: Form | Spline
    g: Form | Spline
    moved: float
    """The largest distance by which a pole was moved."""
