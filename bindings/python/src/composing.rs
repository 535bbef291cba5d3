//! Forms composed of forms: matrices that move a section along.

use pforms_kernel::{Error, Form};
use pforms_operators::{self as operators, Poles, Shape};
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::arrays::Numbers;
use crate::errors::{done, fail, raised, renamed};
use crate::form::PyForm;
use crate::forms::Forms;
use crate::shapes;
use crate::spline::PySpline;

/// What a form of matrices makes of a section: AFFINE(u, …)·section(v, …), exactly.
///
/// The axes of the matrices come first, then those of the section. Each matrix is multiplied with
/// each homogeneous pole, so sweeping commutes with :func:`stack` and :func:`midpoint`.
///
/// Parameters
/// ----------
/// matrix : Form or array_like, shape (n1, …, nd, r, c)
///     The matrices, as poles; c is one more than the dimension of the section, r one more than
///     that of the result. A form has their entries, row by row, for homogeneous coordinates:
///     :func:`affine_matrix` makes one from its columns.
///     A :class:`Spline` of matrices will do too.
/// section : Form or Spline
///
/// Returns
/// -------
/// Form, or Spline if one of them is
///
/// Raises
/// ------
/// ShapeError, DomainError, LimitError
///     When the matrices do not fit the section; for NaN, and when a product overflows; when the
///     result is too large.
///
/// Examples
/// --------
/// >>> shift = [[[1, 0, 0], [0, 1, 0], [0, 0, 1]], [[1, 0, 0], [0, 1, 5], [0, 0, 1]]]
/// >>> pf.affine_sweep(shift, pf.Form([(1, 0), (2, 0)])).poles[1]
/// array([[1., 5.],
///        [2., 5.]])
#[pyfunction]
#[pyo3(signature = (matrix, section))]
pub(crate) fn affine_sweep<'py>(
    matrix: &Bound<'py, PyAny>,
    section: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = matrix.py();
    let (matrix, section) = (matrices(matrix)?, shapes::read("section", section)?);
    let cost = matrix.net().homogeneous().len().saturating_mul(section.net().pole_count());
    let swept = done(py, cost, || match (matrix, section) {
        (Shape::Form(matrix), Shape::Form(section)) => {
            operators::affine_sweep(&matrix, &section).map(Shape::from)
        }
        (matrix, section) => {
            operators::affine_sweep_spline(&matrix.into_spline(), &section.into_spline())
                .map(Shape::from)
        }
    })?;
    shapes::object(py, swept)
}

/// A form or spline of matrices, or an array of them: its last two axes are rows and columns.
fn matrices(given: &Bound<'_, PyAny>) -> PyResult<Shape> {
    if given.is_instance_of::<PyForm>() || given.is_instance_of::<PySpline>() {
        return shapes::read("matrix", given);
    }
    let numbers = Numbers::read("matrix", given)?;
    match numbers.shape() {
        [orders @ .., rows, columns] if rows * columns >= 2 => {
            Form::from_homogeneous(orders, rows * columns - 1, numbers.values().to_vec())
                .map(Shape::from)
                .map_err(|error| raised(&renamed(error, "poles", "matrix")))
        }
        shape => fail(&Error::shape(
            "matrix",
            format!("an array of shape {shape:?}"),
            "a Form, or shape (n1, …, nd, rows, columns)",
        )),
    }
}

/// The form of matrices whose columns are vectors and, last, an origin.
///
/// Swept over the point (s, t, …) it is origin + s·first + t·second + …, for the euclidean values
/// of the columns. Unnormalised frames (:meth:`Form.normal_form`, :meth:`Form.binormal_form`,
/// :meth:`Form.tangent_form`) so make exact sweeps along a path.
///
/// Parameters
/// ----------
/// *columns : Form
///     One by one or in a list, in one space; one without axes is the same everywhere. Rational
///     ones are brought to the product of their different weights.
///
/// Raises
/// ------
/// ShapeError, DomainError, LimitError
///     When axes or spaces differ; for an origin of directions; when the result is too large.
///
/// Examples
/// --------
/// >>> path = pf.Form([(0, 0, 0), (0, 0, 1), (0, 2, 2)])
/// >>> matrix = pf.affine_matrix(path.normal_form(), path.binormal_form(), path)
/// >>> pf.affine_sweep(matrix, pf.Form([(-1, 0), (1, 0)]))
/// <pforms.Form pS32 in 3D>
#[pyfunction]
#[pyo3(signature = (*columns))]
pub(crate) fn affine_matrix(columns: &Bound<'_, PyTuple>) -> PyResult<PyForm> {
    let py = columns.py();
    let list = Forms::read_several("columns", columns)?;
    let columns = list.refs();
    let cost = columns.iter().map(|form| form.homogeneous().len().pow(2)).sum();
    done(py, cost, || operators::affine_matrix(&columns)).map(PyForm::from)
}
