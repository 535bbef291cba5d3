"""The golden cases and the reference results, by the functions a Python program calls."""

import json
from fractions import Fraction
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

import pforms as pf

CASES = Path(__file__).parents[3] / "cases"
ACCURACY = 1e-12

# What a formula calls by other words.
FIT_PARTS = {"form": "form", "error": "max_error", "mean error": "rms_error"}


def euclidean(point):
    """A point of a sheet as the numbers a Python program gives."""
    return point.poles if isinstance(point, pf.Form) else point


def lit(f, normal, **more):
    """A lamp of weight 0 is a direction."""
    lamp = more.pop("from", None)
    if lamp is not None:
        more["lamp" if lamp.weights else "direction"] = lamp.poles
    return pf.project_to_plane(f, normal, **more)


def listed(found, net, names, part):
    """The record of a formula: lists of each point where the fields of a record have one row."""
    ends = list(pairwise(found.starts.tolist()))
    record = {}
    for name in names:
        field = getattr(found, name)
        if name == "complete":
            each = np.ravel(field).tolist()
        elif name == "doubts":
            each = [field[found.doubtful == i].tolist() for i in range(len(ends))]
        else:
            each = [np.asarray(field)[a:b].tolist() for a, b in ends]
        record[name] = each if net.axes else each[0]
    return record[part] if part else record


def inverted(host, net, part=None, **more):
    names = ("parameters", "distances", "errors", "proved", "complete", "doubts")
    return listed(pf.invert(host, net.poles, **more), net, names, part)


def projected(f, net, part=None, **more):
    """The record of a formula: its points are the poles of a net."""
    found = pf.project(f, net.poles, **more)
    if more.get("all"):
        names = ("parameters", "distances", "kinds", "errors", "proved", "complete", "doubts")
        return listed(found, net, names, part)
    names = ("parameters", "point", "distance", "gap", "unique")
    record = dict(zip(names, found, strict=True))
    return record[part] if part else record


def net_of(shape):
    """The poles of a spline, or the form itself."""
    return shape.net if isinstance(shape, pf.Spline) else shape


def nets_of(function):
    """The same function, with the poles of a spline for an answer."""
    return lambda *given, **more: net_of(function(*given, **more))


def patch_of(function):
    """The part of a record that a formula asks for."""
    return lambda *given, part="form", **more: getattr(function(*given, **more), part)


def offset(operator):
    """A parallel or a shell: the number of a report, or its net; a side is a point."""

    def call(f, distance, part=None, side=None, **more):
        found = operator(
            f, distance, side=None if side is None else side.poles, report=True, **more
        )
        return getattr(found, part) if part else found.spline.net

    return call


# What a formula calls by other words.
TUBE_PARTS = {"tube": "spline", "error": "error", "bending": "bending", "closing": "closing"}


def tube(of):
    """A tube as the cases ask for it: one of its points, or what is known of it."""

    def call(*arguments, part="tube", at=None, **more):
        made = of(*arguments, report=True, **more)._asdict()[TUBE_PARTS[part]]
        return made if at is None else made(*at)

    return call


def solid(of):
    """A number of the report of a combination of solids."""

    def call(*solids, part="mesh", **more):
        return getattr(of(*solids, report=True, **more), part)

    return call


def unrolled(f, part=None):
    found = pf.unroll(f, report=True)
    return getattr(found, part) if part else found.spline.net


def straight(f, start, direction, length, *, part="curve", **more):
    """A geodesic as the cases ask for it."""
    if isinstance(direction, pf.Form):
        direction = direction.poles
    line = pf.geodesic(f, start.poles, direction, length, **more)
    found = line.spline.net if part == "curve" else getattr(line, part)
    return 0.0 if found is None else found


def boarded(f, lines, width, *, part="strip", **more):
    """A plank as the cases ask for it."""
    boards = pf.planks(f, lines, width, **more)
    several = isinstance(boards, list)
    found = []
    for board in boards if several else [boards]:
        if part == "crossings":
            marks = board.marks
            places = zip(marks.at, marks.angles, marks.others, strict=True)
            found.append([[at, angle, other + 1] for at, angle, other in places])
        else:
            one = getattr(board, part)
            found.append(one.net if isinstance(one, pf.Spline) else 0.0 if one is None else one)
    return found if several else found[0]


