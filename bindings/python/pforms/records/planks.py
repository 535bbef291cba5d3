"""Boards on surfaces."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from numpy import float64
    from numpy.typing import NDArray

    from pforms._pforms import Form, Spline


class Marks(NamedTuple):
    """Where other boards cross one, in the order of the distance.

    >>> import pforms as pf
    >>> flat = pf.Form([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]])
    >>> boards = pf.planks(flat, [[(0, 0.25), (1, 0.25)], [(0.5, 0), (0.5, 1)]], 0.1)
    >>> boards[0].marks.at.round(9).tolist(), boards[1].marks.at.round(9).tolist()
    ([0.5], [0.25])
    """

    others: list[int]
    """Which of the lines each is that of."""
    at: NDArray[float64]
    """Distances along the axis."""
    other_at: NDArray[float64]
    """Distances along the axes of the others."""
    angles: NDArray[float64]
    """From this axis to that of the other, counterclockwise seen from the normal, in radians."""
    errors: NDArray[float64]
    """By how much the distances may be off, for the lines given."""


class Plank(NamedTuple):
    """A thin straight board on a surface.

    >>> import pforms as pf
    >>> flat = pf.Form([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]])
    >>> board = pf.planks(flat, [(0, 0.5), (1, 0.5)], 0.1)
    >>> round(board.length, 12), board.bend, board.strip(0.5, 0.5).round(9).tolist()
    (1.0, 0.0, [0.5, 0.5, 0.0])
    """

    strip: Spline
    """In space: along it by its length, across it from 0 on the right to 1 on the left."""
    line: Spline
    """Its axis in space, by its length."""
    axis: Form
    """Its axis laid flat: from the origin along x."""
    outline: Spline
    """Its outline laid flat: a closed line round the four corners."""
    length: float
    """Of the axis."""
    marks: Marks
    """Where other boards cross it."""
    complete: bool
    """Is it sure that no other crossing is missing?"""
    overlaps: list[int]
    """Other lines of which a part is a part of its own."""
    bend: float
    """The largest curvature it is bent to, one over the least radius."""
    twist: float
    """The largest torsion of its axis: how much its normal turns, in radians for each length."""
    slant: float
    """The largest angle between a ruling and the square across the board, in radians."""
    strain: float
    """How much its edges are stretched: 0 but on a line about which the surface twists."""
    lift: float
    """How far an edge stands off the surface, at most."""
    overhang: float
    """How far an edge goes beyond the border of the surface, at most."""
    widest: float | None
    """The width at which its rulings begin to cross; None where they never do."""
    error: float
    """How far the strip is from the true one, and its axis laid flat from straight."""
