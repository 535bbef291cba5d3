"""What searches find: nearest points, places, contacts; and whether that is all."""

from __future__ import annotations

import itertools
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from numpy import bool_, float64, int64, uint8
    from numpy.typing import NDArray

    from pforms._pforms import Spline


class Projection(NamedTuple):
    """Nearest points of a form, and how sure that is.

    >>> import pforms as pf
    >>> foot = pf.project(pf.Form([(0, 0), (4, 0)]), (1, 3))
    >>> foot.parameters, foot.points, foot.distances
    (array([0.25]), array([1., 0.]), array(3.))
    >>> bool(foot.unique), bool(foot.gaps < 1e-13)
    (True, True)
    """

    parameters: NDArray[float64]
    """Those of the feet, one for each axis: shape (…, axes)."""
    points: NDArray[float64]
    """The feet: shape (…, c)."""
    distances: NDArray[float64]
    """From the points to their feet."""
    gaps: NDArray[float64]
    """By how much any other point of the form may be nearer, at most: proved."""
    unique: NDArray[bool_]
    """Is it proved that only these parameters give the nearest point?"""


class Feet(NamedTuple):
    """All feet of points on a form: places from which no way leads nearer at first order.

    >>> import pforms as pf
    >>> feet = pf.project(pf.Form([(-1, 1), (0, -1), (1, 1)]), [(0, 0.75), (5, 1)], all=True)
    >>> feet.kinds, feet.starts
    (('minimum', 'maximum', 'minimum', 'minimum'), array([0, 3, 4]))
    >>> bool(feet.complete.all())
    True
    """

    parameters: NDArray[float64]
    """Those of all feet, point after point: shape (k, axes)."""
    points: NDArray[float64]
    """The feet: shape (k, c)."""
    distances: NDArray[float64]
    """From the points to the feet: shape (k,)."""
    kinds: tuple[str, ...]
    """How the distance changes around each: ``minimum``, ``maximum``, ``saddle`` or ``flat``."""
    errors: NDArray[float64]
    """By how much the parameters may be off, at most, where they are proved."""
    proved: NDArray[bool_]
    """Is it proved that there is a foot within the error, and no other?"""
    starts: NDArray[int64]
    """The feet of point i are those from ``starts[i]`` to ``starts[i + 1]``: shape (n + 1,)."""
    complete: NDArray[bool_]
    """For each point: are these surely all?"""
    doubts: NDArray[float64]
    """Boxes of parameters where that is not decided, by two corners: shape (j, 2, axes)."""
    doubtful: NDArray[int64]
    """The point of each box: shape (j,)."""


class Inversion(NamedTuple):
    """All parameters at which a form goes through points.

    >>> import pforms as pf
    >>> back = pf.Form([(0, 0), (1, 1), (0, 0)])  # to (1/2, 1/2) and back
    >>> found = pf.invert(back, [(0.375, 0.375), (1, 1)])
    >>> found.parameters.T, found.starts, found.inside
    (array([[0.25, 0.75]]), array([0, 2, 2]), array([ True, False]))
    """

    parameters: NDArray[float64]
    """Those of all places, point after point: shape (k, axes)."""
    distances: NDArray[float64]
    """How far the form is from the point there: shape (k,)."""
    errors: NDArray[float64]
    """By how much the parameters may be off, at most, where they are proved."""
    proved: NDArray[bool_]
    """Is it proved that there is no other place within the error?"""
    starts: NDArray[int64]
    """The places of point i are those from ``starts[i]`` to ``starts[i + 1]``: shape (n + 1,)."""
    inside: NDArray[bool_]
    """For each point: does the form go through it?"""
    complete: NDArray[bool_]
    """For each point: are these surely all?"""
    doubts: NDArray[float64]
    """Boxes of parameters where that is not decided, by two corners: shape (j, 2, axes)."""
    doubtful: NDArray[int64]
    """The point of each box: shape (j,)."""


