# Types of the compiled half; what the functions do stands in their docstrings.
from collections.abc import Callable, Iterable, Iterator, Sequence
from fractions import Fraction
from os import PathLike
from typing import Any, Final, Literal, TypeAlias, TypeVar, final, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pforms.records import (
    Bicubic,
    Box,
    Connection,
    Continuity,
    Crossings,
    Developability,
    Feet,
    Fit,
    Folds,
    Frame,
    Geodesic,
    Geodesics,
    Inertia,
    Intersection,
    Inversion,
    Joined,
    Length,
    Measure,
    Mesh,
    Minimal,
    Network,
    Parallel,
    Pipe,
    Plank,
    Projection,
    Ratios,
    Simplified,
    Solid,
    UnitSpeed,
    Unrolling,
)
from pforms.sparse import Sparse

_Array: TypeAlias = NDArray[np.float64]
_Number: TypeAlias = float | Fraction | np.floating[Any] | np.integer[Any]
_PerAxis: TypeAlias = _Number | Sequence[_Number] | _Array | NDArray[np.integer[Any]]
_WholePerAxis: TypeAlias = int | Sequence[int] | NDArray[np.integer[Any]]
_Vector: TypeAlias = Sequence[_Number] | _Array | NDArray[np.integer[Any]] | Form
_Unit: TypeAlias = Literal["radians", "degrees", "half tangent"]
_Movable = TypeVar("_Movable", Form, Spline, Immersed)
_Conic: TypeAlias = Literal["circle", "ellipse", "parabola", "hyperbola", "segment", "point"]
_ListPerAxis: TypeAlias = Sequence[_Number] | Sequence[Sequence[_Number] | _Array] | _Array
_Ends: TypeAlias = Sequence[int] | Sequence[Sequence[int]] | NDArray[np.integer[Any]]
_EndRule: TypeAlias = Literal["natural", "clamped", "not-a-knot", "periodic"]
_Shape: TypeAlias = Form | Spline | ArrayLike
_Measured: TypeAlias = _Shape | Mesh
_KnotRule: TypeAlias = Literal["uniform", "clamped"] | Sequence[_Number] | _Array

__all__ = [
    "Embedding",
    "Form",
    "Immersed",
    "Sheet",
    "Spline",
    "__version__",
    "_draw_forms",
    "_make_mesh",
    "_mesh_area",
    "_mesh_is_closed",
    "_mesh_volume",
    "_read_forms",
    "_write_forms",
    "affine_matrix",
    "affine_sweep",
    "arc",
    "arc_length",
    "area",
    "bernstein",
    "bezier_cone",
    "bezier_cylinder",
    "bezier_sphere",
    "bezier_torus",
    "box",
    "bspline",
    "by_arc_length",
    "cap",
    "centroid",
    "circle",
    "classify",
    "combine",
    "common",
    "concatenate",
    "cone",
    "conic",
    "continuity",
    "coons",
    "cross",
    "cube",
    "cylinder",
    "deform",
    "difference",
    "ellipse",
    "embed",
    "explain",
    "extrude",
    "facet",
    "fit",
    "forecast",
    "geodesic",
    "geodesic_between",
    "golden",
    "gordon",
    "grid",
    "hyperbola",
    "immerse",
    "immerse_points",
    "inertia",
    "insert_knots",
    "interpolate",
    "interpolating_spline",
    "intersect",
    "intersect_many",
    "is_developable",
    "is_injective",
    "iterate",
    "jacobian",
    "join_forms",
    "line",
    "midpoint",
    "minimal",
    "mirror",
    "nurbs",
    "offset_poles",
    "parabola",
    "parallel",
    "parameter_at_length",
    "partition",
    "pascal",
    "peano",
    "pipe",
    "planks",
    "polyline",
    "project_to_plane",
    "random_points",
    "ratios",
    "remove_knots",
    "revolve",
    "rotate",
    "ruled",
    "scale",
    "segment",
    "set_cap",
    "set_threads",
    "shear",
    "shell",
    "slice",
    "sphere",
    "stack",
    "symmetric",
    "tangent_developable",
    "tessellate",
    "thirds",
    "threads",
    "tile",
    "torus",
    "torus_knot",
    "transform",
    "translate",
    "union",
    "unroll",
    "viviani",
    "volume",
    "waving_pipe",
]

__version__: Final[str]

