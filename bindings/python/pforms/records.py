"""What some questions are answered with."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from numpy import float64
    from numpy.typing import NDArray

    from pforms._pforms import Form


class Fit(NamedTuple):
    """A fitted form and how near it comes.

    >>> import pforms as pf
    >>> fit = pf.fit([(0, 0), (1, 2), (2, 4)], 2, params="uniform", report=True)
    >>> fit.form, fit.parameters[0].tolist()
    (<pforms.Form pL2 in 2D>, [0.0, 0.5, 1.0])
    """

    form: Form
    parameters: tuple[NDArray[float64], ...]
    """Those of the points, a list for each axis."""
    max_error: float
    """Largest distance between a point and the form at its parameters."""
    rms_error: float
    """Root of the mean square of these distances."""


class Frame(dict[str, "NDArray[float64]"]):
    """Named arrays, by key or as attributes; each has the shape of the parameters first.

    >>> import pforms as pf
    >>> frame = pf.Form([(0, 0), (1, 0), (2, 2)]).frame(0)
    >>> frame.tangent, frame["curvature"].item()
    (array([1., 0.]), 1.0)
    """

    def __getattr__(self, name: str) -> NDArray[float64]:
        """The array of this name."""
        try:
            return self[name]
        except KeyError:
            known = ", ".join(self)
            raise AttributeError(f"{name!r} is not in this frame: it has {known}") from None

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickles as a class and its items."""
        return type(self), (dict(self),)
