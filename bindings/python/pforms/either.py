"""Functions of the package that are methods of forms and of splines alike."""

from __future__ import annotations

from functools import wraps
from typing import TYPE_CHECKING, Any, Concatenate, ParamSpec, Protocol, TypeVar, overload

from pforms._pforms import Spline

if TYPE_CHECKING:
    from collections.abc import Callable

    from pforms._pforms import Form

_P = ParamSpec("_P")
_OfForm = TypeVar("_OfForm", covariant=True)
_OfSpline = TypeVar("_OfSpline", covariant=True)


class Either(Protocol[_P, _OfForm, _OfSpline]):
    """A function of a form or of a spline."""

    @overload
    def __call__(self, form: Form, /, *args: _P.args, **kwargs: _P.kwargs) -> _OfForm: ...
    @overload
    def __call__(self, form: Spline, /, *args: _P.args, **kwargs: _P.kwargs) -> _OfSpline: ...


def either(
    of_form: Callable[Concatenate[Form, _P], _OfForm],
    of_spline: Callable[Concatenate[Spline, _P], _OfSpline],
) -> Either[_P, _OfForm, _OfSpline]:
    """The method of forms as a function that takes splines too.

    >>> import pforms as pf
    >>> pf.elevate(pf.Form([(0, 0), (1, 2)]).subdivide(1), 1)
    <pforms.Spline of 2 pieces pL3 in 2D>
    """

    @wraps(of_form)
    def operator(form: Any, /, *args: Any, **kwargs: Any) -> Any:  # noqa: ANN401
        method: Any = of_spline if isinstance(form, Spline) else of_form
        return method(form, *args, **kwargs)

    return operator