def joining(f, p, q, *, part="curve", **more):
    """A geodesic between two points as the cases ask for it."""
    way = pf.geodesic_between(f, p.poles, q.poles, **more)
    return way.geodesic.spline.net if part == "curve" else getattr(way, part)


def unit_speed(f, *more, part="spline", accuracy=1e-9):
    """A curve at unit speed, one of its points, or a part of the report."""
    if f == "point":
        curve, s = more
        return pf.by_arc_length(curve)(s)
    even = pf.by_arc_length(f, accuracy=accuracy, report=True)
    return even.spline.net if part == "spline" else getattr(even, part)


def concatenated(forms, t=None, **more):
    spline = pf.concatenate(forms, **more)
    return spline.net if t is None else spline(t)


def joint(f, *more, part=None, **options):
    """A joint by the names of a formula."""
    if f == "bspline":
        net, degree = more
        return [getattr(one, part) for _, one in pf.continuity(pf.bspline(net, degree))]
    found = pf.continuity(f, *more, **options)._asdict()
    record = {name.replace("_", " "): value for name, value in found.items()}
    for name in ("parametric", "geometric"):
        record[name] = -1 if record[name] is None else record[name]
    return record[part] if part else record


def through(f, *more, **options):
    at = more[1:]
    if "tangents" in options:
        options["tangents"] = options["tangents"].poles
    if "parameters" in options:
        options["params"] = options.pop("parameters")
    spline = pf.interpolating_spline(f, *more[:1], **options)
    return spline(*at) if at else spline.net


def rational_spline(f, weights, knots, *at):
    count = np.shape(f.poles)[:-1]
    if np.size(weights) == 1:
        weights = np.full(count, weights)
    elif np.size(weights) == np.prod(count):
        weights = np.reshape(weights, count)
    spline = pf.nurbs(f.poles, weights, knots)
    return spline(*at) if at else spline.pieces


def at_length(f, *more):
    if f == "point":
        curve, length = more
        return curve(pf.parameter_at_length(curve, length))
    return pf.parameter_at_length(f, *more)


def fewer_knots(f, *more):
    if f == "polygon":
        net, knots = more
        return pf.remove_knots(pf.bspline(net, 1), knots)
    inserted, *knots = more
    return pf.remove_knots(pf.insert_knots(f, inserted), *knots).net


def differentiated(result, source, *cells):
    """The derivatives as a formula lists them: of one number no list is made."""
    sheet = pf.Sheet()
    for row, cell in enumerate(cells, 1):
        sheet[f"A{row}"] = cell
    matrix = sheet.sensitivities(result, source).toarray()
    rows = [row[0] if row.size == 1 else row for row in matrix]
    return rows[0] if len(rows) == 1 else rows


def little_area(*boundary, part="surface", **more):
    found = pf.minimal(*boundary, report=part != "surface", **more)
    return found if part == "surface" else getattr(found, {"coons": "coons_area"}.get(part, part))


def heavy(*forms, part=None, **more):
    """The record of a formula."""
    found = pf.inertia(*forms, **more)._asdict()
    return found[part] if part else found


def boxed(*forms, part=None, **more):
    found = pf.box(*forms, **more)._asdict()
    return found[part] if part else found


def folded(f, part=None):
    """The record of a formula, where parameters that were not found are an empty list."""
    found = pf.is_injective(f, report=True)._asdict()
    return found[part] if part else found


def two_thirds(*given):
    """Two points are a net in a sheet."""
    found = pf.thirds(*given)
    points = all(isinstance(form, pf.Form) and form.orders == () for form in found)
    return pf.Form([point.poles for point in found]) if points else found


