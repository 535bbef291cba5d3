"""Derivatives of a formula in what it is made of."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pforms._pforms import Sheet

if TYPE_CHECKING:
    from pforms._pforms import Form
    from pforms.sparse import Sparse


def sensitivities(result: str, source: str, /, **values: Form | float | str) -> Sparse:
    """The exact derivatives of a formula in the numbers of one of its values.

    Parameters
    ----------
    result : str
        A formula without its ``=``, in the names of the values: ``"DIAG(MIR(a, b, c))"``.
    source : str
        The name of the value that moves.
    **values : Form, float or str
        What the names stand for; a str is the text of a cell, such as ``"=2*a"``.

    Returns
    -------
    Sparse
        A row for each number of the result, a column for each of the source. The numbers of a form
        are the coordinates and the weight of each pole, in the order of the poles.

    Raises
    ------
    ShapeError
        For a result or a source that holds no numbers.
    DomainError
        For an operator between the two that measures or approximates: it does not hand derivatives
        on; for a derivative that is infinite.
    FormatError
        For a formula or a name that cannot be read.

    Source: catalogue 7; Griewank and Walther, Evaluating Derivatives, 2008.

    Examples
    --------
    >>> import pforms as pf
    >>> arc = pf.Form([(0, 0), (1, 2), (2, 0)])
    >>> pf.sensitivities("POINT(f, 1/4)", "f", f=arc).toarray()[0, ::3]
    array([0.5625, 0.375 , 0.0625])
    """
    sheet = Sheet()
    for row, (name, value) in enumerate(values.items(), 1):
        sheet[f"A{row}"] = value
        sheet.set_name(name, f"A{row}")
    return sheet.sensitivities(result, source)
