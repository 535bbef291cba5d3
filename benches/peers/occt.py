"""OpenCASCADE through cadquery-ocp: one call from Python for each point."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from OCP.collections import Array2_double, Array2_gp_Pnt
from OCP.Geom import Geom_BezierSurface
from OCP.gp import gp_Pnt

from bernstein import Net
from contest import Array, Native


def surface(net: Net) -> Native:
    n, m = net.orders
    points, weights = Array2_gp_Pnt(1, n, 1, m), Array2_double(1, n, 1, m)
    for i, j in np.ndindex(n, m):
        points.SetValue(i + 1, j + 1, gp_Pnt(*net.points[i, j].tolist()))
        if net.weights is not None:
            weights.SetValue(i + 1, j + 1, float(net.weights[i, j]))
    if net.weights is None:
        return Geom_BezierSurface(points)
    return Geom_BezierSurface(points, weights)


def coordinates(points: Iterable[Native]) -> Array:
    return np.array([(p.X(), p.Y(), p.Z()) for p in points])


def poles(surface: Native) -> Array:
    """Homogeneous poles of a surface."""
    n, m = surface.NbUPoles(), surface.NbVPoles()
    places = [(i + 1, j + 1) for i in range(n) for j in range(m)]
    points = coordinates(surface.Pole(i, j) for i, j in places).reshape(n, m, 3)
    if not (surface.IsURational() or surface.IsVRational()):
        return points
    weights = np.array([surface.Weight(i, j) for i, j in places]).reshape(n, m, 1)
    return np.concatenate([points * weights, weights], axis=-1)
