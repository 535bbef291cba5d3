import numpy as np
import pytest

import pforms as pf


@pytest.fixture
def rng():
    return np.random.default_rng(2026)


@pytest.fixture
def make(rng):
    """Makes a random form of the given orders."""

    def make(*orders, ambient=3, rational=True):
        poles = rng.uniform(-2, 2, (*orders, ambient))
        weights = rng.uniform(0.5, 2, orders) if rational else None
        return pf.Form(poles, weights)

    return make


@pytest.fixture
def octant():
    """An eighth of the unit sphere: exact, with a collapsed edge."""
    meridian = np.array([(1, 0, 0, 1), (1, 0, 1, 1), (0, 0, 2, 2)], float)
    turns = np.array([(1, 0, 1), (1, 1, 1), (0, 2, 2)], float)
    net = np.empty((3, 3, 4))
    for i, (c, s, w) in enumerate(turns):
        for j, (x, _, z, v) in enumerate(meridian):
            net[i, j] = (x * c, x * s, z * w, v * w)
    return pf.Form.from_homogeneous(net)
