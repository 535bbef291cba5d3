"""Functions of the package that are methods of forms and of splines alike."""

from __future__ import annotations

from functools import wraps
from typing import (
    TYPE_CHECKING,
    Any,
    Concatenate,
    Literal,
    ParamSpec,
    Protocol,
    TypeVar,
    cast,
    overload,
)

from pforms._pforms import Form, Spline
from pforms.errors import ArgumentError

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import ArrayLike

    from pforms.records import Feet, Projection

_P = ParamSpec("_P")
_OfForm = TypeVar("_OfForm", covariant=True)
_OfSpline = TypeVar("_OfSpline", covariant=True)


class Either(Protocol[_P, _OfForm, _OfSpline]):
    """A function of a form or of a spline."""

    @overload
    def __call__(self, form: Form, /, *args: _P.args, **kwargs: _P.kwargs) -> _OfForm: ...
    @overload
    def __call__(self, form: Spline, /, *args: _P.args, **kwargs: _P.kwargs) -> _OfSpline: ...


class Projecting(Protocol):
    """The nearest points of a form or of a spline, or all feet."""

    @overload
    def __call__(
        self,
        form: Form | Spline,
        /,
        points: ArrayLike,
        *,
        accuracy: float = 1e-12,
        all: Literal[False] = False,
    ) -> Projection: ...
    @overload
    def __call__(
        self,
        form: Form | Spline,
        /,
        points: ArrayLike,
        *,
        accuracy: float = 1e-12,
        all: Literal[True],
    ) -> Feet: ...


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
        if isinstance(form, Form):
            return of_form(form, *args, **kwargs)
        if isinstance(form, Spline):
            return of_spline(form, *args, **kwargs)
        raise _mistyped(form, "a pforms.Form or a pforms.Spline")

    return _of_the_package(operator)


def projecting(of_form: Callable[..., Any], of_spline: Callable[..., Any]) -> Projecting:
    """The same, of methods whose answer depends on ``all``.

    >>> import pforms as pf
    >>> pf.project(pf.Form([(0, 0), (4, 0)]), (1, 3), all=True).kinds
    ('minimum',)
    """
    return cast("Projecting", either(of_form, of_spline))


def of_forms(
    method: Callable[Concatenate[Form, _P], _OfForm],
) -> Callable[Concatenate[Form, _P], _OfForm]:
    """A method of forms as a function that says what it is given.

    >>> import pforms as pf
    >>> pf.whole_line(3)
    Traceback (most recent call last):
    pforms.ArgumentError: form: received an int, expected a pforms.Form
    """

    @wraps(method)
    def operator(form: Any, /, *args: Any, **kwargs: Any) -> Any:  # noqa: ANN401
        if isinstance(form, Form):
            return method(form, *args, **kwargs)
        hint = ", such as one of its pieces" if isinstance(form, Spline) else ""
        raise _mistyped(form, "a pforms.Form" + hint)

    return _of_the_package(operator)


_Function = TypeVar("_Function")


def _of_the_package(operator: _Function) -> _Function:
    """The function under the name it is found by, so that other processes find it."""
    named: Any = operator
    named.__module__, named.__qualname__ = "pforms", named.__name__
    return operator


def _mistyped(received: object, expected: str) -> ArgumentError:
    name = type(received).__name__
    article = "an" if name[0] in "aeiou" else "a"
    return ArgumentError(f"form: received {article} {name}, expected {expected}")
