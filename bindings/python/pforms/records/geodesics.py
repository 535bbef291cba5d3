"""Straight lines of surfaces."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from numpy import float64
    from numpy.typing import NDArray

    from pforms._pforms import Spline


class Geodesic(NamedTuple):
    """A straight line on a surface.

    >>> import pforms as pf
    >>> line = pf.geodesic(pf.Form([[(0, 0), (0, 1)], [(1, 0), (1, 1)]]), (0, 0), 0.0, 2)
    >>> round(line.length, 12), line.ending, line.end.tolist()
    (1.0, 'border', [1.0, 0.0])
    """

    spline: Spline
    """In space, over its length."""
    parameters: Spline
    """In the parameters of the surface, over its length; where it crosses a seam it has a gap."""
    length: float
    error: float
    """No point is farther from that of the true geodesic."""
    ending: str
    """Why it ends: "length", "border", "collapsed" (an edge as a point), "singular", "torn"."""
    end: NDArray[float64]
    """The parameters where it ends."""
    point: NDArray[float64]
    """The point where it ends."""
    direction: NDArray[float64]
    """Its unit direction there."""
    conjugate: float | None
    """The length from which on there are shorter ways, to first order."""
    crease: float
    """The largest angle between the sides of a knot or seam that it crosses, in radians."""
    steps: int
    """Steps of the integration."""


class Geodesics(NamedTuple):
    """Where many straight lines of a surface end.

    >>> import pforms as pf
    >>> square = pf.Form([[(0, 0), (0, 1)], [(1, 0), (1, 1)]])
    >>> pf.geodesic(square, [(0, 0), (0.5, 0)], 0.0, 2).points.round(9).tolist()
    [[1.0, 0.0], [1.0, 0.0]]
    """

    parameters: NDArray[float64]
    """Of the ends, shape (…, 2)."""
    points: NDArray[float64]
    """The ends, shape (…, c)."""
    directions: NDArray[float64]
    """Unit directions there, shape (…, c)."""
    lengths: NDArray[float64]
    errors: NDArray[float64]
    """How far the points may be from the true ones."""
    endings: list[str]
    """Why each ends, in the order of the starts."""
    steps: int
    """Steps of all of them together."""


class Connection(NamedTuple):
    """A straight line between two points of a surface.

    >>> import pforms as pf
    >>> way = pf.geodesic_between(pf.Form([[(0, 0), (0, 1)], [(1, 0), (1, 1)]]), (0, 0), (1, 0))
    >>> round(way.length, 9), way.minimality
    (1.0, 'proved')
    """

    geodesic: Geodesic | None
    """The line; None when both points are the same."""
    length: float
    gap: float
    """How far it ends from the point it was to reach."""
    minimality: str
    """ "proved" (it is straight), "local", "family" (there may be many), "not"."""
