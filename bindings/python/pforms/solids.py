"""Solids together and apart, by the name of the operation."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from pforms._pforms import common, difference, union
from pforms.errors import DomainError

if TYPE_CHECKING:
    from collections.abc import Callable

    from pforms.records import Mesh, Solid

_OPERATIONS = {"union": union, "difference": difference, "common": common}


def boolean(
    a: Any,  # noqa: ANN401
    b: Any,  # noqa: ANN401
    op: str,
    *,
    accuracy: float = 1e-3,
    report: bool = False,
) -> Mesh | Solid:
    """The union, difference or common part of two solids, as a closed mesh.

    Parameters
    ----------
    a, b : Form, Spline, Mesh, or sequence of them
        As for :func:`union`.
    op : {"union", "difference", "common"}
        Which.
    accuracy, report
        As for :func:`union`.

    Raises
    ------
    DomainError
        For another operation; otherwise as :func:`union`.

    Examples
    --------
    >>> import pforms as pf
    >>> box = pf.cube((2, 2, 2))
    >>> round(pf.boolean(box, pf.translate(box, (0.5, 0, 0)), "common").volume, 12)
    0.5
    """
    if op not in _OPERATIONS:
        raise DomainError(f'op: received {op!r}, expected "union", "difference" or "common"')
    operation: Callable[..., Mesh | Solid] = _OPERATIONS[op]
    return operation(a, b, accuracy=accuracy, report=report)
