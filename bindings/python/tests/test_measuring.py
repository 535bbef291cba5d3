"""Normals, frames and curvatures at many parameters."""

import pickle

import numpy as np
import pytest

import pforms as pf


def test_normals_of_a_sphere_are_its_points(octant):
    u, v = np.linspace(0, 1, 6)[:, None], np.linspace(0, 1, 7)
    points, normals = octant(u, v), octant.normals(u, v)
    assert normals.shape == (6, 7, 3)
    side = np.sign((normals * points).sum(-1))
    assert (side == side[0, 0]).all()
    np.testing.assert_allclose(normals, side[0, 0] * points, atol=1e-12)
    U, V = np.broadcast_arrays(u, v)
    np.testing.assert_allclose(octant.normals(U, V), normals, atol=1e-12)
    assert octant.normals(0.5, 0.5).shape == (3,)
    assert octant.normals(np.empty((0, 2)), 0.5).shape == (0, 2, 3)


def test_normals_are_du_times_dv(make, rng):
    form = make(3, 4)
    u, v = rng.uniform(0, 1, (2, 30))
    cross = np.cross(form.evaluate(u, v, derivative=(1, 0)), form.evaluate(u, v, derivative=(0, 1)))
    cross /= np.linalg.norm(cross, axis=-1, keepdims=True)
    np.testing.assert_allclose(form.normals(u, v), cross, atol=1e-10)


def test_only_surfaces_in_space_have_normals(make):
    for form in (make(3, 3, ambient=2), make(2, 2, 2), make(3)):
        with pytest.raises(pf.ShapeError):
            form.normals(0.5, 0.5)
    with pytest.raises(pf.DegenerateError):
        pf.Form(np.zeros((2, 2, 3))).normals(0.5, 0.5)


def test_frame_of_a_curve(make):
    curve, t = make(5), np.linspace(0.05, 0.95, 8).reshape(2, 4)
    frame = curve.frame(t)
    names = {"point", "tangent", "normal", "binormal", "speed", "curvature", "torsion"}
    assert set(frame.keys()) == names
    np.testing.assert_allclose(frame.point, curve(t))
    speed = curve.evaluate(t, derivative=1)
    np.testing.assert_allclose(frame.speed[..., None] * frame.tangent, speed, rtol=1e-10)
    np.testing.assert_allclose(np.cross(frame.tangent, frame.normal), frame.binormal, atol=1e-10)
    np.testing.assert_array_equal(curve.curvature(t), frame.curvature)
    loose = curve.frame(t, unit=False)
    np.testing.assert_allclose(loose.tangent, speed, rtol=1e-10)
    second = curve.evaluate(t, derivative=2)
    np.testing.assert_allclose(loose.binormal, np.cross(speed, second), rtol=1e-8, atol=1e-9)


def test_kinds_of_normals(make):
    curve = make(6)
    t = np.linspace(0, 1, 200)
    carried = curve.frame(t, kind="rotation-minimising").normal
    assert np.linalg.norm(np.diff(carried, axis=0), axis=1).max() < 0.5
    assert set(curve.frame(t, kind="tangent").keys()) >= {"point", "tangent", "speed"}
    assert "normal" not in curve.frame(t, kind="tangent")
    line = pf.Form([(0, 0, 0), (1, 1, 1)])
    with pytest.raises(pf.DegenerateError):
        line.frame(0.5)
    assert line.frame(0.5, kind="rotation-minimising").normal.shape == (3,)
    with pytest.raises(pf.DomainError, match="kind: received"):
        line.frame(0.5, kind="serret")


def test_curvature_of_a_circle():
    quarter = pf.Form([(2, 0), (2, 2), (0, 2)], [1, 1, 2])
    np.testing.assert_allclose(quarter.curvature(np.linspace(0, 1, 5)), 0.5, rtol=1e-13)
    np.testing.assert_allclose(quarter.reverse(0).curvature(0.3), -0.5, rtol=1e-13)


def test_curvature_of_a_sphere(octant):
    u, v = np.linspace(0, 1, 4)[:, None], np.linspace(0, 0.9, 3)
    bends = octant.curvature(u, v)
    np.testing.assert_allclose(bends.gauss, 1, rtol=1e-10)
    np.testing.assert_allclose(np.abs(bends.mean), 1, rtol=1e-10)
    assert bends.principal.shape == (4, 3, 2)
    frame = octant.frame(u, v)
    np.testing.assert_array_equal(frame["gauss"], bends["gauss"])
    np.testing.assert_allclose(frame.normal, octant.normals(u, v), atol=1e-10)
    assert frame.first.shape == (4, 3, 3)
    du = octant.evaluate(u, v, derivative=(1, 0))
    np.testing.assert_allclose(frame.first[..., 0], (du**2).sum(-1), rtol=1e-10)