@final
class Form:
    __array_ufunc__: Final[None]
    def __new__(cls, poles: ArrayLike, weights: ArrayLike | None = None) -> Form: ...
    @classmethod
    def from_homogeneous(cls, array: ArrayLike) -> Form: ...
    @property
    def poles(self) -> _Array: ...
    @property
    def weights(self) -> _Array: ...
    @property
    def homogeneous(self) -> _Array: ...
    @property
    def orders(self) -> tuple[int, ...]: ...
    @property
    def degrees(self) -> tuple[int, ...]: ...
    @property
    def axes(self) -> int: ...
    @property
    def ambient(self) -> int: ...
    @property
    def kind(self) -> str: ...
    @property
    def is_rational(self) -> bool: ...
    def with_pole(
        self, index: _WholePerAxis, point: ArrayLike | Form, *, weight: float | None = None
    ) -> Form: ...
    @overload
    def __call__(self, inner: Form, /) -> Form: ...
    @overload
    def __call__(self, inner: Spline, /) -> Spline: ...
    @overload
    def __call__(self, *parameters: ArrayLike) -> _Array: ...
    def evaluate(
        self,
        *parameters: ArrayLike,
        derivative: _WholePerAxis | None = None,
        out: _Array | None = None,
    ) -> _Array: ...
    @overload
    def grid(
        self,
        *parameters: int | ArrayLike,
        normals: Literal[False] = False,
        out: _Array | None = None,
    ) -> _Array: ...
    @overload
    def grid(
        self,
        *parameters: int | ArrayLike,
        normals: Literal[True],
        out: tuple[_Array, _Array] | None = None,
    ) -> tuple[_Array, _Array]: ...
    def normals(self, u: ArrayLike, v: ArrayLike, *, out: _Array | None = None) -> _Array: ...
    def frame(
        self,
        *parameters: ArrayLike,
        kind: Literal["frenet", "rotation-minimising", "tangent"] = "frenet",
        unit: bool = True,
        accuracy: float = 1e-10,
    ) -> Frame: ...
    @overload
    def curvature(self, u: ArrayLike, /) -> _Array: ...
    @overload
    def curvature(self, u: ArrayLike, v: ArrayLike, /) -> Frame: ...
    def geodesic(
        self,
        start: ArrayLike,
        direction: ArrayLike,
        length: ArrayLike,
        *,
        accuracy: _Number = 1e-10,
        seams: bool = True,
    ) -> Geodesic | Geodesics: ...
    def planks(
        self,
        lines: Geodesic | Connection | Form | Spline | ArrayLike | Sequence[Any],
        width: _Number,
        *,
        accuracy: _Number = 1e-8,
        marks: bool = True,
    ) -> Plank | list[Plank]: ...
    @overload
    def deform(self, cage: Form, *, rest: Form | Spline | ArrayLike | None = None) -> Form: ...
    @overload
    def deform(self, cage: Spline, *, rest: Form | Spline | ArrayLike | None = None) -> Spline: ...
    def invert(self, points: ArrayLike, *, accuracy: float = 1e-12) -> Inversion: ...
    @overload
    def project(
        self, points: ArrayLike, *, accuracy: float = 1e-12, all: Literal[False] = False
    ) -> Projection: ...
    @overload
    def project(
        self, points: ArrayLike, *, accuracy: float = 1e-12, all: Literal[True]
    ) -> Feet: ...
    def intersect(
        self, other: Form | Spline | ArrayLike, *, accuracy: float = 1e-14
    ) -> Intersection: ...
    @overload
    def parallel(
        self,
        distance: _Number | Form,
        *,
        tolerance: _Number = 1e-06,
        side: ArrayLike | Literal["principal"] | None = None,
        folds: bool = False,
        report: Literal[False] = False,
    ) -> Spline: ...
    @overload
    def parallel(
        self,
        distance: _Number | Form,
        *,
        tolerance: _Number = 1e-06,
        side: ArrayLike | Literal["principal"] | None = None,
        folds: bool = False,
        report: Literal[True],
    ) -> Parallel: ...
    @overload
    def shell(
        self,
        distance: _Number | Form,
        *,
        tolerance: _Number = 1e-06,
        side: ArrayLike | Literal["principal"] | None = None,
        folds: bool = False,
        report: Literal[False] = False,
    ) -> Spline: ...
    @overload
    def shell(
        self,
        distance: _Number | Form,
        *,
        tolerance: _Number = 1e-06,
        side: ArrayLike | Literal["principal"] | None = None,
        folds: bool = False,
        report: Literal[True],
    ) -> Parallel: ...
    def offset_poles(
        self, distance: _Number | Form, *, side: ArrayLike | Literal["principal"] | None = None
    ) -> Form: ...
    def tangent_developable(self, length: _Number = 1.0) -> Form: ...
    @overload
    def is_developable(self, *, report: Literal[False] = False) -> bool: ...
    @overload
    def is_developable(self, *, report: Literal[True]) -> Developability: ...
    @overload
    def unroll(self, *, accuracy: _Number = 1e-12, report: Literal[False] = False) -> Spline: ...
    @overload
    def unroll(self, *, accuracy: _Number = 1e-12, report: Literal[True]) -> Unrolling: ...
    def diagonal(self, axes: Sequence[int] | Literal["all"] | None = None) -> Form: ...
    def sub(self, axis: int, t: _Number) -> Form: ...
    def split(self, axis: int, t: _Number) -> tuple[Form, Form]: ...
    def subdivide(self, r: _WholePerAxis) -> Spline: ...
    def unstack(self) -> list[Form]: ...
    def elevate(self, by: _WholePerAxis) -> Form: ...
    def reduce(self, by: _WholePerAxis) -> tuple[Form, float]: ...
    def stretch(self, a: _PerAxis, b: _PerAxis) -> Form: ...
    def reverse(self, axis: int) -> Form: ...
    def transpose(self, axes: Sequence[int] | None = None) -> Form: ...
    def reparametrise(self, axis: int, c: _Number) -> Form: ...
    def whole_line(self, axis: int = 0) -> list[Form]: ...
    def derivative(self, orders: _WholePerAxis) -> Form: ...
    def hodograph(self, axis: int = 0) -> Form: ...
    def tangent_form(self, axis: int = 0) -> Form: ...
    def normal_form(self) -> Form: ...
    def binormal_form(self) -> Form: ...
    def save(self, path: str | PathLike[str]) -> None: ...
    def blossom(self, *arguments: _Number | Sequence[_Number] | _Array) -> _Array: ...
    @overload
    def symmetric(self, form: Form, *, pointwise: bool = False) -> Form: ...
    @overload
    def symmetric(self, form: Spline, *, pointwise: bool = False) -> Spline: ...
    @overload
    def extrude(self, path: Form | ArrayLike) -> Form: ...
    @overload
    def extrude(self, path: Spline) -> Spline: ...
    @overload
    def ruled(self, second: Form | ArrayLike) -> Form: ...
    @overload
    def ruled(self, second: Spline) -> Spline: ...
    def transform(self, matrix: ArrayLike) -> Form: ...
    def translate(self, by: _Vector) -> Form: ...
    def rotate(
        self,
        angle: _Number | Sequence[_Number] | _Array,
        axis: _Vector | None = None,
        *,
        centre: _Vector | None = None,
        plane: Sequence[int] | None = None,
        unit: _Unit = "radians",
    ) -> Form: ...
    def scale(self, factors: _PerAxis | Form, *, centre: _Vector | None = None) -> Form: ...
    def shear(self, coordinate: int, by: _Vector, *, centre: _Vector | None = None) -> Form: ...
    def mirror(self, normal: _Vector, *, origin: _Vector | None = None) -> Form: ...
    def project_to_plane(
        self,
        normal: _Vector,
        *,
        origin: _Vector | None = None,
        direction: _Vector | None = None,
        lamp: _Vector | None = None,
    ) -> Form: ...
    def __add__(self, other: Form, /) -> Form: ...
    def __radd__(self, other: Form, /) -> Form: ...
    def __sub__(self, other: Form, /) -> Form: ...
    def __rsub__(self, other: Form, /) -> Form: ...
    def __mul__(self, factor: _Number | Form, /) -> Form: ...
    def __rmul__(self, factor: _Number | Form, /) -> Form: ...
    def __truediv__(self, divisor: _Number, /) -> Form: ...
    def __rtruediv__(self, other: Form, /) -> Form: ...
    def __neg__(self) -> Form: ...
    def __pos__(self) -> Form: ...
    def insert_knots(self, knots: _PerAxis, *, axis: int = 0) -> Spline: ...
    @overload
    def remove_knots(
        self,
        knots: _PerAxis | None = None,
        *,
        axis: int = 0,
        accuracy: float = 1e-12,
        report: Literal[False] = False,
    ) -> Spline: ...
    @overload
    def remove_knots(
        self,
        knots: _PerAxis | None = None,
        *,
        axis: int = 0,
        accuracy: float = 1e-12,
        report: Literal[True],
    ) -> Simplified: ...
    @overload
    def continuity(
        self,
        g: None = None,
        *,
        at: _Ends | None = None,
        order: int = 2,
        accuracy: float = 1e-9,
        axis: int = 0,
    ) -> list[tuple[float, Continuity]]: ...
    @overload
    def continuity(
        self,
        g: _Shape,
        *,
        at: _Ends | None = None,
        order: int = 2,
        accuracy: float = 1e-9,
        axis: int = 0,
    ) -> Continuity: ...
    @overload
    def arc_length(
        self,
        a: _Number | None = None,
        b: _Number | None = None,
        *,
        accuracy: float = 1e-12,
        report: Literal[False] = False,
    ) -> float: ...
    @overload
    def arc_length(
        self,
        a: _Number | None = None,
        b: _Number | None = None,
        *,
        accuracy: float = 1e-12,
        report: Literal[True],
    ) -> Length: ...
    @overload
    def parameter_at_length(self, length: _Number, *, accuracy: float = 1e-12) -> float: ...
    @overload
    def parameter_at_length(self, length: ArrayLike, *, accuracy: float = 1e-12) -> _Array: ...
    @overload
    def by_arc_length(
        self, *, accuracy: float = 1e-9, report: Literal[False] = False
    ) -> Spline: ...
    @overload
    def by_arc_length(self, *, accuracy: float = 1e-9, report: Literal[True]) -> UnitSpeed: ...
    @overload
    def area(
        self,
        *,
        signed: bool = False,
        accuracy: float = 1e-12,
        report: Literal[False] = False,
    ) -> float: ...
    @overload
    def area(
        self, *, signed: bool = False, accuracy: float = 1e-12, report: Literal[True]
    ) -> Measure: ...
    @overload
    def volume(
        self,
        *,
        signed: bool = False,
        accuracy: float = 1e-12,
        report: Literal[False] = False,
    ) -> float: ...
    @overload
    def volume(
        self, *, signed: bool = False, accuracy: float = 1e-12, report: Literal[True]
    ) -> Measure: ...
    def centroid(self, *, filled: bool = False, accuracy: float = 1e-12) -> _Array: ...
    def inertia(self, *, filled: bool = False, accuracy: float = 1e-12) -> Inertia: ...
    def box(self, *, accuracy: float = 1e-12) -> Box: ...
    def jacobian(self) -> Form: ...
    @overload
    def is_injective(
        self, *, accuracy: float = 1e-9, report: Literal[False] = False
    ) -> bool | None: ...
    @overload
    def is_injective(self, *, accuracy: float = 1e-9, report: Literal[True]) -> Folds: ...
    @overload
    def slice(self, axis: int, t: _Number) -> Form: ...
    @overload
    def slice(self, axis: int, t: Sequence[_Number]) -> list[Form]: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __copy__(self) -> Form: ...
    def __deepcopy__(self, _memo: object) -> Form: ...
    def __reduce__(self) -> tuple[Any, ...]: ...
    def revolve(
        self,
        angle: _Number | None = None,
        *,
        axis: _PerAxis | Form = ...,
        through: _PerAxis | Form = ...,
        order: Literal[3, 4, 5] = 3,
    ) -> Form | Spline: ...
    def cross(self, section: Form | Spline | ArrayLike) -> Form | Spline: ...
    def classify(self, *, accuracy: _Number = 1e-12) -> _Conic: ...

