"""Areas of bicubic patches, volumes of triquadratic forms, and least boxes, one call for each.

Ours are proved to 1e-12; those of the peers are taken at what they offer: 24 nodes of Gauss in
NumPy, which are enough for these forms and prove nothing, adaptive cubature in SciPy to 1e-10, the
properties of OpenCASCADE to 1e-10, splinepy's quadrature of its own choice.
"""

from __future__ import annotations

import numpy as np

import bernstein
from bernstein import Net
from contest import Array, Native, Question, Work

VARIANTS = (
    "area polynomial",
    "area rational",
    "volume polynomial",
    "volume rational",
    "box polynomial",
    "box rational",
)
SIZES = (100, 10, 3)

NODES = 24


def question(variant: str, count: int) -> Question:
    what = variant.split()[0]
    orders = (3, 3, 3) if what == "volume" else (4, 4)
    nets = [bernstein.sheet(seed, variant, *orders) for seed in range(count)]

    def ours(threads: int) -> Work:
        import pforms as pf
        from peers.ours import form

        forms = [form(net, threads) for net in nets]
        if what == "box":
            return Work(
                lambda: [pf.box(one) for one in forms],
                lambda found: np.array([[*one.lower, *one.upper] for one in found]),
            )
        measure = pf.area if what == "area" else pf.volume
        return Work(lambda: [measure(one) for one in forms])

    def numpy(_: int) -> Work:
        if what == "box":
            return Work(lambda: [sampled_box(net, 1025) for net in nets])
        return Work(lambda: [quadrature(net, NODES) for net in nets])

    def scipy(_: int) -> Work:
        from scipy.integrate import cubature

        def adaptive(net: Net) -> float:
            axes = len(net.orders)
            found = cubature(
                lambda at: element(net, at), [0.0] * axes, [1.0] * axes, rtol=1e-10, atol=0.0
            )
            return float(found.estimate)

        return Work(lambda: [adaptive(net) for net in nets])

    def splinepy(_: int) -> Work:
        from peers.splinepy import form

        forms = [form(net) for net in nets]
        return Work(lambda: [one.integrate.volume() for one in forms])

    def occt(_: int) -> Work:
        from OCP.Bnd import Bnd_Box
        from OCP.BndLib import BndLib_AddSurface
        from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeFace
        from OCP.BRepGProp import BRepGProp
        from OCP.GeomAdaptor import GeomAdaptor_Surface
        from OCP.GProp import GProp_GProps

        from peers.occt import surface

        def face_area(face: Native) -> float:
            properties = GProp_GProps()
            BRepGProp.SurfaceProperties_s(face, properties, 1e-10)
            return float(properties.Mass())

        def surface_box(adaptor: Native) -> tuple[float, ...]:
            box = Bnd_Box()
            BndLib_AddSurface.AddOptimal_s(adaptor, 1e-10, box)
            corners = box.CornerMin(), box.CornerMax()
            return tuple(x for corner in corners for x in (corner.X(), corner.Y(), corner.Z()))

        if what == "box":
            adaptors = [GeomAdaptor_Surface(surface(net)) for net in nets]
            return Work(lambda: [surface_box(adaptor) for adaptor in adaptors])
        faces = [BRepBuilderAPI_MakeFace(surface(net), 1e-9).Face() for net in nets]
        return Work(lambda: [face_area(face) for face in faces])

    def error(found: Array) -> float:
        if what == "box":
            truth = np.array([sampled_box(net, 4097) for net in nets])
            return float(np.max(np.abs(found - truth)) / np.max(np.abs(truth)))
        truth = np.array([quadrature(net, 2 * NODES) for net in nets])
        return float(np.max(np.abs(found - truth) / truth))

    answers = {"pforms": ours, "numpy": numpy}
    if what != "box":
        answers |= {"scipy": scipy, "splinepy": splinepy}
    if what != "volume":
        answers["occt"] = occt
    # Boxes of samples, and the truth by samples, are short by a square of their distance.
    accuracy = 1e-6 if what == "box" else 1e-9
    return Question(count, what, answers, error, accuracy, threads=(1,))


def element(net: Net, at: Array) -> Array:
    """The element of area or volume at parameters `(m, axes)`."""
    axes, poles = at.shape[1], net.homogeneous
    tables = [bernstein.values(order, at[:, k]) for k, order in enumerate(net.orders)]
    steep = [bernstein.slopes(order, at[:, k]) for k, order in enumerate(net.orders)]
    letters = "abc"[:axes]
    rule = ",".join("m" + letter for letter in letters) + f",{letters}x->mx"
    point = np.einsum(rule, *tables, poles)
    columns = []
    for axis in range(axes):
        chosen = [steep[k] if k == axis else tables[k] for k in range(axes)]
        column = np.einsum(rule, *chosen, poles)
        if net.weights is not None:
            weight = point[:, -1:]
            column = (column[:, :-1] * weight - point[:, :-1] * column[:, -1:]) / weight**2
        columns.append(column)
    jacobian = np.stack(columns, axis=-1)
    gram = np.swapaxes(jacobian, 1, 2) @ jacobian
    return np.asarray(np.sqrt(np.linalg.det(gram)))


def quadrature(net: Net, nodes: int) -> float:
    """A product of Gauss rules over the whole window."""
    at, weights = np.polynomial.legendre.leggauss(nodes)
    axes = len(net.orders)
    lattice = np.stack(np.meshgrid(*[(at + 1) / 2] * axes, indexing="ij"), axis=-1)
    shares = np.prod(np.meshgrid(*[weights / 2] * axes, indexing="ij"), axis=0)
    return float(element(net, lattice.reshape(-1, axes)) @ shares.ravel())


def sampled_box(net: Net, side: int) -> Array:
    """The box of samples."""
    at = np.linspace(0.0, 1.0, side)
    tables = [bernstein.values(order, at) for order in net.orders]
    points = net.project(bernstein.on_grid(net.homogeneous, *tables)).reshape(-1, 3)
    return np.concatenate([points.min(axis=0), points.max(axis=0)])
