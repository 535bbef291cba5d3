//! Tangents and normals as forms: not of length 1, and therefore exact.

use pforms_operators as operators;
use pyo3::prelude::*;

use crate::form::PyForm;

#[pymethods]
impl PyForm {
    /// The tangent along ``axis`` as a form of vectors: the derivative times the weight squared.
    ///
    /// Raises ShapeError when there is no such axis.
    ///
    /// >>> pf.Form([(1, 0), (1, 1), (0, 1)], [1, 1, 2]).tangent_form().poles
    /// array([[ 0.,  2.],
    ///        [-2.,  2.],
    ///        [-4.,  0.]])
    #[pyo3(signature = (axis=None), text_signature = "($self, axis=0)")]
    fn tangent_form(&self, py: Python<'_>, axis: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        let k = self.first_axis_or(axis)?;
        self.worked(py, |form| operators::tangent_form(form, k))
    }

    /// The normal of a surface in 3D, or of a curve in 2D or 3D, as a form of vectors.
    ///
    /// Raises ShapeError for other forms.
    ///
    /// >>> pf.Form([(0, 0), (2, 4), (4, 0)]).normal_form().poles
    /// array([[-8.,  4.],
    ///        [ 8.,  4.]])
    fn normal_form(&self, py: Python<'_>) -> PyResult<Self> {
        self.worked(py, operators::normal_form)
    }

    /// The binormal of a curve in 3D as a form of vectors; 0 along a straight line.
    ///
    /// Raises ShapeError for other forms.
    ///
    /// >>> pf.Form([(0, 0, 0), (1, 0, 0), (2, 2, 0)]).binormal_form()(0.5)
    /// array([0., 0., 8.])
    fn binormal_form(&self, py: Python<'_>) -> PyResult<Self> {
        self.worked(py, operators::binormal_form)
    }
}
