"""Coons patches and Gordon surfaces."""

import json
from pathlib import Path

import numpy as np
import pytest

import pforms as pf

MODELS = Path(__file__).parents[3] / "cases" / "models"


def lines():
    """The sides of a square, in the order of the arguments."""
    ends = [((0, 0), (1, 0)), ((0, 1), (1, 1)), ((0, 0), (0, 1)), ((1, 0), (1, 1))]
    return [pf.Form(pair) for pair in ends]


def test_faces_come_one_by_one_in_a_list_or_as_arrays():
    patch = pf.coons(*lines())
    assert pf.coons(lines()) == patch
    assert pf.coons(*[line.poles for line in lines()]) == patch


def test_a_spline_among_the_faces_makes_a_spline():
    roof = pf.Spline([(0, 1), (0.5, 2), (1, 1)], [1], [[0, 0, 0.5, 1, 1]])
    low, _, left, right = lines()
    patch = pf.coons(low, roof, left, right)
    assert isinstance(patch, pf.Spline)
    np.testing.assert_array_equal(patch(0.5, 1), (0.5, 2))
    np.testing.assert_array_equal(patch(0.25, 0), (0.25, 0))


def test_six_surfaces_make_a_volume():
    cube = pf.Form(np.random.default_rng(3).uniform(size=(3, 2, 4, 3)))
    faces = [cube.sub(axis, t) for axis in (2, 1, 0) for t in (0, 1)]
    volume = pf.coons(faces)
    assert volume.kind == "pV324"
    for face, (axis, t) in zip(faces, [(a, t) for a in (2, 1, 0) for t in (0, 1)], strict=True):
        assert volume.sub(axis, t) == face


def test_a_gap_is_named_and_may_be_allowed():
    low, high, left, right = lines()
    right = pf.Form([(1, 0), (1, 1.25)])
    message = r"curve v=1 and curve u=1 0\.25 apart at corner \(u, v\) = \(1, 1\)"
    with pytest.raises(pf.DomainError, match=message):
        pf.coons(low, high, left, right)
    assert pf.coons(low, high, left, right, accuracy=0.25).kind == "pS22"


def test_points_are_blended_when_asked():
    arc = pf.Form([(0, 0), (0.5, -1), (1, 0)], weights=[1, 0.1, 1])
    _, high, left, right = lines()
    weighted = pf.coons(arc, high, left, right)
    blended = pf.coons(arc, high, left, right, pointwise=True)
    u = np.linspace(0, 1, 9)
    np.testing.assert_allclose(blended(u, 0), arc(u), atol=1e-15)
    np.testing.assert_allclose(weighted(u, 0), arc(u), atol=1e-15)
    np.testing.assert_allclose(blended(u, 0.5), (arc(u) + high(u)) / 2, atol=1e-15)


def test_a_network_is_found_and_reported():
    file = json.loads((MODELS / "tigl" / "wing3.json").read_text())
    us, vs = (
        [pf.Spline(np.array(c["points"]), c["degrees"], c["knots"]) for c in file[family]]
        for family in ("profiles", "guides")
    )
    found = pf.gordon(us, vs, report=True)
    assert isinstance(found, pf.Network)
    assert isinstance(found.surface, pf.Spline)
    assert found.error < 1e-12
    assert found.gap < 1e-12
    assert (len(found.u), len(found.v)) == (3, 4)
    t = np.linspace(0, 1, 33)
    np.testing.assert_allclose(found.surface(t, found.v[1]), us[1](t), atol=1e-12)
    assert pf.gordon(us, vs) == found.surface


def test_one_family_may_be_empty_when_parameters_are_given():
    us = [pf.Form([(0, y), (1, y + 1)]) for y in (0, 1, 4)]
    loft = pf.gordon(us, [], v=[0, 0.5, 1])
    assert isinstance(loft, pf.Form)
    assert loft.sub(1, 0.5) == us[1]
    with pytest.raises(pf.ShapeError):
        pf.gordon(us, [])


def test_parameters_come_together():
    us, vs = [pf.Form([(0, 0), (1, 0)])], [pf.Form([(0, 0), (0, 1)])]
    assert pf.gordon(us, vs, [0], [0]).kind == "pS22"
    with pytest.raises(pf.ArgumentError, match="v: received None"):
        pf.gordon(us, vs, [0])