# How the arguments of a golden case are handed over: `f` a form, then what the operator takes.
CALLS = {
    "affine_matrix": pf.affine_matrix,
    "affine_sweep": pf.affine_sweep,
    "bernstein": pf.bernstein,
    "blossom": lambda f, *lists: f.blossom(*(lists if isinstance(lists[0], list) else [lists])),
    "iterate": pf.iterate,
    "peano": lambda *given: pf.peano(*given).net,
    "random_points": pf.random_points,
    "thirds": two_thirds,
    "common": solid(pf.common),
    "difference": solid(pf.difference),
    "union": solid(pf.union),
    "combine": lambda k, *forms, **more: pf.combine(k, forms, **more),
    "cube": pf.cube,
    "extrude": pf.extrude,
    "facet": pf.facet,
    "line": pf.line,
    "ruled": pf.ruled,
    "symmetric": pf.symmetric,
    "coons": pf.coons,
    "derivative": lambda f, orders: f.derivative(orders),
    "diagonal": lambda f, axes=None: f.diagonal(axes),
    "elevate": lambda f, by: f.elevate(by),
    "evaluate": lambda f, *at: f(*at),
    "explain": pf.explain,
    "arc_length": pf.arc_length,
    "area": pf.area,
    "box": boxed,
    "centroid": pf.centroid,
    "inertia": heavy,
    "is_injective": folded,
    "jacobian": pf.jacobian,
    "slice": pf.slice,
    "volume": pf.volume,
    "binormal_form": pf.binormal_form,
    "bspline": lambda *f, **more: pf.bspline(*f, **more).pieces,
    "by_arc_length": unit_speed,
    "concatenate": concatenated,
    "continuity": joint,
    "insert_knots": lambda f, knots, **more: pf.insert_knots(f, knots, **more).net,
    "interpolating_spline": through,
    "join_forms": lambda f, g, order, **more: list(pf.join_forms(f, g, order, **more)[:2]),
    "nurbs": rational_spline,
    "parameter_at_length": at_length,
    "remove_knots": fewer_knots,
    "curvature": lambda f, *at, part=None: f.frame(*at)[part] if part else f.curvature(*at),
    "fit": lambda f, orders, part="form", parameters="chord", **more: pf.fit(
        f.poles, orders, parameters, report=True, **more
    )._asdict()[FIT_PARTS[part]],
    "frame": lambda f, *at, part=None, **more: (
        f.frame(*at, **more)[part] if part else f.frame(*at, **more)
    ),
    "forecast": lambda inner, host: pf.forecast(inner, host),
    "geodesic": straight,
    "geodesic_between": joining,
    "planks": boarded,
    "gordon": lambda us, vs, u=None, v=None, part="surface", **more: getattr(
        pf.gordon(us, vs, u, v, report=True, **more), part
    ),
    "grid": lambda f, *lists: pf.Form(f.grid(*lists)),
    "kind": lambda f: f.kind,
    "golden": lambda a, b, *at: pf.golden(a, b)(*at) if at else pf.golden(a, b).poles,
    "ratios": lambda f, *axis, part=None: (
        getattr(pf.ratios(f, *axis), part) if part else pf.ratios(f, *axis)
    ),
    "minimal": little_area,
    "normal_form": pf.normal_form,
    "is_developable": lambda f, part="developable": getattr(
        pf.is_developable(f, report=True), part
    ),
    "offset_poles": lambda f, distance, side=None: pf.offset_poles(
        f, distance, side=None if side is None else side.poles
    ),
    "orders": lambda f: f.orders,
    "mirror": pf.mirror,
    "project_to_plane": lit,
    "rotate": pf.rotate,
    "scale": lambda f, factors, **more: pf.scale(f, euclidean(factors), **more),
    "shear": pf.shear,
    "transform": pf.transform,
    "translate": pf.translate,
    "parallel": offset(pf.parallel),
    "shell": offset(pf.shell),
    "tangent_developable": pf.tangent_developable,
    "unroll": unrolled,
    "pipe": tube(pf.pipe),
    "waving_pipe": tube(pf.waving_pipe),
    "polyline": lambda host, *points: pf.polyline(host, [p.poles for p in points]),
    "tangent_form": pf.tangent_form,
    "weights": lambda f: f.weights.tolist(),
    "with_pole": lambda f, *index_and_point: f.with_pole(
        index_and_point[0] if len(index_and_point) == 2 else index_and_point[:-1],
        index_and_point[-1],
    ),
    "hodograph": lambda f, axis: f.hodograph(axis),
    "immerse": pf.immerse,
    "interpolate": pf.interpolate,
    "invert": inverted,
    "midpoint": pf.midpoint,
    "partition": pf.partition,
    "pascal": pf.pascal,
    "project": projected,
    "reparametrise": lambda f, axis, c: f.reparametrise(axis, c),
    "reverse": lambda f, axis: f.reverse(axis),
    "segment": lambda host, a, b: pf.segment(host, a.poles, b.poles),
    "sensitivities": differentiated,
    "split": lambda f, axis, t: f.split(axis, t),
    "stack": pf.stack,
    "stretch": lambda f, a, b: f.stretch(a, b),
    "sub": lambda f, axis, t: f.sub(axis, t),
    "subdivide": lambda f, r: f.subdivide(r).net,
    "tile": lambda cell, cage, counts: pf.tile([cell], cage, counts),
    "transpose": lambda f, axes: f.transpose(axes),
    "whole_line": lambda f, axis=0: f.whole_line(axis),
    "arc": nets_of(pf.arc),
    "bezier_cone": patch_of(pf.bezier_cone),
    "bezier_cylinder": patch_of(pf.bezier_cylinder),
    "bezier_sphere": patch_of(pf.bezier_sphere),
    "bezier_torus": patch_of(pf.bezier_torus),
    "circle": nets_of(pf.circle),
    "classify": lambda f, *accuracy: f.classify(**dict(zip(["accuracy"], accuracy, strict=False))),
    "cone": lambda r, h, top=0, **more: net_of(pf.cone(r, h, top=top, **more)),
    "conic": pf.conic,
    "cross": nets_of(pf.cross),
    "cylinder": nets_of(pf.cylinder),
    "ellipse": nets_of(pf.ellipse),
    "hyperbola": pf.hyperbola,
    "parabola": pf.parabola,
    "revolve": nets_of(pf.revolve),
    "sphere": nets_of(pf.sphere),
    "torus": nets_of(pf.torus),
    "torus_knot": nets_of(pf.torus_knot),
    "viviani": nets_of(pf.viviani),
}


