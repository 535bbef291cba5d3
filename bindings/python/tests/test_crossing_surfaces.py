"""Surfaces that meet, as Python sees it."""

import math

import numpy as np
import pytest

import pforms as pf


def graph(seed, tilt=0.0):
    rng = np.random.default_rng(seed)
    x, y = np.meshgrid(np.arange(4.0), np.arange(4.0), indexing="ij")
    return pf.Form(np.stack([x, y, rng.uniform(-0.4, 0.4, (4, 4)) + tilt * (x - 1.5)], axis=-1))


def test_a_branch_is_three_curves_over_one_parameter():
    ball = pf.sphere(1)
    moved = pf.translate(ball, (1, 0, 0))
    found = pf.intersect(ball, moved)
    (branch,) = found.curves
    assert branch.closed
    assert not branch.tangent
    ((start, end),) = branch.curve.window
    assert end - start == pytest.approx(math.pi * math.sqrt(3), rel=1e-9)
    at = np.linspace(start, end, 101)[1:-1]
    points = branch.curve(at)
    for shape, path in ((ball, branch.first), (moved, branch.second)):
        off = np.linalg.norm(shape(*path(at).T) - points, axis=1)
        assert off.max() <= branch.error + 1e-15


def test_many_pairs_in_one_call():
    first = [graph(2 * i) for i in range(12)]
    second = [graph(2 * i + 1, 0.5) for i in range(12)]
    found = pf.intersect_many(first, second)
    assert found.complete.all()
    for i, (a, b) in enumerate(zip(first, second, strict=True)):
        alone = pf.intersect(a, b)
        curves = found.whole[i].curves if i in found.whole else ()
        assert [c.curve for c in alone.curves] == [c.curve for c in curves]
        for branch in curves:
            x, y, z = branch.curve(np.linspace(*branch.curve.window[0], 50)).T
            assert np.abs(a(x / 3, y / 3)[:, 2] - z).max() < 1e-8
            assert np.abs(b(x / 3, y / 3)[:, 2] - z).max() < 1e-8


def test_touching_is_said():
    found = pf.intersect(
        pf.torus(2, 1), pf.Form([[(-4, 1, -4), (-4, 1, 4)], [(4, 1, -4), (4, 1, 4)]])
    )
    (branch,) = found.curves
    assert branch.tangent
    assert branch.closed
    assert not found.complete
    whole = graph(3)
    same = pf.intersect(whole, whole)
    assert len(same.overlaps) == 1
    assert not same.curves
    assert not same.complete


def test_what_is_no_surface_is_refused():
    flat = pf.Form([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]])
    with pytest.raises(pf.DegenerateError, match="collapsed"):
        pf.intersect(flat, pf.Form([[(0, 0, 0), (0, 0, 0)], [(1, 1, 1), (1, 1, 1)]]))
