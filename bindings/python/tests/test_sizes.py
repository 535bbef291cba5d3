"""Areas, volumes, centres, boxes, Jacobians, folds and slices, as Python asks for them."""

import numpy as np
import pytest

import pforms as pf

BRICK = pf.translate(pf.cube(2, (1, 2, 3)), (0.5, 1, 1.5))
FACES = [BRICK.sub(axis, t) for axis in range(3) for t in (0, 1)]


def test_forms_come_one_by_one_or_in_a_list():
    assert pf.volume(*FACES) == pf.volume(FACES) == pytest.approx(6, rel=1e-12)
    assert pf.area(FACES) == pytest.approx(22, rel=1e-12)
    both = pf.area(FACES[0], [[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]])
    assert both == pytest.approx(7, rel=1e-12)


def test_methods_say_what_functions_say():
    ball = pf.sphere(1)
    assert ball.area(report=True) == pf.area(ball, report=True)
    assert ball.volume() == pf.volume(ball) == pytest.approx(4 / 3 * np.pi, rel=1e-12)
    assert np.array_equal(ball.centroid(filled=True), pf.centroid(ball, filled=True))
    assert np.array_equal(BRICK.inertia().moments, pf.inertia(BRICK).moments)
    assert np.array_equal(BRICK.box().upper, pf.box(BRICK).upper)
    assert pf.bounding_box is pf.box
    assert pf.length is pf.arc_length


def test_the_error_is_no_larger_than_asked_for():
    for accuracy in (1e-3, 1e-9, 1e-13):
        value, error = pf.area(pf.torus(3, 1, part="pieces"), accuracy=accuracy, report=True)
        assert abs(value - 12 * np.pi**2) <= error <= accuracy * value
    with pytest.raises(pf.AccuracyError):
        pf.area(pf.sphere(1), accuracy=1e-16)


def test_inertia_is_a_record_of_arrays():
    brick = pf.inertia(BRICK)
    assert brick.tensor.shape == (3, 3)
    assert brick.centroid == pytest.approx([0.5, 1, 1.5], abs=brick.centroid_error)
    turned = np.einsum("ki,ij,lj->kl", brick.axes, brick.tensor, brick.axes)
    assert np.abs(turned - np.diag(brick.moments)).max() < 1e-12


def test_a_box_names_the_points_that_touch_it():
    arch = pf.Form([(0, 0), (1, 2), (2, 0)])
    box = pf.box(pf.Form((0.5, -1)), arch)
    assert box.lowest[1] == (0, ())
    number, at = box.highest[1]
    assert (number, at) == (1, (0.5,))
    assert abs(arch(*at)[1] - box.upper[1]) <= box.error


def test_folds():
    assert pf.is_injective(BRICK) is True
    report = pf.is_injective(pf.Form([(-1,), (1,), (-1,), (1,)]), report=True)
    assert report.answer == "undecided"
    assert any(low[0] <= 0.5 <= high[0] for low, high in report.undecided)
    assert pf.jacobian(BRICK).poles.ravel().tolist() == [6.0] * 27


def test_slices():
    film = pf.stack(FACES[0], FACES[1])
    frames = pf.slice(film, 0, np.linspace(0, 1, 5))
    assert [frame.poles[0, 0, 0] for frame in frames] == [0, 0.25, 0.5, 0.75, 1]
    assert film.slice(0, 0.5) == film.sub(0, 0.5)
    assert isinstance(pf.slice(pf.sphere(1, part="pieces"), 0, 0.5), pf.Spline)


@pytest.mark.parametrize(
    ("call", "error"),
    [
        (lambda: pf.area(), pf.ShapeError),
        (lambda: pf.area("here"), pf.ArgumentError),
        (lambda: pf.area(pf.Form([(0, 0, 0), (1, 0, 0)])), pf.ShapeError),
        (lambda: pf.volume(FACES[:5]), pf.DegenerateError),
        (lambda: pf.centroid(pf.Form([(1, 1), (1, 1)])), pf.DegenerateError),
        (lambda: pf.box(pf.Form([(0,), (1,)], weights=[1, -1])), pf.DomainError),
        (lambda: pf.jacobian(FACES[0]), pf.ShapeError),
        (lambda: pf.is_injective(BRICK, accuracy=0), pf.DomainError),
        (lambda: pf.slice(BRICK, 3, 0), pf.ShapeError),
        (lambda: pf.slice(BRICK, 0, float("nan")), pf.DomainError),
    ],
)
def test_bad_input_is_named(call, error):
    with pytest.raises(error):
        call()
