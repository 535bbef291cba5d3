"""Forms evaluated in NumPy by the definition: nothing shared with pforms."""

from math import comb

import numpy as np


def basis(order, t):
    """All Bernstein polynomials of an order at parameters t, shape (…, order)."""
    t = np.asarray(t, float)[..., None]
    i = np.arange(order)
    choices = np.array([comb(order - 1, k) for k in i], float)
    return choices * t**i * (1 - t) ** (order - 1 - i)


def homogeneous_at(net, *parameters):
    """Homogeneous points at broadcast parameters."""
    parameters = np.broadcast_arrays(*parameters) if parameters else []
    point = np.asarray(net, float)
    lead = parameters[0].shape if parameters else ()
    point = np.broadcast_to(point, lead + point.shape)
    for t in parameters:
        rows = basis(point.shape[len(lead)], t)
        rows = rows.reshape(rows.shape + (1,) * (point.ndim - rows.ndim))
        point = (rows * point).sum(axis=len(lead))
    return point


def at(net, *parameters):
    """Euclidean points at broadcast parameters."""
    point = homogeneous_at(net, *parameters)
    return point[..., :-1] / point[..., -1:]
