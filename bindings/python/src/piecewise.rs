//! The class `Piecewise`: forms put end to end.

use numpy::PyArrayDyn;
use pforms_kernel::Form;
use pforms_operators::Piecewise;
use pyo3::prelude::*;
use pyo3::types::{PyIterator, PyList, PyTuple};

use crate::arrays::Numbers;
use crate::errors::{done, raised};
use crate::evaluation::points;
use crate::form::{PyForm, from_homogeneous};
use crate::outputs::array;
use crate::view::view;

/// Pieces of one degree along each axis, put end to end: what :meth:`Form.subdivide` makes.
///
/// It evaluates as one form and unpacks into its pieces, the last axis fastest.
///
/// >>> halves = pf.Form([(0, 0), (1, 2), (2, 0)]).subdivide(1)
/// >>> halves.homogeneous[:, 1]
/// array([0., 1., 1., 1., 0.])
/// >>> halves(0.5)
/// array([1., 1.])
/// >>> low, high = halves
#[pyclass(frozen, module = "pforms", name = "Piecewise", weakref)]
pub(crate) struct PyPiecewise {
    pieces: Piecewise,
}

impl From<Piecewise> for PyPiecewise {
    fn from(pieces: Piecewise) -> Self {
        Self { pieces }
    }
}

#[pymethods]
impl PyPiecewise {
    /// The refined net, shape (n1·k1 + 1, …, c+1): the poles of ``k`` pieces of degree ``n``,
    /// read-only.
    ///
    /// >>> pf.Form([(0,), (2,)]).subdivide(1).homogeneous
    /// array([[0., 1.],
    ///        [1., 1.],
    ///        [2., 1.]])
    #[getter]
    fn homogeneous<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        view(&Bound::new(py, self.net())?)
    }

    /// The refined net as a form: its control polygons put end to end, not the same points.
    ///
    /// >>> pf.Form([(0, 0), (1, 2), (2, 0)]).subdivide(1).net
    /// <pforms.Form pL5 in 2D>
    #[getter]
    fn net(&self) -> PyForm {
        self.pieces.net().clone().into()
    }

    /// The pieces as forms, the last axis fastest.
    ///
    /// >>> pf.Form([(0, 0), (1, 2), (2, 0)]).subdivide(1).pieces
    /// [<pforms.Form pL3 in 2D>, <pforms.Form pL3 in 2D>]
    #[getter]
    fn pieces<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        let pieces = done(py, self.pieces.net().homogeneous().len(), || self.pieces.pieces())?;
        PyList::new(py, pieces.into_iter().map(PyForm::from))
    }

    /// Along each axis, the parameters where pieces begin and end.
    ///
    /// >>> pf.Form([(0, 0), (1, 2), (2, 0)]).subdivide(1).breaks
    /// (array([0. , 0.5, 1. ]),)
    #[getter]
    fn breaks<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        let lists = self.pieces.breaks().iter();
        let arrays: Vec<_> =
            lists.map(|list| array(py, &[list.len()], list.clone())).collect::<PyResult<_>>()?;
        PyTuple::new(py, arrays)
    }

    /// Degree of every piece along each axis.
    ///
    /// >>> pf.Form([(0, 0), (1, 2), (2, 0)]).subdivide(1).degrees
    /// (2,)
    #[getter]
    fn degrees<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, self.pieces.degrees())
    }

    /// Number of pieces along each axis.
    ///
    /// >>> pf.Form([(0, 0), (1, 2), (2, 0)]).subdivide(3).counts
    /// (8,)
    #[getter]
    fn counts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, self.pieces.counts())
    }

    /// Number of axes.
    ///
    /// >>> pf.Form([(0, 0), (1, 2)]).subdivide(1).axes
    /// 1
    #[getter]
    fn axes(&self) -> usize {
        self.pieces.net().axes()
    }

    /// Dimension of the space the pieces lie in.
    ///
    /// >>> pf.Form([(0, 0), (1, 2)]).subdivide(1).ambient
    /// 2
    #[getter]
    fn ambient(&self) -> usize {
        self.pieces.net().ambient()
    }

    /// Points at broadcast parameters, as :meth:`Form.__call__`.
    #[pyo3(signature = (*parameters))]
    fn __call__<'py>(
        &self,
        parameters: &Bound<'py, PyTuple>,
    ) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        points(&self.pieces, parameters, None, None)
    }

    fn __iter__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyIterator>> {
        self.pieces(py)?.try_iter()
    }

    fn __len__(&self) -> usize {
        self.pieces.counts().iter().product()
    }

    fn __repr__(&self) -> String {
        let counts: Vec<String> = self.pieces.counts().iter().map(usize::to_string).collect();
        let orders: Vec<usize> = self.pieces.degrees().iter().map(|degree| degree + 1).collect();
        format!(
            "<pforms.Piecewise of {} pieces {} in {}D>",
            if counts.is_empty() { "1".to_owned() } else { counts.join("×") },
            pforms_kernel::Kind::new(&orders),
            self.pieces.net().ambient()
        )
    }

    fn __eq__(&self, other: &Self) -> bool {
        self.pieces == other.pieces
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Restored<'py>)> {
        let make = py.get_type::<Self>().getattr("_restore")?;
        let breaks: Vec<Vec<f64>> = self.pieces.breaks().to_vec();
        Ok((make, (self.homogeneous(py)?, self.pieces.degrees().to_vec(), breaks)))
    }

    #[staticmethod]
    fn _restore(
        net: &Bound<'_, PyAny>,
        degrees: Vec<usize>,
        breaks: Vec<Vec<f64>>,
    ) -> PyResult<Self> {
        let net: Form =
            from_homogeneous("net", &Numbers::read("net", net)?).map_err(|e| raised(&e))?;
        Piecewise::new(net, degrees, breaks).map(Self::from).map_err(|error| raised(&error))
    }
}

/// Net, degrees and breaks, as they are pickled.
type Restored<'py> = (Bound<'py, PyArrayDyn<f64>>, Vec<usize>, Vec<Vec<f64>>);
