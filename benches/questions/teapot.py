"""Newell's teapot in triangles: 64 × 64 squares on each patch, and within 1/1000 of its size."""

from __future__ import annotations

from pathlib import Path

import numpy as np

import bernstein
from bernstein import Net
from contest import Array, Native, Question, Work, apart_from

VARIANTS = ("uniform", "adaptive")
SIZES = (64, 20, 6)
"""Squares along a side; the adaptive mesh has one size."""

FILE = Path(__file__).parents[2] / "cases" / "models" / "newell-teapot32.bpt"


def question(variant: str, side: int) -> Question:
    patches = teapot()
    return uniform(patches, side) if variant == "uniform" else adaptive(patches)


def teapot() -> Array:
    """Poles of the 32 patches."""
    numbers = [float(word) for line in FILE.read_text().splitlines()[1:] for word in line.split()]
    return np.array(numbers).reshape(32, 2 + 16 * 3)[:, 2:].reshape(32, 4, 4, 3)


def uniform(patches: Array, side: int) -> Question:
    at = np.linspace(0.0, 1.0, side + 1)
    shape = (len(patches), side + 1, side + 1, 3)

    def ours(threads: int) -> Work:
        import pforms as pf
        from peers.ours import form

        forms = [form(Net(patch, None), threads) for patch in patches]
        return Work(
            lambda: pf.tessellate(forms, segments=side, normals=False),
            lambda meshes: np.array([mesh.vertices for mesh in meshes]).reshape(shape),
        )

    def numpy(_: int) -> Work:
        def run() -> tuple[Array, Native]:
            basis = bernstein.values(4, at)
            return bernstein.on_grid(patches, basis, basis), triangles(len(patches), side)

        return Work(run, lambda mesh: mesh[0])

    def splinepy(threads: int) -> Work:
        from splinepy import Multipatch

        from peers.splinepy import form

        family = Multipatch([form(Net(patch, None)) for patch in patches])

        def run() -> tuple[Array, Native]:
            return family.sample(side + 1, nthreads=threads), triangles(len(patches), side)

        return Work(run, lambda mesh: mesh[0].reshape(shape).swapaxes(1, 2))

    def truth() -> Array:
        basis = bernstein.values(4, at)
        return np.einsum("ui,vj,pijc->puvc", basis, basis, patches, optimize=True)

    answers = {"pforms": ours, "numpy": numpy, "splinepy": splinepy}
    items = 2 * len(patches) * side**2
    return Question(items, "triangle", answers, apart_from(truth))


def triangles(patches: int, side: int) -> Native:
    """Triples of vertices, two for each square of the grids."""
    corner = np.arange(side, dtype=np.int32)[:, None] * (side + 1) + np.arange(side, dtype=np.int32)
    right, below = corner + 1, corner + side + 1
    pairs = [(corner, below, right), (right, below, below + 1)]
    one = np.stack([np.stack(pair, axis=-1) for pair in pairs], axis=-2).reshape(-1, 3)
    return one + np.arange(patches, dtype=np.int32)[:, None, None] * (side + 1) ** 2