@final
class Spline:
    __array_ufunc__: Final[None]
    def __new__(
        cls, net: Form | ArrayLike, degrees: _WholePerAxis, knots: _ListPerAxis
    ) -> Spline: ...
    @classmethod
    def from_homogeneous(
        cls, array: ArrayLike, degrees: _WholePerAxis, knots: _ListPerAxis
    ) -> Spline: ...
    @classmethod
    def end_to_end(
        cls, forms: Form | Iterable[Form], breaks: ArrayLike | None = None, axis: int = 0
    ) -> Spline: ...
    @property
    def knots(self) -> tuple[_Array, ...]: ...
    @property
    def homogeneous(self) -> _Array: ...
    @property
    def poles(self) -> _Array: ...
    @property
    def weights(self) -> _Array: ...
    @property
    def orders(self) -> tuple[int, ...]: ...
    @property
    def kind(self) -> str: ...
    @property
    def is_rational(self) -> bool: ...
    @property
    def window(self) -> tuple[tuple[float, float], ...]: ...
    @property
    def net(self) -> Form: ...
    @property
    def pieces(self) -> list[Form]: ...
    @property
    def breaks(self) -> tuple[_Array, ...]: ...
    @property
    def degrees(self) -> tuple[int, ...]: ...
    @property
    def counts(self) -> tuple[int, ...]: ...
    @property
    def axes(self) -> int: ...
    @property
    def ambient(self) -> int: ...
    @overload
    def __call__(self, inner: Form | Spline, /) -> Spline: ...
    @overload
    def __call__(self, *parameters: ArrayLike) -> _Array: ...
    def evaluate(
        self,
        *parameters: ArrayLike,
        derivative: _WholePerAxis | None = None,
        out: _Array | None = None,
    ) -> _Array: ...
    @overload
    def grid(
        self,
        *parameters: int | ArrayLike,
        normals: Literal[False] = False,
        out: _Array | None = None,
    ) -> _Array: ...
    @overload
    def grid(
        self,
        *parameters: int | ArrayLike,
        normals: Literal[True],
        out: tuple[_Array, _Array] | None = None,
    ) -> tuple[_Array, _Array]: ...
    def normals(self, u: ArrayLike, v: ArrayLike, *, out: _Array | None = None) -> _Array: ...
    def frame(
        self,
        *parameters: ArrayLike,
        kind: Literal["frenet", "rotation-minimising", "tangent"] = "frenet",
        unit: bool = True,
        accuracy: float = 1e-10,
    ) -> Frame: ...
    @overload
    def curvature(self, u: ArrayLike, /) -> _Array: ...
    @overload
    def curvature(self, u: ArrayLike, v: ArrayLike, /) -> Frame: ...
    def geodesic(
        self,
        start: ArrayLike,
        direction: ArrayLike,
        length: ArrayLike,
        *,
        accuracy: _Number = 1e-10,
        seams: bool = True,
    ) -> Geodesic | Geodesics: ...
    def planks(
        self,
        lines: Geodesic | Connection | Form | Spline | ArrayLike | Sequence[Any],
        width: _Number,
        *,
        accuracy: _Number = 1e-8,
        marks: bool = True,
    ) -> Plank | list[Plank]: ...
    def deform(
        self, cage: Form | Spline, *, rest: Form | Spline | ArrayLike | None = None
    ) -> Spline: ...
    def invert(self, points: ArrayLike, *, accuracy: float = 1e-12) -> Inversion: ...
    @overload
    def project(
        self, points: ArrayLike, *, accuracy: float = 1e-12, all: Literal[False] = False
    ) -> Projection: ...
    @overload
    def project(
        self, points: ArrayLike, *, accuracy: float = 1e-12, all: Literal[True]
    ) -> Feet: ...
    def intersect(
        self, other: Form | Spline | ArrayLike, *, accuracy: float = 1e-14
    ) -> Intersection: ...
    def piece(self, *index: int) -> Form: ...
    def bezier(self) -> Spline: ...
    def remove_knot(self, axis: int, t: _Number) -> tuple[Spline, float]: ...
    def elevate(self, by: _WholePerAxis) -> Spline: ...
    def subdivide(self, r: _WholePerAxis) -> Spline: ...
    def split(self, axis: int, t: _Number) -> tuple[Spline, Spline]: ...
    def restrict(self, axis: int, a: _Number, b: _Number) -> Spline: ...
    def stretch(self, a: _PerAxis, b: _PerAxis) -> Spline: ...
    def on_window(self, axis: int, a: _Number, b: _Number) -> Spline: ...
    def reverse(self, axis: int) -> Spline: ...
    def transpose(self, axes: Sequence[int] | None = None) -> Spline: ...
    def sub(self, axis: int, t: _Number) -> Spline | Form: ...
    def derivative(self, orders: _WholePerAxis) -> Spline: ...
    def hodograph(self, axis: int = 0) -> Spline: ...
    def diagonal(self, axes: Sequence[int] | Literal["all"] | None = None) -> Spline: ...
    def tangent_form(self, axis: int = 0) -> Spline: ...
    def normal_form(self) -> Spline: ...
    def binormal_form(self) -> Spline: ...
    def with_pole(
        self, index: _WholePerAxis, point: ArrayLike | Form, *, weight: float | None = None
    ) -> Spline: ...
    def save(self, path: str | PathLike[str]) -> None: ...
    def __iter__(self) -> Iterator[Form]: ...
    def __len__(self) -> int: ...
    def symmetric(self, form: Form | Spline, *, pointwise: bool = False) -> Spline: ...
    def extrude(self, path: Form | Spline | ArrayLike) -> Spline: ...
    def ruled(self, second: Form | Spline | ArrayLike) -> Spline: ...
    def transform(self, matrix: ArrayLike) -> Spline: ...
    def translate(self, by: _Vector) -> Spline: ...
    def rotate(
        self,
        angle: _Number | Sequence[_Number] | _Array,
        axis: _Vector | None = None,
        *,
        centre: _Vector | None = None,
        plane: Sequence[int] | None = None,
        unit: _Unit = "radians",
    ) -> Spline: ...
    def scale(self, factors: _PerAxis | Form, *, centre: _Vector | None = None) -> Spline: ...
    def shear(self, coordinate: int, by: _Vector, *, centre: _Vector | None = None) -> Spline: ...
    def mirror(self, normal: _Vector, *, origin: _Vector | None = None) -> Spline: ...
    def project_to_plane(
        self,
        normal: _Vector,
        *,
        origin: _Vector | None = None,
        direction: _Vector | None = None,
        lamp: _Vector | None = None,
    ) -> Spline: ...
    def insert_knots(self, knots: _PerAxis, *, axis: int = 0) -> Spline: ...
    @overload
    def remove_knots(
        self,
        knots: _PerAxis | None = None,
        *,
        axis: int = 0,
        accuracy: float = 1e-12,
        report: Literal[False] = False,
    ) -> Spline: ...
    @overload
    def remove_knots(
        self,
        knots: _PerAxis | None = None,
        *,
        axis: int = 0,
        accuracy: float = 1e-12,
        report: Literal[True],
    ) -> Simplified: ...
    @overload
    def continuity(
        self,
        g: None = None,
        *,
        at: _Ends | None = None,
        order: int = 2,
        accuracy: float = 1e-9,
        axis: int = 0,
    ) -> list[tuple[float, Continuity]]: ...
    @overload
    def continuity(
        self,
        g: _Shape,
        *,
        at: _Ends | None = None,
        order: int = 2,
        accuracy: float = 1e-9,
        axis: int = 0,
    ) -> Continuity: ...
    @overload
    def arc_length(
        self,
        a: _Number | None = None,
        b: _Number | None = None,
        *,
        accuracy: float = 1e-12,
        report: Literal[False] = False,
    ) -> float: ...
    @overload
    def arc_length(
        self,
        a: _Number | None = None,
        b: _Number | None = None,
        *,
        accuracy: float = 1e-12,
        report: Literal[True],
    ) -> Length: ...
    @overload
    def parameter_at_length(self, length: _Number, *, accuracy: float = 1e-12) -> float: ...
    @overload
    def parameter_at_length(self, length: ArrayLike, *, accuracy: float = 1e-12) -> _Array: ...
    @overload
    def by_arc_length(
        self, *, accuracy: float = 1e-9, report: Literal[False] = False
    ) -> Spline: ...
    @overload
    def by_arc_length(self, *, accuracy: float = 1e-9, report: Literal[True]) -> UnitSpeed: ...
    @overload
    def area(
        self,
        *,
        signed: bool = False,
        accuracy: float = 1e-12,
        report: Literal[False] = False,
    ) -> float: ...
    @overload
    def area(
        self, *, signed: bool = False, accuracy: float = 1e-12, report: Literal[True]
    ) -> Measure: ...
    @overload
    def volume(
        self,
        *,
        signed: bool = False,
        accuracy: float = 1e-12,
        report: Literal[False] = False,
    ) -> float: ...
    @overload
    def volume(
        self, *, signed: bool = False, accuracy: float = 1e-12, report: Literal[True]
    ) -> Measure: ...
    def centroid(self, *, filled: bool = False, accuracy: float = 1e-12) -> _Array: ...
    def inertia(self, *, filled: bool = False, accuracy: float = 1e-12) -> Inertia: ...
    def box(self, *, accuracy: float = 1e-12) -> Box: ...
    def jacobian(self) -> Spline: ...
    @overload
    def is_injective(
        self, *, accuracy: float = 1e-9, report: Literal[False] = False
    ) -> bool | None: ...
    @overload
    def is_injective(self, *, accuracy: float = 1e-9, report: Literal[True]) -> Folds: ...
    @overload
    def slice(self, axis: int, t: _Number) -> Form | Spline: ...
    @overload
    def slice(self, axis: int, t: Sequence[_Number]) -> list[Form | Spline]: ...
    def __add__(self, other: Form | Spline, /) -> Spline: ...
    def __radd__(self, other: Form | Spline, /) -> Spline: ...
    def __sub__(self, other: Form | Spline, /) -> Spline: ...
    def __rsub__(self, other: Form | Spline, /) -> Spline: ...
    def __mul__(self, factor: _Number, /) -> Spline: ...
    def __rmul__(self, factor: _Number, /) -> Spline: ...
    def __truediv__(self, divisor: _Number, /) -> Spline: ...
    def __rtruediv__(self, other: Form, /) -> Spline: ...
    def __neg__(self) -> Spline: ...
    def __pos__(self) -> Spline: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __copy__(self) -> Spline: ...
    def __deepcopy__(self, _memo: object) -> Spline: ...
    def __reduce__(self) -> tuple[Any, ...]: ...
    def revolve(
        self,
        angle: _Number | None = None,
        *,
        axis: _PerAxis | Form = ...,
        through: _PerAxis | Form = ...,
        order: Literal[3, 4, 5] = 3,
    ) -> Spline: ...
    def cross(self, section: Form | Spline | ArrayLike) -> Spline: ...
    @overload
    def parallel(
        self,
        distance: _Number | Form,
        *,
        tolerance: _Number = 1e-06,
        side: ArrayLike | Literal["principal"] | None = None,
        folds: bool = False,
        report: Literal[False] = False,
    ) -> Spline: ...
    @overload
    def parallel(
        self,
        distance: _Number | Form,
        *,
        tolerance: _Number = 1e-06,
        side: ArrayLike | Literal["principal"] | None = None,
        folds: bool = False,
        report: Literal[True],
    ) -> Parallel: ...
    @overload
    def shell(
        self,
        distance: _Number | Form,
        *,
        tolerance: _Number = 1e-06,
        side: ArrayLike | Literal["principal"] | None = None,
        folds: bool = False,
        report: Literal[False] = False,
    ) -> Spline: ...
    @overload
    def shell(
        self,
        distance: _Number | Form,
        *,
        tolerance: _Number = 1e-06,
        side: ArrayLike | Literal["principal"] | None = None,
        folds: bool = False,
        report: Literal[True],
    ) -> Parallel: ...
    def offset_poles(
        self, distance: _Number | Form, *, side: ArrayLike | Literal["principal"] | None = None
    ) -> Spline: ...
    def tangent_developable(self, length: _Number = 1.0) -> Spline: ...
    @overload
    def is_developable(self, *, report: Literal[False] = False) -> bool: ...
    @overload
    def is_developable(self, *, report: Literal[True]) -> Developability: ...
    @overload
    def unroll(self, *, accuracy: _Number = 1e-12, report: Literal[False] = False) -> Spline: ...
    @overload
    def unroll(self, *, accuracy: _Number = 1e-12, report: Literal[True]) -> Unrolling: ...