class Intersection(NamedTuple):
    """Where two forms meet, and whether that is all.

    >>> import pforms as pf
    >>> arch = pf.Form([(0, 0), (0.5, 1), (1, 0)])
    >>> found = pf.intersect(arch, [(0, 0.5), (1, 0.5)])
    >>> found.points, found.kinds, found.orders, found.complete
    (array([[0.5, 0.5]]), ('tangent',), array([2]), True)
    """

    first: NDArray[float64]
    """Parameters in the first form: shape (k, axes)."""
    second: NDArray[float64]
    """Parameters in the second form: shape (k, axes)."""
    points: NDArray[float64]
    """The points: shape (k, c)."""
    kinds: tuple[str, ...]
    """For each ``crossing``, ``tangent`` or ``touch``."""
    orders: NDArray[int64]
    """How many crossings fall together: 1 for a crossing; 0 where that is not known."""
    gaps: NDArray[float64]
    """The distances of the forms there; 0 where they are proved to meet."""
    errors: NDArray[float64]
    """By how much a parameter may be off, at most."""
    proved: NDArray[bool_]
    """Is it proved that they meet there, and once?"""
    overlaps: tuple[Overlap, ...]
    """Arcs in common."""
    curves: tuple[Branch, ...]
    """Curves in which two surfaces meet."""
    complete: bool
    """Is that surely all?"""
    undecided: tuple[tuple[NDArray[float64], NDArray[float64]], ...]
    """Boxes of parameters of both forms, lower and upper corners, that may hold more."""


class Overlap(NamedTuple):
    """A part that two forms share.

    >>> import pforms as pf
    >>> found = pf.intersect([(0, 0), (4, 0)], [(3, 0), (-1, 0)])
    >>> overlap, = found.overlaps
    >>> overlap.first[:, 0], overlap.second[:, 0]
    (array([0.  , 0.75]), array([0.75, 0.  ]))
    """

    first: NDArray[float64]
    """From and to in the parameters of the first form: shape (2, axes)."""
    second: NDArray[float64]
    """The same points in the parameters of the second form."""
    gap: float
    """How far the forms are apart along it, at most."""
    proved: bool
    """Is it proved that they are the same?"""


class Branch(NamedTuple):
    """A curve in which two surfaces meet.

    >>> import pforms as pf
    >>> pf.Branch._fields
    ('first', 'second', 'curve', 'error', 'closed', 'tangent')
    """

    first: Spline
    """In the parameters of the first surface."""
    second: Spline
    """In the parameters of the second surface."""
    curve: Spline
    """In space."""
    error: float
    """How far it may be from either surface, at most."""
    closed: bool
    """Does it end where it begins?"""
    tangent: bool
    """Do the surfaces touch along it?"""


class Crossings(NamedTuple):
    """Where the forms of many pairs meet.

    >>> import pforms as pf
    >>> found = pf.intersect_many([[(0, 0), (1, 1)]], [[(0, 1), (1, 0)]])
    >>> found.pairs()
    [array([[0.5, 0.5]])]
    """

    parameters: NDArray[float64]
    """In the first form, then in the second: shape (k, axes of both)."""
    starts: NDArray[int64]
    """Those of pair i are ``starts[i]`` to ``starts[i + 1]``."""
    kinds: NDArray[uint8]
    """0 for a crossing, 1 for a tangent, 2 for a touch."""
    errors: NDArray[float64]
    """By how much a parameter may be off, at most."""
    complete: NDArray[bool_]
    """For each pair: is that surely all?"""
    whole: dict[int, Intersection]
    """The whole answer for pairs that share more than points."""

    def pairs(self) -> list[NDArray[float64]]:
        """For each pair its parameters, shape (k, axes of both)."""
        ends = self.starts.tolist()
        return [self.parameters[i:j] for i, j in itertools.pairwise(ends)]