def adaptive(patches: Array) -> Question:
    size = float(np.linalg.norm(np.ptp(patches.reshape(-1, 3), axis=0)))
    tolerance = 1e-3 * size

    def ours(threads: int) -> Work:
        import pforms as pf
        from peers.ours import form

        forms = [form(Net(patch, None), threads) for patch in patches]
        return Work(
            lambda: pf.tessellate(forms, tolerance=tolerance),
            lambda meshes: corners([(mesh.vertices, mesh.triangles) for mesh in meshes]),
        )

    def ours_without_normals(threads: int) -> Work:
        import pforms as pf
        from peers.ours import form

        forms = [form(Net(patch, None), threads) for patch in patches]
        return Work(
            lambda: pf.tessellate(forms, tolerance=tolerance, normals=False),
            lambda meshes: corners([(mesh.vertices, mesh.triangles) for mesh in meshes]),
        )

    def occt(_: int) -> Work:
        from OCP.BRep import BRep_Builder, BRep_Tool
        from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeFace
        from OCP.BRepMesh import BRepMesh_IncrementalMesh
        from OCP.BRepTools import BRepTools
        from OCP.TopLoc import TopLoc_Location
        from OCP.TopoDS import TopoDS_Compound

        from peers.occt import coordinates, surface

        whole, builder = TopoDS_Compound(), BRep_Builder()
        builder.MakeCompound(whole)
        surfaces = [surface(Net(patch, None)) for patch in patches]
        faces = [BRepBuilderAPI_MakeFace(surface, 1e-7).Face() for surface in surfaces]
        for face in faces:
            builder.Add(whole, face)

        def run() -> Native:
            BRepTools.Clean_s(whole)
            # Only the chord is bounded, not the angle.
            return BRepMesh_IncrementalMesh(whole, tolerance, False, 10.0, False)

        def read(_: Native) -> Array:
            meshes = []
            for face in faces:
                mesh = BRep_Tool.Triangulation_s(face, TopLoc_Location())
                vertices = coordinates(mesh.Node(i + 1) for i in range(mesh.NbNodes()))
                triples = [mesh.Triangle(i + 1) for i in range(mesh.NbTriangles())]
                indices = [[triple.Value(k) - 1 for k in (1, 2, 3)] for triple in triples]
                meshes.append((vertices, np.array(indices)))
            return corners(meshes)

        return Work(run, read)

    def error(mesh: Array) -> float:
        """How far the surface leaves the mesh, relative to the teapot's size."""
        at = np.linspace(0.0, 1.0, 20)
        basis = bernstein.values(4, at)
        samples = bernstein.on_grid(patches, basis, basis).reshape(-1, 3)
        return float(distances(samples, mesh).max() / size)

    answers = {"pforms": ours, "pforms without normals": ours_without_normals, "occt": occt}
    return Question(1, "teapot", answers, error, accuracy=1e-3)


def corners(meshes: list[tuple[Array, Native]]) -> Array:
    """Corners of all triangles: `(m, 3, 3)`."""
    return np.concatenate([vertices[triples] for vertices, triples in meshes])


def distances(points: Array, mesh: Array, candidates: int = 64) -> Array:
    """Distance from each point to the closest of the triangles whose spheres are nearest."""
    centres = mesh.mean(axis=1)
    radii = np.linalg.norm(mesh - centres[:, None], axis=-1).max(axis=1)
    candidates = min(candidates, len(mesh) - 1)
    parts = []
    for part in np.array_split(points, max(1, len(points) // 200)):
        apart = np.linalg.norm(part[:, None] - centres[None], axis=-1) - radii
        near = np.argpartition(apart, candidates, axis=1)[:, :candidates]
        parts.append(to_triangles(part[:, None], mesh[near]).min(axis=1))
    return np.concatenate(parts)


def to_triangles(points: Array, mesh: Array) -> Array:
    """Distances to triangles: to the plane where the foot is inside, else to the sides."""
    a, b, c = (mesh[..., k, :] for k in range(3))
    normal = np.cross(b - a, c - a)
    square = np.maximum((normal**2).sum(axis=-1), 1e-300)
    inside = np.ones(square.shape, dtype=bool)
    shortest = np.full(square.shape, np.inf)
    for p, q in ((a, b), (b, c), (c, a)):
        inside &= (np.cross(q - p, points - p) * normal).sum(axis=-1) >= 0
        shortest = np.minimum(shortest, to_segments(points, p, q))
    height = np.abs(((points - a) * normal).sum(axis=-1)) / np.sqrt(square)
    return np.where(inside & (square > 1e-300), np.minimum(height, shortest), shortest)


def to_segments(points: Array, p: Array, q: Array) -> Array:
    along = q - p
    square = np.maximum((along**2).sum(axis=-1), 1e-300)
    share = np.clip(((points - p) * along).sum(axis=-1) / square, 0, 1)
    return np.asarray(np.linalg.norm(p + share[..., None] * along - points, axis=-1))