@final
class Embedding:
    @property
    def parameters(self) -> _Array: ...
    @property
    def points(self) -> _Array: ...
    @property
    def inside(self) -> NDArray[np.bool_]: ...
    @property
    def extended(self) -> NDArray[np.bool_]: ...
    @property
    def residual(self) -> _Array: ...
    @property
    def counts(self) -> NDArray[np.int64]: ...
    @property
    def complete(self) -> NDArray[np.bool_]: ...
    def at(self, cage: Form | Spline | ArrayLike, *, out: _Array | None = None) -> _Array: ...
    def sensitivities(self, cage: Form | Spline | ArrayLike) -> Sparse: ...
    def jacobians(self, cage: Form | Spline | ArrayLike) -> _Array: ...
    def __len__(self) -> int: ...

@final
class Immersed:
    __hash__ = None  # type: ignore[assignment]
    def __new__(cls, inner: Form, host: Form) -> Immersed: ...
    @property
    def host(self) -> Form: ...
    @property
    def inner(self) -> Form: ...
    @property
    def kind(self) -> str: ...
    @property
    def axes(self) -> int: ...
    @property
    def ambient(self) -> int: ...
    def forecast(self) -> dict[str, Any]: ...
    def expand(self) -> Form: ...
    def __call__(self, *parameters: ArrayLike) -> _Array: ...
    def evaluate(
        self,
        *parameters: ArrayLike,
        derivative: _WholePerAxis | None = None,
        out: _Array | None = None,
    ) -> _Array: ...
    def transform(self, matrix: ArrayLike) -> Immersed: ...
    def translate(self, by: _Vector) -> Immersed: ...
    def rotate(
        self,
        angle: _Number | Sequence[_Number] | _Array,
        axis: _Vector | None = None,
        *,
        centre: _Vector | None = None,
        plane: Sequence[int] | None = None,
        unit: _Unit = "radians",
    ) -> Immersed: ...
    def scale(self, factors: _PerAxis | Form, *, centre: _Vector | None = None) -> Immersed: ...
    def shear(self, coordinate: int, by: _Vector, *, centre: _Vector | None = None) -> Immersed: ...
    def mirror(self, normal: _Vector, *, origin: _Vector | None = None) -> Immersed: ...
    def project_to_plane(
        self,
        normal: _Vector,
        *,
        origin: _Vector | None = None,
        direction: _Vector | None = None,
        lamp: _Vector | None = None,
    ) -> Immersed: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class Sheet:
    def __new__(cls, text: str = "", *, exact: bool = False) -> Sheet: ...
    @classmethod
    def load(cls, path: str | PathLike[str], *, exact: bool = False) -> Sheet: ...
    def save(self, path: str | PathLike[str]) -> None: ...
    @property
    def exact(self) -> bool: ...
    def cells(self) -> dict[str, str]: ...
    @property
    def names(self) -> dict[str, str]: ...
    def set_name(self, name: str, target: str) -> None: ...
    def errors(self) -> dict[str, str]: ...
    def sensitivities(self, result: str, source: str) -> Sparse: ...
    def gradient(self, result: str, source: str, weights: ArrayLike | None = None) -> _Array: ...
    def undo(self) -> bool: ...
    def redo(self) -> bool: ...
    # Whatever the cell holds: a number, a text, a form, a list, a dict, None.
    def __getitem__(self, place: str, /) -> Any: ...
    def __setitem__(self, place: str, value: str | _Number | Form | None, /) -> None: ...
    def __delitem__(self, place: str, /) -> None: ...
    def __contains__(self, place: object, /) -> bool: ...
    def __iter__(self) -> Iterator[str]: ...
    def __len__(self) -> int: ...
    def __reduce__(self) -> tuple[Any, ...]: ...
    def _draw(self, look: object) -> list[bytes]: ...
    @staticmethod
    def _restore(text: str, exact: bool) -> Sheet: ...

