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
    bernstein,
    cap,
    combine,
    coons,
    explain,
    fit,
    forecast,
    grid,
    immerse,
    immerse_points,
    interpolate,
    midpoint,
    mirror,
    partition,
    pascal,
    polyline,
    project_to_plane,
    rotate,
    scale,
    segment,
    set_cap,
    set_threads,
    shear,
    stack,
    tessellate,
    threads,
    tile,
    transform,
    translate,
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
from pforms.records import Fit, Frame, Mesh, Polyline, Projection

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
    "DegenerateError",
    "DomainError",
    "Fit",
    "Form",
    "FormatError",
    "Frame",
    "Immersed",
    "LimitError",
    "Mesh",
    "PformsError",
    "Polyline",
    "Projection",
    "ShapeError",
    "Sheet",
    "Spline",
    "__version__",
    "affine_matrix",
    "affine_sweep",
    "bernstein",
    "binormal_form",
    "blossom",
    "cap",
    "combine",
    "coons",
    "curvature",
    "derivative",
    "diagonal",
    "draw",
    "elevate",
    "evaluate",
    "explain",
    "fit",
    "forecast",
    "frame",
    "grid",
    "hodograph",
    "immerse",
    "immerse_points",
    "interpolate",
    "load",
    "midpoint",
    "mirror",
    "normal_form",
    "normals",
    "partition",
    "pascal",
    "polyline",
    "project",
    "project_to_plane",
    "reduce",
    "reparametrise",
    "reverse",
    "rotate",
    "save",
    "scale",
    "segment",
    "set_cap",
    "set_threads",
    "shear",
    "split",
    "stack",
    "stretch",
    "sub",
    "subdivide",
    "tangent_form",
    "tessellate",
    "threads",
    "tile",
    "transform",
    "translate",
    "transpose",
    "unstack",
    "whole_line",
    "with_pole",
]
