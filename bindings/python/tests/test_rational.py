"""Circles, quadrics, tori, revolution: what Python is given, and what it may not ask for."""

import math

import numpy as np
import pytest

import pforms as pf

PARTS = [
    (pf.circle, (2.0,), {"whole", "pieces"}),
    (pf.ellipse, (2.0, 1.0), {"whole", "pieces"}),
    (pf.cylinder, (2.0, 1.0), {"whole", "pieces", "quarter"}),
    (pf.cone, (2.0, 1.0), {"whole", "pieces", "quarter"}),
    (pf.sphere, (2.0,), {"whole", "pieces", "half", "quarter", "octant"}),
    (pf.torus, (2.0, 1.0), {"whole", "pieces", "quarter", "outer", "inner"}),
    (pf.viviani, (2.0,), {"whole", "octant"}),
]
EVERY = {"whole", "pieces", "half", "quarter", "octant", "outer", "inner"}


@pytest.mark.parametrize(("make", "sizes", "parts"), PARTS)
def test_parts_are_forms_or_splines_and_others_are_refused(make, sizes, parts):
    for part in EVERY:
        if part not in parts:
            with pytest.raises(pf.DomainError, match="part"):
                make(*sizes, part=part)
            continue
        shape = make(*sizes, part=part)
        in_pieces = part == "pieces" or (make is pf.viviani and part == "whole")
        assert isinstance(shape, pf.Spline if in_pieces else pf.Form)
    for bad in (0, -1, math.nan, math.inf):
        with pytest.raises(pf.DomainError):
            make(bad, *sizes[1:])
    with pytest.raises(TypeError):
        make(*sizes, 0, "pieces")


def test_points_lie_on_their_surfaces():
    u, v = np.random.default_rng(5).random((2, 200))
    for part in ("whole", "pieces"):
        x, y, z = np.moveaxis(pf.torus(2, 0.5, part=part)(u, v), -1, 0)
        np.testing.assert_allclose(np.hypot(np.hypot(x, z) - 2, y), 0.5, rtol=0, atol=1e-14)
        sphere = pf.sphere(3, part=part)(u, v)
        np.testing.assert_allclose(np.linalg.norm(sphere, axis=-1), 3, rtol=4e-15)


def test_revolution_ends_where_rotation_does():
    profile = pf.Form([(1, 0, 0), (2, 1, 1), (1, 3, 0)], weights=[1, 0.5, 2])
    axis, through = (1, 2, -1), (0.5, 0, 1)
    turned = profile.revolve(2.5, axis=axis, through=through)
    moved = profile.rotate(2.5, axis, centre=through)
    t = np.linspace(0, 1, 9)
    np.testing.assert_allclose(turned(t, 1), moved(t), rtol=0, atol=1e-14)
    assert pf.revolve(profile.poles, 1.0).axes == 2


def test_products_take_splines_and_arrays():
    section = pf.arc(1, 2 * math.pi)
    surface = pf.cross([(1, 0), (2, 1)], section)
    assert isinstance(surface, pf.Spline)
    assert surface.counts == (1, 4)
    assert section.cross([(1, 0), (2, 1)]).counts == (4, 1)
    with pytest.raises(pf.ArgumentError):
        pf.cross("profile", section)
    with pytest.raises(pf.ArgumentError):
        pf.classify(section)


def test_turns_are_whole_numbers():
    with pytest.raises(pf.DomainError):
        pf.torus_knot(2.5, 3, 1, 0.5)
    with pytest.raises(pf.LimitError):
        pf.torus_knot(10**9, 1, 1, 0.5)