def cap() -> int: ...
def set_cap(bytes: int) -> None: ...
def _draw_forms(forms: object, look: object) -> list[bytes]: ...
def _read_forms(name: str, bytes: bytes) -> list[tuple[str | None, Form | Spline]]: ...
def _write_forms(name: str, forms: object) -> bytes: ...
def threads() -> int: ...
def set_threads(count: int | None) -> None: ...
@overload
def grid(
    forms: Form | Spline | Iterable[Form],
    /,
    *parameters: int | ArrayLike,
    normals: Literal[False] = False,
    out: _Array | None = None,
) -> _Array: ...
@overload
def grid(
    forms: Form | Spline | Iterable[Form],
    /,
    *parameters: int | ArrayLike,
    normals: Literal[True],
    out: tuple[_Array, _Array] | None = None,
) -> tuple[_Array, _Array]: ...
def thirds(*forms: _Shape | Sequence[_Shape]) -> list[Form | Spline]: ...
def iterate(
    form: Form | ArrayLike,
    generation: int,
    rule: Literal["cantor", "sponge", "sierpinski"] = "cantor",
    *,
    ratio: _Number = 0.5,
) -> list[Form]: ...
def peano(generation: int, axes: int = 2) -> Spline: ...
def random_points(
    form: _Shape,
    count: int,
    *,
    law: Literal["uniform", "gaussian"] = "uniform",
    seed: int = 0,
) -> _Array: ...

_Solid: TypeAlias = Form | Spline | Mesh | Sequence[Any]

@overload
def union(*solids: _Solid, accuracy: _Number = 1e-3, report: Literal[False] = False) -> Mesh: ...
@overload
def union(*solids: _Solid, accuracy: _Number = 1e-3, report: Literal[True]) -> Solid: ...
@overload
def difference(
    *solids: _Solid, accuracy: _Number = 1e-3, report: Literal[False] = False
) -> Mesh: ...
@overload
def difference(*solids: _Solid, accuracy: _Number = 1e-3, report: Literal[True]) -> Solid: ...
@overload
def common(*solids: _Solid, accuracy: _Number = 1e-3, report: Literal[False] = False) -> Mesh: ...
@overload
def common(*solids: _Solid, accuracy: _Number = 1e-3, report: Literal[True]) -> Solid: ...
def _make_mesh(vertices: ArrayLike, triangles: ArrayLike) -> Mesh: ...
def _mesh_area(mesh: Mesh) -> float: ...
def _mesh_volume(mesh: Mesh) -> float: ...
def _mesh_is_closed(mesh: Mesh) -> bool: ...

