"""geomdl: pure Python."""

from __future__ import annotations

from geomdl import NURBS, BSpline

from bernstein import Net
from contest import Native


def surface(net: Net) -> Native:
    kind = BSpline if net.weights is None else NURBS
    surface = kind.Surface()
    n, m = net.orders
    surface.degree_u, surface.degree_v = n - 1, m - 1
    poles = net.homogeneous
    surface.set_ctrlpts(poles.reshape(n * m, -1).tolist(), n, m)
    surface.knotvector_u = [0.0] * n + [1.0] * n
    surface.knotvector_v = [0.0] * m + [1.0] * m
    return surface


def volume(net: Net) -> Native:
    kind = BSpline if net.weights is None else NURBS
    volume = kind.Volume()
    n, m, k = net.orders
    volume.degree_u, volume.degree_v, volume.degree_w = n - 1, m - 1, k - 1
    # The second parameter runs fastest, then the first.
    poles = net.homogeneous.transpose(2, 0, 1, 3)
    volume.set_ctrlpts(poles.reshape(n * m * k, -1).tolist(), n, m, k)
    volume.knotvector_u = [0.0] * n + [1.0] * n
    volume.knotvector_v = [0.0] * m + [1.0] * m
    volume.knotvector_w = [0.0] * k + [1.0] * k
    return volume
