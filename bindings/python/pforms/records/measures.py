"""What is measured on forms, and by how much it may be off."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from collections.abc import Iterator, KeysView

    from numpy import float64
    from numpy.typing import NDArray


class Measure(NamedTuple):
    """A length, area or volume.

    >>> import pforms as pf
    >>> value, error = pf.area(pf.Form([[(0, 0), (0, 1)], [(2, 0), (2, 1)]]), report=True)
    >>> value, error < 1e-12
    (2.0, True)
    """

    value: float
    error: float
    """By how much the true one may differ, at most."""


class Length(NamedTuple):
    """The length of a curve.

    >>> import pforms as pf
    >>> length, error = pf.arc_length(pf.Form([(0, 0), (3, 4)]), report=True)
    >>> length, error < 1e-12
    (5.0, True)
    """

    length: float
    error: float
    """By how much the true length may differ, at most."""


class Inertia(NamedTuple):
    """Mass, centre and inertia of density 1.

    >>> import pforms as pf
    >>> plate = pf.inertia(pf.Form([[(0, 0), (0, 1)], [(2, 0), (2, 1)]]))
    >>> plate.moments.round(12), plate.error < 1e-11
    (array([0.16666667, 0.66666667]), True)
    """

    measure: float
    """Length, area or volume."""
    measure_error: float
    centroid: NDArray[float64]
    centroid_error: float
    """Along each axis, at most."""
    tensor: NDArray[float64]
    """About the centre: the integral of |x|² less the products of coordinates, shape (c, c)."""
    moments: NDArray[float64]
    """About the principal axes, the least first."""
    axes: NDArray[float64]
    """The principal axes, unit vectors, one for each row."""
    error: float
    """Of each entry of the tensor and each moment, at most."""


class Box(NamedTuple):
    """The least box around forms.

    >>> import pforms as pf
    >>> arch = pf.box(pf.Form([(0, 0), (1, 2), (2, 0)]))
    >>> arch.upper.round(12), arch.highest[1]
    (array([2., 1.]), (0, (0.5,)))
    """

    lower: NDArray[float64]
    """Nothing lies below, along any axis."""
    upper: NDArray[float64]
    """Nothing lies above."""
    error: float
    """Each face is farther out than some point by no more than this."""
    lowest: tuple[tuple[int, tuple[float, ...]], ...]
    """For each coordinate the number of a form and the parameters of such a point."""
    highest: tuple[tuple[int, tuple[float, ...]], ...]


class Folds(NamedTuple):
    """What is known of the sign of a Jacobian determinant.

    >>> import pforms as pf
    >>> drawn = pf.Form([[(0, 0), (0, 1)], [(1, 0), (0.4, 0.4)]])
    >>> found = pf.is_injective(drawn, report=True)
    >>> found.answer, found.positive, found.negative
    ('folds', (0.0, 0.0), (1.0, 1.0))
    """

    answer: str
    """``"none"``: proved that it has one sign; ``"folds"``: it has both; ``"undecided"``."""
    positive: tuple[float, ...] | None
    """Parameters where it is positive, if any were found."""
    negative: tuple[float, ...] | None
    """Parameters where it is negative, if any were found."""
    undecided: tuple[tuple[tuple[float, ...], tuple[float, ...]], ...]
    """Boxes of parameters, from corner to corner, where its sign is open."""
    regular: bool
    """Is it proved to vanish nowhere, border and all?"""
    injective: bool
    """Is it proved that no two parameters give one point?"""


class Developability(NamedTuple):
    """What is known about a surface that may be developable.

    >>> import pforms as pf
    >>> facet = pf.Form([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]])
    >>> pf.is_developable(facet, report=True)
    Developability(developable=True, exact=True, gauss=0.0, parameters=())
    """

    developable: bool
    """Does the Gauss curvature vanish everywhere, as far as rounding lets anyone tell?"""
    exact: bool
    """Does it vanish identically, in exact arithmetic on the very poles given?"""
    gauss: float
    """A Gauss curvature that is not 0, if it is not developable; else 0."""
    parameters: tuple[float, ...]
    """Where it is that."""


class Continuity(NamedTuple):
    """How smoothly two forms meet.

    >>> import pforms as pf
    >>> f, g = pf.Form([(0, 0), (1, 0)]), pf.Form([(1, 0), (1, 2)])
    >>> joint = pf.continuity(f, g, order=1)
    >>> joint.parametric, joint.geometric
    (0, 0)
    >>> joint.geometric_gaps.round(6)
    array([0.      , 1.570796])
    """

    parametric: int | None
    """The largest k for which they are C^k, as far as was asked; None if they do not meet."""
    geometric: int | None
    """The largest k for which they are G^k."""
    gaps: NDArray[float64]
    """The differences of the derivatives of order 0, 1, …"""
    geometric_gaps: NDArray[float64]
    """The distance, the angle in radians, the difference of the curvatures, …"""


class Ratios(NamedTuple):
    """The sides of control polygons and how they stand to one another.

    Of a curve each is one row; of other forms a row for each line of poles along the axis.

    >>> import pforms as pf
    >>> pf.ratios([(0, 0), (2, 0), (2, 3)]).nearest
    ['3/2']
    """

    sides: NDArray[float64]
    ratios: NDArray[float64]
    """Each side by the one before; infinite after one that is a point."""
    angles: NDArray[float64]
    """The angle by which each side turns from the one before, in radians."""
    nearest: list[str] | list[list[str]]
    """The known ratio that is nearest: "1", "3/2", "φ", "1/φ", …"""
    gaps: NDArray[float64]
    """By how much the ratio is larger than that, as a part of it."""


class Frame:
    """Named arrays, by key or as attributes; each has the shape of the parameters first.

    It unpacks into the vectors of the frame: ``tangent, normal, binormal`` of a curve, ``tu, tv,
    normal`` of a surface, ``tu, tv, tw`` of a volume.

    >>> import pforms as pf
    >>> frame = pf.Form([(0, 0), (1, 0), (2, 2)]).frame(0)
    >>> frame.tangent, frame["curvature"].item()
    (array([1., 0.]), 1.0)
    >>> tangent, normal = frame
    >>> normal is frame.normal
    True
    >>> sorted(dict(frame))
    ['curvature', 'normal', 'point', 'speed', 'tangent']
    """

    VECTORS = ("tangent", "tu", "tv", "tw", "normal", "binormal")
    """Names of the vectors, in the order of unpacking."""

    def __init__(self, named: dict[str, NDArray[float64]]) -> None:
        self._named = named

    def __getitem__(self, name: str) -> NDArray[float64]:
        """The array of this name."""
        return self._named[name]

    def __getattr__(self, name: str) -> NDArray[float64]:
        """The array of this name."""
        named: dict[str, NDArray[float64]] = self.__dict__.get("_named", {})
        if name in named:
            return named[name]
        known = ", ".join(named)
        raise AttributeError(f"{name!r} is not in this frame: it has {known}")

    def __iter__(self) -> Iterator[NDArray[float64]]:
        """The vectors, in the order of :attr:`VECTORS`."""
        return (self._named[name] for name in self.VECTORS if name in self._named)

    def __contains__(self, name: object) -> bool:
        """Tell whether there is an array of this name."""
        return name in self._named

    def __repr__(self) -> str:
        """The names and their arrays."""
        return f"Frame({self._named!r})"

    def keys(self) -> KeysView[str]:
        """The names; with them ``dict(frame)`` works."""
        return self._named.keys()