# Of a curve a Polyline: what a form is, its type does not tell.
@overload
def tessellate(  # type: ignore[overload-overlap]
    forms: Form | Spline,
    *,
    tolerance: _Number | None = None,
    segments: _WholePerAxis | None = None,
    fineness: _WholePerAxis | None = None,
    normals: bool = True,
    joined: Literal[False] = False,
) -> Mesh | Any: ...
@overload
def tessellate(
    forms: Iterable[Form | Spline],
    *,
    tolerance: _Number | None = None,
    segments: _WholePerAxis | None = None,
    fineness: _WholePerAxis | None = None,
    normals: bool = True,
    joined: Literal[False] = False,
) -> list[Mesh | Any]: ...
@overload
def tessellate(
    forms: Form | Spline | Iterable[Form | Spline],
    *,
    tolerance: _Number | None = None,
    segments: _WholePerAxis | None = None,
    fineness: _WholePerAxis | None = None,
    normals: bool = True,
    joined: Literal[True],
) -> Mesh: ...
@overload
def midpoint(  # type: ignore[overload-overlap]
    *forms: Spline,
) -> Spline: ...
@overload
def midpoint(*forms: Form | Iterable[Form]) -> Form: ...
@overload
def midpoint(*forms: Form | Spline | Iterable[Form | Spline]) -> Form | Spline: ...
@overload
def stack(  # type: ignore[overload-overlap]
    *forms: Spline,
) -> Spline: ...
@overload
def stack(*forms: Form | Iterable[Form]) -> Form: ...
@overload
def stack(*forms: Form | Spline | Iterable[Form | Spline]) -> Form | Spline: ...
@overload
def combine(  # type: ignore[overload-overlap]
    k: Sequence[_Number] | _Array, *forms: Spline, pointwise: bool = False
) -> Spline: ...
@overload
def combine(
    k: Sequence[_Number] | _Array, *forms: Form | Iterable[Form], pointwise: bool = False
) -> Form: ...
@overload
def combine(
    k: Sequence[_Number] | _Array,
    *forms: Form | Spline | Iterable[Form | Spline],
    pointwise: bool = False,
) -> Form | Spline: ...
@overload
def affine_sweep(matrix: Spline, section: ArrayLike | Form | Spline) -> Spline: ...
@overload
def affine_sweep(matrix: ArrayLike | Form, section: Spline) -> Spline: ...
@overload
def affine_sweep(matrix: ArrayLike | Form, section: ArrayLike | Form) -> Form: ...
def affine_matrix(*columns: Form | Iterable[Form]) -> Form: ...
@overload
def coons(
    *faces: ArrayLike | Form | Sequence[Form | ArrayLike],
    accuracy: float = 1e-9,
    pointwise: bool = False,
) -> Form: ...
@overload
def coons(
    *faces: ArrayLike | Form | Spline | Sequence[Form | Spline | ArrayLike],
    accuracy: float = 1e-9,
    pointwise: bool = False,
) -> Form | Spline: ...
@overload
def pipe(
    path: ArrayLike | Form | Spline,
    section: ArrayLike | Form | Spline,
    *,
    radius: ArrayLike | Form | Spline = 1,
    twist: ArrayLike | Form | Spline = 0,
    frame: Literal["rotation-minimising", "frenet"] = "rotation-minimising",
    tolerance: _Number | None = None,
    closed: bool | None = None,
    report: Literal[False] = False,
) -> Spline: ...
@overload
def pipe(
    path: ArrayLike | Form | Spline,
    section: ArrayLike | Form | Spline,
    *,
    radius: ArrayLike | Form | Spline = 1,
    twist: ArrayLike | Form | Spline = 0,
    frame: Literal["rotation-minimising", "frenet"] = "rotation-minimising",
    tolerance: _Number | None = None,
    closed: bool | None = None,
    report: Literal[True],
) -> Pipe: ...
@overload
def waving_pipe(
    path: ArrayLike | Form | Spline,
    section: ArrayLike | Form | Spline,
    amplitude: _Number,
    periods: _Number,
    *,
    radius: _Number = 1,
    frame: Literal["rotation-minimising", "frenet"] = "rotation-minimising",
    tolerance: _Number | None = None,
    report: Literal[False] = False,
) -> Spline: ...
@overload
def waving_pipe(
    path: ArrayLike | Form | Spline,
    section: ArrayLike | Form | Spline,
    amplitude: _Number,
    periods: _Number,
    *,
    radius: _Number = 1,
    frame: Literal["rotation-minimising", "frenet"] = "rotation-minimising",
    tolerance: _Number | None = None,
    report: Literal[True],
) -> Pipe: ...
@overload
def gordon(
    us: Iterable[Form | Spline | ArrayLike],
    vs: Iterable[Form | Spline | ArrayLike],
    u: Sequence[_Number] | _Array | None = None,
    v: Sequence[_Number] | _Array | None = None,
    *,
    accuracy: float = 1e-6,
    report: Literal[False] = False,
) -> Form | Spline: ...
@overload
def gordon(
    us: Iterable[Form | Spline | ArrayLike],
    vs: Iterable[Form | Spline | ArrayLike],
    u: Sequence[_Number] | _Array | None = None,
    v: Sequence[_Number] | _Array | None = None,
    *,
    accuracy: float = 1e-6,
    report: Literal[True],
) -> Network: ...
@overload
def minimal(
    *boundary: Form | ArrayLike,
    kind: Literal["dirichlet", "harmonic", "laplace", "area"] = "dirichlet",
    orders: _WholePerAxis | None = None,
    sides: _PerAxis | None = None,
    keep: Iterable[Sequence[int]] | None = None,
    accuracy: float = 1e-9,
    report: Literal[False] = False,
) -> Form: ...
@overload
def minimal(
    *boundary: Form | Spline | ArrayLike | Sequence[Form | Spline | ArrayLike],
    kind: Literal["dirichlet", "harmonic", "laplace", "area"] = "dirichlet",
    orders: _WholePerAxis | None = None,
    sides: _PerAxis | None = None,
    keep: Iterable[Sequence[int]] | None = None,
    accuracy: float = 1e-9,
    report: Literal[False] = False,
) -> Form | Spline: ...
@overload
def minimal(
    *boundary: Form | Spline | ArrayLike | Sequence[Form | Spline | ArrayLike],
    kind: Literal["dirichlet", "harmonic", "laplace", "area"] = "dirichlet",
    orders: _WholePerAxis | None = None,
    sides: _PerAxis | None = None,
    keep: Iterable[Sequence[int]] | None = None,
    accuracy: float = 1e-9,
    report: Literal[True],
) -> Minimal: ...
def ratios(form: Form | Spline | ArrayLike, axis: int = 0) -> Ratios: ...
@overload
def golden(a: Form | ArrayLike, b: Form | ArrayLike) -> Form: ...
@overload
def golden(a: Form | Spline | ArrayLike, b: Form | Spline | ArrayLike) -> Form | Spline: ...
def partition(a: _Number, b: _Number, r: int) -> _Array: ...
def bernstein(n: int, i: int, t: ArrayLike) -> _Array: ...
def pascal(n: int) -> list[int]: ...
def explain(operator: str, *kinds: str | _Number) -> str: ...
@overload
def immerse(inner: Form, host: Form, lazy: Literal[False] = False) -> Form: ...
@overload
def immerse(inner: Spline, host: Form | Spline, lazy: Literal[False] = False) -> Spline: ...
@overload
def immerse(inner: Form, host: Spline, lazy: Literal[False] = False) -> Spline: ...
@overload
def immerse(inner: Form, host: Form, lazy: Literal[True]) -> Immersed: ...
@overload
def immerse(inner: Sequence[Form], host: Form, lazy: Literal[False] = False) -> list[Form]: ...
@overload
def immerse(inner: Sequence[Form], host: Form, lazy: Literal[True]) -> list[Immersed]: ...
def forecast(inner: str | Form, host: str | Form, ambient: int = 3) -> dict[str, Any]: ...
def immerse_points(map: Callable[..., ArrayLike], form: Form) -> Form: ...
@overload
def segment(host: Form, a: _PerAxis | Form, b: _PerAxis | Form) -> Form: ...
@overload
def segment(host: Spline, a: _PerAxis | Form, b: _PerAxis | Form) -> Spline: ...
def polyline(host: Form, points: ArrayLike) -> list[Form]: ...
@overload
def tile(cells: Form | Iterable[Form], cage: Form, counts: _WholePerAxis) -> list[Form]: ...
@overload
def tile(
    cells: Form | Spline | Iterable[Form | Spline], cage: Form | Spline, counts: _WholePerAxis
) -> list[Form | Spline]: ...
def interpolate(
    net: ArrayLike | Form,
    nodes: Literal["uniform", "chebyshev", "lobatto"] | _ListPerAxis = "uniform",
    homogeneous: bool = False,
) -> Form: ...
@overload
def fit(
    points: ArrayLike,
    orders: _WholePerAxis,
    params: Literal["chord", "centripetal", "uniform"] | _ListPerAxis = "chord",
    *,
    weights: ArrayLike | None = None,
    ends: bool = False,
    report: Literal[False] = False,
) -> Form: ...
@overload
def fit(
    points: ArrayLike,
    orders: _WholePerAxis,
    params: Literal["chord", "centripetal", "uniform"] | _ListPerAxis = "chord",
    *,
    weights: ArrayLike | None = None,
    ends: bool = False,
    report: Literal[True],
) -> Fit: ...
@overload
def transform(form: _Movable, matrix: ArrayLike) -> _Movable: ...
@overload
def transform(form: Sequence[_Movable], matrix: ArrayLike) -> list[_Movable]: ...
@overload
def translate(form: _Movable, by: _Vector) -> _Movable: ...
@overload
def translate(form: Sequence[_Movable], by: _Vector) -> list[_Movable]: ...
@overload
def rotate(
    form: _Movable,
    angle: _Number | Sequence[_Number] | _Array,
    axis: _Vector | None = None,
    *,
    centre: _Vector | None = None,
    plane: Sequence[int] | None = None,
    unit: _Unit = "radians",
) -> _Movable: ...
@overload
def rotate(
    form: Sequence[_Movable],
    angle: _Number | Sequence[_Number] | _Array,
    axis: _Vector | None = None,
    *,
    centre: _Vector | None = None,
    plane: Sequence[int] | None = None,
    unit: _Unit = "radians",
) -> list[_Movable]: ...
@overload
def scale(
    form: _Movable, factors: _PerAxis | Form, *, centre: _Vector | None = None
) -> _Movable: ...
@overload
def scale(
    form: Sequence[_Movable], factors: _PerAxis | Form, *, centre: _Vector | None = None
) -> list[_Movable]: ...
@overload
def shear(
    form: _Movable, coordinate: int, by: _Vector, *, centre: _Vector | None = None
) -> _Movable: ...
@overload
def shear(
    form: Sequence[_Movable], coordinate: int, by: _Vector, *, centre: _Vector | None = None
) -> list[_Movable]: ...
@overload
def mirror(form: _Movable, normal: _Vector, *, origin: _Vector | None = None) -> _Movable: ...
@overload
def mirror(
    form: Sequence[_Movable], normal: _Vector, *, origin: _Vector | None = None
) -> list[_Movable]: ...
@overload
def project_to_plane(
    form: _Movable,
    normal: _Vector,
    *,
    origin: _Vector | None = None,
    direction: _Vector | None = None,
    lamp: _Vector | None = None,
) -> _Movable: ...
@overload
def project_to_plane(
    form: Sequence[_Movable],
    normal: _Vector,
    *,
    origin: _Vector | None = None,
    direction: _Vector | None = None,
    lamp: _Vector | None = None,
) -> list[_Movable]: ...
def conic(
    p0: Form | ArrayLike, p1: Form | ArrayLike, p2: Form | ArrayLike, w: _Number = 1.0
) -> Form: ...
def classify(curve: Form | ArrayLike, *, accuracy: _Number = 1e-12) -> _Conic: ...
def arc(
    radius: _Number, angle: _Number, order: Literal[3, 4, 5] = 3, *, start: _Number = 0.0
) -> Form | Spline: ...
@overload
def circle(radius: _Number, *, part: Literal["whole"] = "whole") -> Form: ...
@overload
def circle(radius: _Number, *, part: Literal["pieces"]) -> Spline: ...
@overload
def ellipse(a: _Number, b: _Number, *, part: Literal["whole"] = "whole") -> Form: ...
@overload
def ellipse(a: _Number, b: _Number, *, part: Literal["pieces"]) -> Spline: ...
def embed(
    points: ArrayLike,
    cage: Form | Spline | ArrayLike,
    *,
    accuracy: float = 1e-12,
    outside: Literal["keep", "extend", "error"] = "keep",
) -> Embedding: ...
def deform(
    object: Any,
    cage: Form | Spline | ArrayLike,
    *,
    rest: Form | Spline | ArrayLike | None = None,
    accuracy: float = 1e-12,
    outside: Literal["keep", "extend", "error"] = "keep",
) -> Any: ...
def hyperbola(a: _Number, b: _Number, height: _Number) -> Form: ...
def parabola(focal: _Number, height: _Number) -> Form: ...
@overload
def cylinder(
    radius: _Number, height: _Number, *, part: Literal["whole", "quarter"] = "whole"
) -> Form: ...
@overload
def cylinder(radius: _Number, height: _Number, *, part: Literal["pieces"]) -> Spline: ...
@overload
def cone(
    radius: _Number,
    height: _Number,
    *,
    top: _Number = 0.0,
    part: Literal["whole", "quarter"] = "whole",
) -> Form: ...
@overload
def cone(
    radius: _Number, height: _Number, *, top: _Number = 0.0, part: Literal["pieces"]
) -> Spline: ...
@overload
def sphere(
    radius: _Number, *, part: Literal["whole", "half", "quarter", "octant"] = "whole"
) -> Form: ...
@overload
def sphere(radius: _Number, *, part: Literal["pieces"]) -> Spline: ...
@overload
def torus(
    major: _Number, minor: _Number, *, part: Literal["whole", "quarter", "outer", "inner"] = "whole"
) -> Form: ...
@overload
def torus(major: _Number, minor: _Number, *, part: Literal["pieces"]) -> Spline: ...
@overload
def viviani(radius: _Number, *, part: Literal["octant"] = "octant") -> Form: ...
@overload
def viviani(radius: _Number, *, part: Literal["whole"]) -> Spline: ...
def torus_knot(p: int, q: int, major: _Number, minor: _Number) -> Spline: ...
def bezier_cylinder(radius: _Number, height: _Number) -> Bicubic: ...
def bezier_cone(radius: _Number, height: _Number) -> Bicubic: ...
def bezier_sphere(radius: _Number) -> Bicubic: ...
def bezier_torus(
    major: _Number, minor: _Number, *, side: Literal["outer", "inner"] = "outer"
) -> Bicubic: ...
def revolve(
    profile: Form | Spline | ArrayLike,
    angle: _Number | None = None,
    *,
    axis: _PerAxis | Form = ...,
    through: _PerAxis | Form = ...,
    order: Literal[3, 4, 5] = 3,
) -> Form | Spline: ...
def cross(
    profile: Form | Spline | ArrayLike, section: Form | Spline | ArrayLike
) -> Form | Spline: ...
@overload
def parallel(
    form: Form | Spline | ArrayLike,
    distance: _Number | Form,
    *,
    tolerance: _Number = 1e-06,
    side: ArrayLike | Literal["principal"] | None = None,
    folds: bool = False,
    report: Literal[False] = False,
) -> Spline: ...
@overload
def parallel(
    form: Form | Spline | ArrayLike,
    distance: _Number | Form,
    *,
    tolerance: _Number = 1e-06,
    side: ArrayLike | Literal["principal"] | None = None,
    folds: bool = False,
    report: Literal[True],
) -> Parallel: ...
@overload
def shell(
    form: Form | Spline | ArrayLike,
    distance: _Number | Form,
    *,
    tolerance: _Number = 1e-06,
    side: ArrayLike | Literal["principal"] | None = None,
    folds: bool = False,
    report: Literal[False] = False,
) -> Spline: ...
@overload
def shell(
    form: Form | Spline | ArrayLike,
    distance: _Number | Form,
    *,
    tolerance: _Number = 1e-06,
    side: ArrayLike | Literal["principal"] | None = None,
    folds: bool = False,
    report: Literal[True],
) -> Parallel: ...
@overload
def offset_poles(
    form: Spline,
    distance: _Number | Form,
    *,
    side: ArrayLike | Literal["principal"] | None = None,
) -> Spline: ...
@overload
def offset_poles(
    form: Form | ArrayLike,
    distance: _Number | Form,
    *,
    side: ArrayLike | Literal["principal"] | None = None,
) -> Form: ...
@overload
def tangent_developable(curve: Spline, length: _Number = 1.0) -> Spline: ...
@overload
def tangent_developable(curve: Form | ArrayLike, length: _Number = 1.0) -> Form: ...
@overload
def is_developable(form: Form | Spline | ArrayLike, *, report: Literal[False] = False) -> bool: ...
@overload
def is_developable(form: Form | Spline | ArrayLike, *, report: Literal[True]) -> Developability: ...
def planks(
    surface: Form | Spline | ArrayLike,
    lines: Geodesic | Connection | Form | Spline | ArrayLike | Sequence[Any],
    width: _Number,
    *,
    accuracy: _Number = 1e-8,
    marks: bool = True,
) -> Plank | list[Plank]: ...
def geodesic_between(
    surface: Form | Spline | ArrayLike,
    p: ArrayLike,
    q: ArrayLike,
    *,
    longest: _Number | None = None,
    all: bool = False,
    accuracy: _Number = 1e-10,
    seams: bool = True,
) -> Connection | list[Connection]: ...
def geodesic(
    surface: Form | Spline | ArrayLike,
    start: ArrayLike,
    direction: ArrayLike,
    length: ArrayLike,
    *,
    accuracy: _Number = 1e-10,
    seams: bool = True,
) -> Geodesic | Geodesics: ...
@overload
def unroll(
    form: Form | Spline | ArrayLike, *, accuracy: _Number = 1e-12, report: Literal[False] = False
) -> Spline: ...
@overload
def unroll(
    form: Form | Spline | ArrayLike, *, accuracy: _Number = 1e-12, report: Literal[True]
) -> Unrolling: ...
def bspline(
    points: _Shape,
    degree: _WholePerAxis = 3,
    knots: _KnotRule | Sequence[_KnotRule] = "uniform",
    *,
    closed: bool | Sequence[bool] = False,
) -> Spline: ...
def nurbs(poles: Form | ArrayLike, weights: ArrayLike | None, knots: _ListPerAxis) -> Spline: ...
def concatenate(
    forms: Iterable[Form], *, axis: int = 0, breaks: Sequence[_Number] | _Array | None = None
) -> Spline: ...
def interpolating_spline(
    points: _Shape,
    degree: Literal[2, 3] = 3,
    *,
    start: Form | ArrayLike | None = None,
    ends: _EndRule | Sequence[_EndRule] = "natural",
    params: Literal["chord", "centripetal", "uniform"] | _ListPerAxis = "chord",
    tangents: ArrayLike | None = None,
    circle: bool = False,
) -> Spline: ...
def intersect(
    first: Form | Spline | ArrayLike,
    second: Form | Spline | ArrayLike,
    *,
    accuracy: float = 1e-14,
    host: Form | Spline | ArrayLike | None = None,
) -> Intersection: ...
def intersect_many(
    first: Form | Sequence[Form] | ArrayLike,
    second: Form | Sequence[Form] | ArrayLike,
    *,
    accuracy: float = 1e-14,
) -> Crossings: ...
def insert_knots(spline: _Shape, knots: _PerAxis, *, axis: int = 0) -> Spline: ...
@overload
def remove_knots(
    spline: _Shape,
    knots: _PerAxis | None = None,
    *,
    axis: int = 0,
    accuracy: float = 1e-12,
    report: Literal[False] = False,
) -> Spline: ...
@overload
def remove_knots(
    spline: _Shape,
    knots: _PerAxis | None = None,
    *,
    axis: int = 0,
    accuracy: float = 1e-12,
    report: Literal[True],
) -> Simplified: ...
@overload
def continuity(
    f: _Shape,
    g: None = None,
    *,
    at: _Ends | None = None,
    order: int = 2,
    accuracy: float = 1e-9,
    axis: int = 0,
) -> list[tuple[float, Continuity]]: ...
@overload
def continuity(
    f: _Shape,
    g: _Shape,
    *,
    at: _Ends | None = None,
    order: int = 2,
    accuracy: float = 1e-9,
    axis: int = 0,
) -> Continuity: ...
def join_forms(
    f: _Shape,
    g: _Shape,
    order: int = 1,
    *,
    kind: Literal["geometric", "parametric"] = "geometric",
    moving: Sequence[int] | None = None,
    at: _Ends | None = None,
) -> Joined: ...
@overload
def arc_length(
    curve: _Shape,
    a: _Number | None = None,
    b: _Number | None = None,
    *,
    accuracy: float = 1e-12,
    report: Literal[False] = False,
) -> float: ...
@overload
def arc_length(
    curve: _Shape,
    a: _Number | None = None,
    b: _Number | None = None,
    *,
    accuracy: float = 1e-12,
    report: Literal[True],
) -> Length: ...
@overload
def parameter_at_length(curve: _Shape, length: _Number, *, accuracy: float = 1e-12) -> float: ...
@overload
def parameter_at_length(curve: _Shape, length: ArrayLike, *, accuracy: float = 1e-12) -> _Array: ...
@overload
def by_arc_length(
    curve: _Shape, *, accuracy: float = 1e-9, report: Literal[False] = False
) -> Spline: ...
@overload
def by_arc_length(curve: _Shape, *, accuracy: float = 1e-9, report: Literal[True]) -> UnitSpeed: ...
@overload
def area(
    *forms: _Measured | Sequence[_Measured],
    signed: bool = False,
    accuracy: float = 1e-12,
    report: Literal[False] = False,
) -> float: ...
@overload
def area(
    *forms: _Measured | Sequence[_Measured],
    signed: bool = False,
    accuracy: float = 1e-12,
    report: Literal[True],
) -> Measure: ...
@overload
def volume(
    *forms: _Measured | Sequence[_Measured],
    signed: bool = False,
    accuracy: float = 1e-12,
    report: Literal[False] = False,
) -> float: ...
@overload
def volume(
    *forms: _Measured | Sequence[_Measured],
    signed: bool = False,
    accuracy: float = 1e-12,
    report: Literal[True],
) -> Measure: ...
def centroid(
    *forms: _Measured | Sequence[_Measured], filled: bool = False, accuracy: float = 1e-12
) -> _Array: ...
def inertia(
    *forms: _Measured | Sequence[_Measured], filled: bool = False, accuracy: float = 1e-12
) -> Inertia: ...
def box(*forms: _Measured | Sequence[_Measured], accuracy: float = 1e-12) -> Box: ...
@overload
def jacobian(form: Form | ArrayLike) -> Form: ...
@overload
def jacobian(form: Spline) -> Spline: ...
@overload
def is_injective(
    form: _Shape, *, accuracy: float = 1e-9, report: Literal[False] = False
) -> bool | None: ...
@overload
def is_injective(form: _Shape, *, accuracy: float = 1e-9, report: Literal[True]) -> Folds: ...
@overload
def slice(form: _Shape, axis: int, t: _Number) -> Form | Spline: ...
@overload
def slice(form: _Shape, axis: int, t: Sequence[_Number]) -> list[Form | Spline]: ...
@overload
def symmetric(middle: Form, form: Form, *, pointwise: bool = False) -> Form: ...
@overload
def symmetric(
    middle: Form | Spline, form: Form | Spline, *, pointwise: bool = False
) -> Form | Spline: ...
@overload
def extrude(form: Form | ArrayLike, path: Form | ArrayLike) -> Form: ...
@overload
def extrude(form: Form | Spline | ArrayLike, path: Form | Spline | ArrayLike) -> Form | Spline: ...
@overload
def ruled(first: Form | ArrayLike, second: Form | ArrayLike) -> Form: ...
@overload
def ruled(first: Form | Spline | ArrayLike, second: Form | Spline | ArrayLike) -> Form | Spline: ...
def line(order: int = 2, size: _Number = 1.0, *, ambient: int | None = None) -> Form: ...
def facet(
    orders: _WholePerAxis = 2, size: _PerAxis = 1.0, *, ambient: int | None = None
) -> Form: ...
def cube(
    orders: _WholePerAxis = 2, size: _PerAxis = 1.0, *, ambient: int | None = None
) -> Form: ...