def test_frame_of_a_volume(make):
    volume = make(2, 3, 2)
    at = (np.linspace(0.1, 0.9, 4), 0.5, 0.25)
    frame = volume.frame(*at, unit=False)
    slopes = [volume.evaluate(*at, derivative=tuple(np.eye(3, dtype=int)[k])) for k in range(3)]
    for name, slope in zip(("tu", "tv", "tw"), slopes, strict=True):
        np.testing.assert_allclose(frame[name], slope, rtol=1e-10)
    np.testing.assert_allclose(frame.jacobian, np.linalg.det(np.stack(slopes, -1)), rtol=1e-9)


def test_a_frame_has_keys_attributes_and_unpacks(make):
    frame = make(4).frame([0.2, 0.4])
    assert frame.point is frame["point"]
    tangent, normal, binormal = frame
    assert tangent is frame.tangent
    assert normal is frame.normal
    assert binormal is frame.binormal
    assert "point" in frame
    assert "colour" not in frame
    with pytest.raises(AttributeError, match="it has point, tangent"):
        _ = frame.colour
    again = pickle.loads(pickle.dumps(frame))
    assert type(again) is pf.Frame
    np.testing.assert_array_equal(again.tangent, frame.tangent)


def test_forms_without_the_answer_say_so(make):
    for call in (
        lambda: make().frame(),
        lambda: make().curvature(),
        lambda: make(2, 2).frame(0.5),
        lambda: make(2, ambient=1).frame(0.5),
        lambda: make(2, 2, ambient=2).curvature(0.5, 0.5),
        lambda: make(2, 2, 2).curvature(0.5, 0.5, 0.5),
    ):
        with pytest.raises(pf.ShapeError, match="received .*, expected"):
            call()


def test_no_parameters_give_empty_arrays(make):
    frame = make(4).frame([])
    assert frame.point.shape == frame.tangent.shape == frame.binormal.shape == (0, 3)
    assert frame.curvature.shape == (0,)
    assert "normal" not in make(4).frame([], kind="tangent")
    frame = make(3, 3).frame(np.empty((2, 1)), np.empty((1, 0)))
    assert frame.normal.shape == (2, 0, 3)
    assert make(3, 3).curvature([], 0).principal.shape == (0, 2)
    assert make(2, 2, 2).frame([], 0, 0).jacobian.shape == (0,)
    assert make(4).curvature([]).shape == (0,)


@pytest.mark.parametrize("kind", ["frenet", "rotation-minimising"])
def test_frames_in_slices_are_those_in_one_piece(make, kind):
    curve = make(6)
    t = np.linspace(0, 1, 20_000)
    frame, few = curve.frame(t, kind=kind), curve.frame(t[::1999], kind=kind)
    for name in ("point", "tangent", "normal", "binormal", "curvature"):
        np.testing.assert_allclose(frame[name][::1999], few[name], rtol=1e-8, atol=1e-8)


@pytest.mark.parametrize("accuracy", [np.nan, -1, 0])
def test_an_accuracy_is_an_angle(make, accuracy):
    with pytest.raises(pf.DomainError, match="^accuracy: received .*, expected a positive angle"):
        make(4).frame(0.5, accuracy=accuracy)


def test_meshes_are_measured():
    box = pf.cube((2, 2, 2))
    mesh = pf.union(box)
    assert pf.volume(mesh) == pf.volume([mesh]) == 1.0
    assert pf.area(mesh) == 6.0
    measure = pf.volume(mesh, mesh, report=True)
    assert measure.value == 2.0
    assert 0 < measure.error < 1e-12
    middle = mesh.vertices.mean(axis=0)
    assert np.abs(pf.centroid(mesh, filled=True) - middle).max() < 1e-14
    heavy, form = pf.inertia(mesh, filled=True), pf.inertia(box)
    assert np.abs(heavy.tensor - form.tensor).max() <= heavy.error + form.error
    found = pf.box(mesh)
    assert found.error == 0
    assert (found.lower == mesh.vertices.min(axis=0)).all()
    assert (found.upper == mesh.vertices.max(axis=0)).all()
    opened = pf.Mesh.of(mesh.vertices, mesh.triangles[1:])
    with pytest.raises(pf.DegenerateError, match="3 edges of one triangle, one from"):
        pf.volume(opened)
    assert pf.area(opened) == 5.5
    with pytest.raises(pf.PformsError):
        pf.area(mesh, box)