# An error in a sheet, where no point at all is no form; in NumPy an empty array is an answer.
# In Python the source is a text, so that what is no place is misspelt, not of the wrong kind.
# A sheet draws fewer points than memory holds.
OTHERWISE = {"grid-004", "sensitivities-007", "random_points-003"}


def cases(folder, names):
    return [
        pytest.param(name, case, id=case["id"])
        for name in names
        for case in json.loads((CASES / folder / f"{name}.json").read_text())["cases"]
        if case["id"] not in OTHERWISE
    ]


def number(text):
    exact = Fraction(text)
    return int(exact) if exact.denominator == 1 else float(exact)


def form(record):
    poles = np.array([[float(Fraction(x)) for x in pole] for pole in record["poles"]])
    return pf.Form.from_homogeneous(poles.reshape(*record["orders"], -1))


def argument(value):
    [(what, content)] = value.items()
    read = {"form": form, "number": number, "list": lambda items: [argument(x) for x in items]}
    return read.get(what, lambda same: same)(content)


def near(came, wanted, accuracy=ACCURACY):
    wanted = np.asarray(wanted, float)
    size = max(1.0, np.abs(wanted).max(initial=0))
    np.testing.assert_allclose(np.asarray(came, float), wanted, rtol=0, atol=accuracy * size)


