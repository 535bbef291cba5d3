"""Forms as triangles: proven tolerances, no cracks, normals everywhere."""

from pathlib import Path

import numpy as np
import pytest

import pforms as pf

MODELS = Path(__file__).parents[3] / "cases" / "models"


@pytest.fixture
def sphere(octant):
    """The whole sphere, as eight octants with common edges."""
    net = octant.homogeneous
    signs = [(a, b, c) for a in (1, -1) for b in (1, -1) for c in (1, -1)]
    return [pf.Form.from_homogeneous(net * [*s, 1]) for s in signs]


def times_used(meshes):
    """How often each edge is used, vertices at one place taken as one."""
    places = np.concatenate([m.vertices for m in meshes]) + 0.0
    starts = np.cumsum([0, *(len(m.vertices) for m in meshes)])
    corners = np.concatenate([m.triangles + k for m, k in zip(meshes, starts, strict=False)])
    _, same = np.unique(places, axis=0, return_inverse=True)
    corners = same.ravel()[corners]
    edges = np.sort(np.concatenate([corners[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1)
    return np.unique(edges, axis=0, return_counts=True)[1]


@pytest.mark.parametrize("asked", [{"tolerance": 1e-3}, {"segments": 9}, {"fineness": 3}])
def test_a_sphere_is_watertight_and_its_normals_are_its_points(sphere, asked):
    meshes = pf.tessellate(sphere, **asked)
    if "segments" not in asked:
        assert (times_used(meshes) == 2).all()
    for mesh in meshes:
        assert mesh.vertices.dtype == mesh.normals.dtype == np.float64
        assert mesh.triangles.dtype == np.int32
        # Within some roundings: a point is a quotient of sums of nine products.
        np.testing.assert_allclose(np.linalg.norm(mesh.vertices, axis=1), 1, atol=1e-14)
        np.testing.assert_allclose(np.linalg.norm(mesh.normals, axis=1), 1, atol=1e-14)
        along = (mesh.vertices * mesh.normals).sum(axis=1)
        np.testing.assert_allclose(np.abs(along), 1, atol=1e-12)


def test_the_tolerance_is_kept(sphere):
    # The middle of a triangle of a sphere is where it strays farthest, as far as it is regular.
    for mesh in pf.tessellate(sphere, tolerance=1e-3):
        middles = mesh.vertices[mesh.triangles].mean(axis=1)
        assert 1 - np.linalg.norm(middles, axis=1).min() <= 1e-3


def test_segments_are_cells_in_order():
    form = pf.Form(np.random.default_rng(1).normal(size=(4, 3, 3)))
    mesh = pf.tessellate(form, segments=(3, 2))
    grid = form.grid(4, 3).reshape(-1, 3)
    np.testing.assert_allclose(mesh.vertices, grid, atol=1e-14)
    assert len(mesh.triangles) == 12
    assert not len(pf.tessellate(form, segments=2, normals=False).normals)


def test_segments_drop_nothing_and_fineness_what_has_no_area(octant):
    assert len(pf.tessellate(octant, segments=8).triangles) == 128
    assert len(pf.tessellate(octant, fineness=3).triangles) == 120


def test_the_teapot_has_normals_everywhere_and_few_triangles():
    forms = pf.load(MODELS / "newell-teapot32.bpt")
    meshes = pf.tessellate(forms, tolerance=8.276e-3)
    assert sum(len(mesh.triangles) for mesh in meshes) < 7000
    for mesh in meshes:
        np.testing.assert_allclose(np.linalg.norm(mesh.normals, axis=1), 1, atol=1e-14)
    # Only the rims are open.
    assert times_used(meshes).max() == 2


def test_meshes_are_joined(sphere):
    whole = pf.tessellate(sphere, segments=4, joined=True)
    assert len(whole.vertices) == 8 * 25
    assert whole.triangles.max() == 8 * 25 - 1


def test_curves_and_volumes():
    line = pf.tessellate(pf.Form([(0, 0), (1, 2), (2, 0)]), segments=4)
    assert isinstance(line, pf.Polyline)
    np.testing.assert_array_equal(line.vertices[2], (1, 1, 0))
    np.testing.assert_array_equal(line.segments[-1], (3, 4))
    cube = pf.Form(np.stack(np.meshgrid([0, 1], [0, 1], [0, 1], indexing="ij"), -1))
    mesh = pf.tessellate(cube, tolerance=0.1)
    assert isinstance(mesh, pf.Mesh)
    assert len(mesh.triangles) == 12
    a, b, c = mesh.vertices[mesh.triangles].swapaxes(0, 1)
    assert (a * np.cross(b, c)).sum() / 6 == 1
    several = pf.tessellate([cube, pf.Form([(0, 0, 0), (1, 1, 1)])], fineness=1)
    assert [type(record) for record in several] == [pf.Mesh, pf.Polyline]
    assert pf.tessellate([], segments=1) == []


@pytest.mark.parametrize(
    ("error", "asked"),
    [
        (pf.ArgumentError, {}),
        (pf.ArgumentError, {"segments": 2, "fineness": 1}),
        (pf.DomainError, {"tolerance": 0}),
        (pf.DomainError, {"tolerance": float("nan")}),
        (pf.DomainError, {"segments": 0}),
        (pf.DomainError, {"fineness": 30}),
        (pf.ShapeError, {"segments": (1, 2, 3)}),
        (pf.LimitError, {"tolerance": 1e-300}),
        (pf.LimitError, {"segments": 10**6}),
    ],
)
def test_what_cannot_be_is_named(octant, error, asked):
    with pytest.raises(error):
        pf.tessellate(octant, **asked)


def test_what_cannot_be_tessellated_is_named():
    with pytest.raises(pf.ShapeError, match="curves, surfaces or volumes"):
        pf.tessellate(pf.Form((1.0, 2.0)), segments=1)
    with pytest.raises(pf.ShapeError, match="joined"):
        pf.tessellate([pf.Form([(0, 0), (1, 1)])], segments=1, joined=True)
    with pytest.raises(pf.ShapeError, match="volume"):
        pf.tessellate(pf.Form(np.zeros((2, 2, 2, 3))), segments=(1, 2, 3))
