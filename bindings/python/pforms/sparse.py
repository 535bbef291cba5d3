"""Matrices of which few entries are kept."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from numpy import float64, int64
    from numpy.typing import ArrayLike, NDArray


class Sparse(NamedTuple):
    """A sparse matrix in compressed sparse rows: the arrays that SciPy's ``csr_array`` takes.

    >>> import pforms as pf
    >>> segment = pf.Form([(0, 0), (4, 8)])
    >>> matrix = pf.sensitivities("SUB(f, 0, 1/4)", "f", f=segment)
    >>> matrix
    <pforms.Sparse 3×6, 10 entries>
    >>> matrix @ [0, 1, 0, 0, 1, 0]
    array([0., 1., 0.])
    """

    data: NDArray[float64]
    """The entries, row after row."""
    indices: NDArray[int64]
    """The column of each entry."""
    indptr: NDArray[int64]
    """Where each row begins among the entries, and where the last one ends."""
    shape: tuple[int, int]
    """Rows and columns."""

    def __repr__(self) -> str:
        """The size: ``<pforms.Sparse 3×6, 10 entries>``."""
        rows, columns = self.shape
        return f"<pforms.Sparse {rows}×{columns}, {self.data.size} entries>"

    @property
    def rows(self) -> NDArray[int64]:
        """The row of each entry.

        >>> pf.sensitivities("[2*x, x*y]", "y", x=3, y=5).rows
        array([1])
        """
        return np.repeat(np.arange(self.shape[0]), np.diff(self.indptr))

    def __matmul__(self, vector: ArrayLike) -> NDArray[float64]:
        """The product with a vector: how the results follow when all sources move a little."""
        x = self._vector(vector, self.shape[1], "columns")
        return np.bincount(self.rows, self.data * x[self.indices], self.shape[0]).astype(float)

    def transposed(self, vector: ArrayLike) -> NDArray[float64]:
        """The transpose times a vector: the gradient of a weighted sum of the results.

        >>> pf.sensitivities("[2*x, x^2]", "x", x=3).transposed([1, 10])
        array([62.])
        """
        y = self._vector(vector, self.shape[0], "rows")
        return np.bincount(self.indices, self.data * y[self.rows], self.shape[1]).astype(float)

    def toarray(self) -> NDArray[float64]:
        """All entries, zeros too.

        >>> pf.sensitivities("[2*x, 7]", "x", x=3).toarray()
        array([[2.],
               [0.]])
        """
        dense = np.zeros(self.shape)
        dense[self.rows, self.indices] = self.data
        return dense

    def scipy(self) -> Any:  # noqa: ANN401
        """The same matrix as a ``scipy.sparse.csr_array``.

        Raises ImportError without SciPy.
        """
        try:
            sparse = import_module("scipy.sparse")
        except ImportError as missing:
            raise ImportError("Sparse.scipy needs SciPy: pip install scipy") from missing
        return sparse.csr_array((self.data, self.indices, self.indptr), shape=self.shape)

    @staticmethod
    def _vector(vector: ArrayLike, length: int, what: str) -> NDArray[float64]:
        numbers = np.asarray(vector, float)
        if numbers.shape != (length,):
            from pforms.errors import ShapeError

            raise ShapeError(
                f"vector: received shape {numbers.shape}, "
                f"expected ({length},), a number for each of the {what}"
            )
        return numbers