def compare(came, expected, accuracy=ACCURACY):
    if "contains" in expected:
        assert set(expected["contains"]) <= set(came.splitlines())
    elif "text" in expected:
        assert came == expected["text"]
    elif "record" in expected:
        for name, wanted in expected["record"].items():
            compare(came[name], wanted, accuracy)
    elif "decimal" in expected or "decimals" in expected:
        near(came, expected.get("decimal", expected.get("decimals")), accuracy)
    elif "at_least" in expected:
        assert came >= number(expected["at_least"])
    elif "truth" in expected:
        assert came == expected["truth"]
    elif "list" in expected:
        assert len(came) == len(expected["list"])
        for one, wanted in zip(came, expected["list"], strict=True):
            compare(one, wanted, accuracy)
    elif "number" in expected:
        near(came, number(expected["number"]), accuracy)
    elif isinstance(came, pf.Form):
        wanted = form(expected.get("form") or expected["net"])
        assert came.orders == wanted.orders
        near(came.homogeneous, wanted.homogeneous, accuracy)
    else:
        wanted = form(expected["form"])
        whole = np.size(came) == wanted.homogeneous.size
        near(came, wanted.homogeneous if whole else wanted.poles, accuracy)


@pytest.mark.parametrize(("name", "case"), cases("operators", CALLS))
def test_golden_case(name, case):
    call = CALLS[name]
    arguments = [argument(value) for value in case["arguments"]]
    options = {name: argument(value) for name, value in case.get("options", {}).items()}
    if "error" not in case["expected"]:
        accuracy = max(ACCURACY, case.get("tolerance", 0))
        compare(call(*arguments, **options), case["expected"], accuracy)
        return
    # A name that no operator has is an argument like others here.
    family = case["expected"]["error"].replace("Name", "Domain")
    error = getattr(pf, f"{family}Error", pf.FormatError)
    with pytest.raises(error):
        call(*arguments, **options)


# The same for the results of the original system: arguments by name.
REFERENCE = {
    "diagonalisation": lambda f, p: f.diagonal(p["axes"]),
    "elevation_curve": lambda f, p: f.elevate(p["by"]),
    "elevation_surface": lambda f, p: f.elevate(p["by"]),
    "stretch": lambda f, p: f.stretch(p["a"], p["b"]),
    "subdivision": lambda f, p: f.subdivide(p["r"]),
    "subform": lambda f, p: f.sub(p["axis"], p["t"]),
    "translate": lambda f, p: f.translate(p["by"]),
    "scale": lambda f, p: f.scale(p["factors"]),
    "rotate": lambda f, p: f.rotate(p["degrees"], unit="degrees"),
    "transform": lambda f, p: f.transform(p["matrix"]),
    "offset_poles": lambda f, p: f.offset_poles(p["distance"]),
    "interpolation_surface": lambda f, p: pf.interpolate(f, homogeneous=p["homogeneous"]),
}


@pytest.mark.parametrize(("name", "case"), cases("reference", REFERENCE))
def test_reference_case(name, case):
    came = REFERENCE[name](pf.Form.from_homogeneous(np.array(case["input"])), case["params"])
    near(came.homogeneous, case["expected"])


IMMERSIONS = ["immersion_curve_in_surface", "immersion_general"]
FRENET = ["frame_curve"]
TANGENT = ["frame_surface", "frame_volume"]


@pytest.mark.parametrize(("_name", "case"), cases("reference", IMMERSIONS))
def test_reference_immersion(_name, case):
    inner, host = (pf.Form.from_homogeneous(np.array(case["input"][k])) for k in ("inner", "host"))
    near(host(inner).homogeneous, case["expected"])


@pytest.mark.parametrize(("_name", "case"), cases("reference", FRENET))
def test_reference_frenet_frame(_name, case):
    curve = pf.Form.from_homogeneous(np.array(case["input"]))
    frame = curve.frame(case["params"]["at"], kind="frenet")
    for part, wanted in case["expected"].items():
        near(getattr(frame, part), wanted, 1e-11)


@pytest.mark.parametrize(("_name", "case"), cases("reference", TANGENT))
def test_reference_tangent_frame(_name, case):
    form = pf.Form.from_homogeneous(np.array(case["input"]))
    frame = form.frame(*case["params"]["at"])
    for part, wanted in case["expected"].items():
        near(getattr(frame, part), wanted, 1e-11)
