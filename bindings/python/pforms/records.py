"""What some questions are answered with."""

from __future__ import annotations

import itertools
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from collections.abc import Iterator, KeysView
    from os import PathLike

    from numpy import bool_, float64, int32, int64, uint8
    from numpy.typing import ArrayLike, NDArray

    from pforms._pforms import Form, Spline


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


class Mesh(NamedTuple):
    """Triangles that share vertices; without any, a cloud of points.

    Seen from where the normals point, the corners of a triangle run counter-clockwise. What asks
    for a mesh takes any object with ``vertices`` and ``triangles``; :meth:`of` makes one of arrays.

    >>> import pforms as pf
    >>> facet = pf.Form([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]])
    >>> mesh = pf.tessellate(facet, segments=1)
    >>> mesh.triangles.tolist(), mesh.normals[0].tolist()
    ([[0, 2, 3], [0, 3, 1]], [0.0, 0.0, 1.0])
    """

    vertices: NDArray[float64]
    """Points, shape (n, 3), in the plane or elsewhere (n, c)."""
    normals: NDArray[float64]
    """The unit normal at each vertex, shape (n, 3), or none: shape (0, c)."""
    triangles: NDArray[int32]
    """Three vertices for each triangle, shape (m, 3)."""

    @classmethod
    def of(cls, vertices: ArrayLike, triangles: ArrayLike = ()) -> Mesh:
        """A mesh of arrays, without normals.

        >>> import pforms as pf
        >>> corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
        >>> simplex = pf.Mesh.of(corners, [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)])
        >>> simplex
        <pforms.Mesh of 4 vertices, 4 triangles>
        >>> simplex.is_closed, round(6 * simplex.volume, 15)
        (True, 1.0)
        """
        from pforms._pforms import _make_mesh

        return _make_mesh(vertices, triangles)

    @property
    def area(self) -> float:
        """The area of all triangles."""
        from pforms._pforms import _mesh_area

        return _mesh_area(self)

    @property
    def volume(self) -> float:
        """The volume inside; raises ShapeError unless the mesh is closed."""
        from pforms._pforms import _mesh_volume

        return _mesh_volume(self)

    @property
    def is_closed(self) -> bool:
        """Does every edge have a triangle on either side? Vertices at one place count as one."""
        from pforms._pforms import _mesh_is_closed

        return _mesh_is_closed(self)

    def save(self, path: str | PathLike[str]) -> None:
        """Writes the triangles into a file, ``.obj``, ``.stl``, ``.glb`` or ``.pov``.

        Raises FormatError when its name ends in something else.
        """
        from pforms.files import draw

        draw(self, path, axes=False)

    def __repr__(self) -> str:
        """How many there are of what."""
        return f"<pforms.Mesh of {len(self.vertices)} vertices, {len(self.triangles)} triangles>"


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


class Polyline(NamedTuple):
    """Points of a curve in their order.

    >>> import pforms as pf
    >>> line = pf.tessellate(pf.Form([(0, 0, 0), (4, 0, 0)]), segments=2)
    >>> line.vertices[:, 0].tolist(), line.segments.tolist()
    ([0.0, 2.0, 4.0], [[0, 1], [1, 2]])
    """

    vertices: NDArray[float64]
    """Points of the curve, shape (n, 3)."""
    tangents: NDArray[float64]
    """The direction of the curve at each, shape (n, 3)."""
    segments: NDArray[int32]
    """Two vertices for each segment, shape (m, 2); none joins the two sides of infinity."""


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


class Solid(NamedTuple):
    """A combination of solids, and how near it is to the true one.

    >>> import pforms as pf
    >>> box = pf.union(pf.cube((2, 2, 2), 2), report=True)
    >>> round(box.volume, 12), box.mesh
    (8.0, <pforms.Mesh of 8 vertices, 12 triangles>)
    """

    mesh: Mesh
    """Closed; empty if there is nothing."""
    volume: float
    """That of the mesh."""
    error: float
    """The true volume differs from it by no more than this."""
    distance: float
    """No point of a surface that was given is farther from its mesh than this."""


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
