"""Rational Bézier forms in any number of parameters, exactly.

>>> import pforms as pf
>>> facet = pf.stack(pf.Form([(0, 0, 0), (0, 1, 1)]), pf.Form([(1, 0, 1), (1, 1, 0)]))
>>> facet
<pforms.Form pS22 in 3D>
>>> facet.diagonal()(0.5)
array([0.5, 0.5, 0.5])

Every method of a form that is an operator is also a function: ``pf.elevate(form, 1)`` is
``form.elevate(1)``. Many forms come and go in one call: ``pf.grid(forms, 17, 17)`` takes a list,
and a form with an axis more is a list in one array: ``pf.stack(forms).elevate((0, 1, 1))``.
"""

from pforms._pforms import (
    Form,
    Immersed,
    Sheet,
    Spline,
    __version__,
    affine_matrix,
    affine_sweep,
    arc,
    bernstein,
    bezier_cone,
    bezier_cylinder,
    bezier_sphere,
    bezier_torus,
    cap,
    circle,
    classify,
    combine,
    cone,
    conic,
    coons,
    cross,
    cylinder,
    ellipse,
    explain,
    fit,
    forecast,
    grid,
    hyperbola,
    immerse,
    immerse_points,
    interpolate,
    is_developable,
    midpoint,
    mirror,
    offset_poles,
    parabola,
    parallel,
    partition,
    pascal,
    polyline,
    project_to_plane,
    revolve,
    rotate,
    scale,
    segment,
    set_cap,
    set_threads,
    shear,
    shell,
    sphere,
    stack,
    tangent_developable,
    tessellate,
    threads,
    tile,
    torus,
    torus_knot,
    transform,
    translate,
    unroll,
    viviani,
)
from pforms.errors import (
    AccuracyError,
    ArgumentError,
    DegenerateError,
    DomainError,
    FormatError,
    LimitError,
    PformsError,
    ShapeError,
)
from pforms.files import draw, load, save
from pforms.records import (
    Bicubic,
    Developability,
    Fit,
    Frame,
    Mesh,
    Parallel,
    Polyline,
    Projection,
    Unrolling,
)

binormal_form = Form.binormal_form
blossom = Form.blossom
curvature = Form.curvature
derivative = Form.derivative
diagonal = Form.diagonal
elevate = Form.elevate
evaluate = Form.evaluate
frame = Form.frame
hodograph = Form.hodograph
normal_form = Form.normal_form
normals = Form.normals
project = Form.project
reduce = Form.reduce
reparametrise = Form.reparametrise
reverse = Form.reverse
split = Form.split
stretch = Form.stretch
sub = Form.sub
subdivide = Form.subdivide
tangent_form = Form.tangent_form
transpose = Form.transpose
unstack = Form.unstack
whole_line = Form.whole_line
with_pole = Form.with_pole

__all__ = [
    "AccuracyError",
    "ArgumentError",
    "Bicubic",
    "DegenerateError",
    "Developability",
    "DomainError",
    "Fit",
    "Form",
    "FormatError",
    "Frame",
    "Immersed",
    "LimitError",
    "Mesh",
    "Parallel",
    "PformsError",
    "Polyline",
    "Projection",
    "ShapeError",
    "Sheet",
    "Spline",
    "Unrolling",
    "__version__",
    "affine_matrix",
    "affine_sweep",
    "arc",
    "bernstein",
    "bezier_cone",
    "bezier_cylinder",
    "bezier_sphere",
    "bezier_torus",
    "binormal_form",
    "blossom",
    "cap",
    "circle",
    "classify",
    "combine",
    "cone",
    "conic",
    "coons",
    "cross",
    "curvature",
    "cylinder",
    "derivative",
    "diagonal",
    "draw",
    "elevate",
    "ellipse",
    "evaluate",
    "explain",
    "fit",
    "forecast",
    "frame",
    "grid",
    "hodograph",
    "hyperbola",
    "immerse",
    "immerse_points",
    "interpolate",
    "is_developable",
    "load",
    "midpoint",
    "mirror",
    "normal_form",
    "normals",
    "offset_poles",
    "parabola",
    "parallel",
    "partition",
    "pascal",
    "polyline",
    "project",
    "project_to_plane",
    "reduce",
    "reparametrise",
    "reverse",
    "revolve",
    "rotate",
    "save",
    "scale",
    "segment",
    "set_cap",
    "set_threads",
    "shear",
    "shell",
    "sphere",
    "split",
    "stack",
    "stretch",
    "sub",
    "subdivide",
    "tangent_developable",
    "tangent_form",
    "tessellate",
    "threads",
    "tile",
    "torus",
    "torus_knot",
    "transform",
    "translate",
    "transpose",
    "unroll",
    "unstack",
    "viviani",
    "whole_line",
    "with_pole",
]
