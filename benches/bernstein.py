"""The Bernstein basis in NumPy, as a person would write it well: the yardstick of the peers."""

from __future__ import annotations

from dataclasses import dataclass
from math import comb, prod

import numpy as np

from contest import Array


@dataclass(frozen=True)
class Net:
    """Poles of a form: `points` of shape (orders…, coordinates) and, when rational, `weights`."""

    points: Array
    weights: Array | None

    @property
    def orders(self) -> tuple[int, ...]:
        """Number of poles along each axis."""
        return self.points.shape[:-1]

    @property
    def homogeneous(self) -> Array:
        """Poles as peers keep them: weighted, with the weight last; just points when polynomial."""
        if self.weights is None:
            return self.points
        weight = self.weights[..., None]
        return np.concatenate([self.points * weight, weight], axis=-1)

    def project(self, poles: Array) -> Array:
        """Points of homogeneous values."""
        return poles if self.weights is None else poles[..., :-1] / poles[..., -1:]


def net(seed: int, variant: str, *orders: int, low: float = -1.0, high: float = 1.0) -> Net:
    """Random poles; with weights between 1/2 and 2 when the variant is rational."""
    rng = np.random.default_rng(seed)
    points = rng.uniform(low, high, (*orders, 3))
    return Net(points, rng.uniform(0.5, 2.0, orders) if "rational" in variant else None)


def sheet(seed: int, variant: str, *orders: int) -> Net:
    """Poles near a lattice, so that the form is regular: its axes never align."""
    random = net(seed, variant, *orders)
    lattice = np.stack(np.meshgrid(*map(np.arange, orders), indexing="ij"), axis=-1)
    points = random.points * np.array([0.15 if k < len(orders) else 1.0 for k in range(3)])
    points[..., : len(orders)] += lattice
    return Net(points, random.weights)


def values(order: int, at: Array) -> Array:
    """Matrix of the Bernstein polynomials of an order, one row per parameter."""
    degree = order - 1
    rows = [comb(degree, i) * at**i * (1 - at) ** (degree - i) for i in range(order)]
    return np.stack(rows, axis=-1)


def slopes(order: int, at: Array) -> Array:
    """Matrix of their derivatives."""
    lower = np.pad(values(order - 1, at), [(0, 0)] * at.ndim + [(1, 1)])
    return (order - 1) * (lower[..., :-1] - lower[..., 1:])


def on_grid(poles: Array, along_u: Array, along_v: Array) -> Array:
    """Sums over both axes of a surface's poles, `(…, n, m, c)`, with a matrix for each."""
    *family, n, m, width = poles.shape
    rows = along_u @ poles.reshape(*family, n, m * width)
    return along_v @ rows.reshape(*family, len(along_u), m, width)


def at_points(poles: Array, parameters: Array, block: int = 8192) -> Array:
    """Homogeneous values at scattered parameters `(m, axes)`; blocks stay in the cache."""
    axes = parameters.shape[1]
    flat = poles.reshape(prod(poles.shape[:axes]), -1)
    parts = []
    for start in range(0, len(parameters), block):
        part = parameters[start : start + block]
        basis = values(poles.shape[0], part[:, 0])
        for axis in range(1, axes):
            along = values(poles.shape[axis], part[:, axis])
            basis = (basis[:, :, None] * along[:, None, :]).reshape(len(part), -1)
        parts.append(basis @ flat)
    return np.concatenate(parts)


def with_normals(surface: Net, u: Array, v: Array) -> Array:
    """Points and unit normals on a grid, stacked: `(2, u, v, 3)`."""
    n, m = surface.orders
    poles = surface.homogeneous
    points = on_grid(poles, values(n, u), values(m, v))
    along_u = on_grid(poles, slopes(n, u), values(m, v))
    along_v = on_grid(poles, values(n, u), slopes(m, v))
    return oriented(surface, points, along_u, along_v)


def oriented(surface: Net, points: Array, along_u: Array, along_v: Array) -> Array:
    """Points and unit normals of homogeneous points and tangents on a grid."""
    points = surface.project(points)
    if surface.weights is not None:
        # The factor 1/w of both tangents drops out of the unit normal.
        along_u = along_u[..., :3] - points * along_u[..., 3:]
        along_v = along_v[..., :3] - points * along_v[..., 3:]
    normals = np.cross(along_u, along_v)
    normals /= np.sqrt(np.einsum("uvi,uvi->uv", normals, normals))[..., None]
    return np.stack([points, normals])


def elevation(order: int, by: int) -> Array:
    """Matrix that raises a form of an order by some degrees."""
    degree = order - 1
    matrix = np.zeros((order + by, order))
    for j in range(order + by):
        for i in range(max(0, j - by), min(degree, j) + 1):
            matrix[j, i] = comb(degree, i) * comb(by, j - i) / comb(degree + by, j)
    return matrix


def restriction(order: int, a: float, b: float) -> Array:
    """Matrix that restricts a form of an order to the window [a, b]."""
    matrix = np.zeros((order, order))
    for j in range(order):
        column = np.ones(1)
        for t in [b] * j + [a] * (order - 1 - j):
            column = (1 - t) * np.pad(column, (0, 1)) + t * np.pad(column, (1, 0))
        matrix[j] = column
    return matrix


def diagonal(order: int) -> Array:
    """Matrix `(2n − 1, n, n)` to the curve `u = v` of a surface with n × n poles."""
    matrix = np.zeros((2 * order - 1, order, order))
    for i in range(order):
        for j in range(order):
            share = comb(order - 1, i) * comb(order - 1, j) / comb(2 * order - 2, i + j)
            matrix[i + j, i, j] = share
    return matrix


def chebyshev(order: int) -> Array:
    """Chebyshev nodes of [0, 1], the best places to sample a polynomial."""
    return (1 - np.cos((2 * np.arange(order) + 1) * np.pi / (2 * order))) / 2
