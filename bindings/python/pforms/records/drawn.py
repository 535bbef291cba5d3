"""Triangles and points that stand for forms."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from os import PathLike

    from numpy import float64, int32
    from numpy.typing import ArrayLike, NDArray


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
