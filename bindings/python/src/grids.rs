//! Points on grids of parameters, of one form or of many.

use pforms_kernel::{Error, Form, grids_into, limit};
use pforms_operators::{self as operators, Spline};
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::{PyInt, PyTuple};

use crate::arguments::{truth, whole};
use crate::arrays::{Numbers, Shape};
use crate::errors::{fail, mistyped, raised};
use crate::evaluation::Evaluate;
use crate::form::PyForm;
use crate::forms::Forms;
use crate::outputs::Output;
use crate::sampling::Grids;
use crate::spline::PySpline;

#[pymethods]
impl PyForm {
    /// Points on a grid of parameters, if wanted with the unit normals of a surface.
    ///
    /// Parameters
    /// ----------
    /// *parameters : int or array_like
    ///     For each axis a count, for so many equal steps from 0 to 1, or a list of parameters.
    /// normals : bool, optional
    ///     Return ``points, normals``, both of one call.
    /// out : ndarray, or two of them with normals, optional
    ///     C-contiguous float64 arrays of the result's shape.
    ///
    /// Returns
    /// -------
    /// ndarray, shape (m1, …, md, c), or two of them
    ///
    /// Raises
    /// ------
    /// ShapeError
    ///     Unless there is one argument for each axis, and when ``out`` does not fit.
    /// DomainError
    ///     Where the weight vanishes, for NaN, and for a negative count.
    /// DegenerateError
    ///     Where there is no normal.
    ///
    /// Examples
    /// --------
    /// >>> facet = pf.Form([[(0, 0, 0), (0, 1, 1)], [(1, 0, 1), (1, 1, 0)]])
    /// >>> facet.grid(3, [0.5])[:, 0]
    /// array([[0. , 0.5, 0.5],
    ///        [0.5, 0.5, 0.5],
    ///        [1. , 0.5, 0.5]])
    /// >>> points, normals = facet.grid(100, 100, normals=True)
    #[pyo3(
        signature = (*parameters, normals=None, out=None),
        text_signature = "($self, *parameters, normals=False, out=None)"
    )]
    fn grid<'py>(
        &self,
        parameters: &Bound<'py, PyTuple>,
        normals: Option<&Bound<'py, PyAny>>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        sampled(&[&self.form], Shape::new(), parameters, normals, out)
    }
}

#[pymethods]
impl PySpline {
    /// Points on a grid of parameters, if wanted with the unit normals of a surface.
    ///
    /// As :meth:`Form.grid`; a count divides the window of the spline into equal steps.
    ///
    /// >>> curve = pf.Spline([(0,), (1,), (3,)], 1, [0, 0, 1, 2, 2])
    /// >>> curve.grid(5)[:, 0]
    /// array([0. , 0.5, 1. , 2. , 3. ])
    #[pyo3(
        signature = (*parameters, normals=None, out=None),
        text_signature = "($self, *parameters, normals=False, out=None)"
    )]
    fn grid<'py>(
        &self,
        parameters: &Bound<'py, PyTuple>,
        normals: Option<&Bound<'py, PyAny>>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        spline_grid(&self.spline, parameters, normals, out)
    }
}

/// Points on a grid of parameters: of a form, or of each form of a list in one call.
///
/// Parameters
/// ----------
/// forms : Form, sequence of Form, or Spline
///     Of the same number of axes, in the same space; orders may differ.
/// *parameters : int or array_like
///     For each axis a count, for so many equal steps from 0 to 1, or a list of parameters.
/// normals : bool, optional
///     Return ``points, normals``, both of one call.
/// out : ndarray, or two of them with normals, optional
///     C-contiguous float64 arrays of the result's shape.
///
/// Returns
/// -------
/// ndarray, shape (m1, …, md, c) for a form, (n, m1, …, md, c) for n of them; or two
///
/// Raises
/// ------
/// ShapeError, DomainError, DegenerateError
///     As :meth:`Form.grid`; when axes or spaces differ, and for an empty list.
///
/// Examples
/// --------
/// >>> patches = pf.Form(np.zeros((10000, 4, 4, 3))).unstack()
/// >>> pf.grid(patches, 17, 17).shape
/// (10000, 17, 17, 3)
#[pyfunction]
#[pyo3(
    signature = (forms, /, *parameters, normals=None, out=None),
    text_signature = "(forms, /, *parameters, normals=False, out=None)"
)]
pub(crate) fn grid<'py>(
    forms: &Bound<'py, PyAny>,
    parameters: &Bound<'py, PyTuple>,
    normals: Option<&Bound<'py, PyAny>>,
    out: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    if let Ok(spline) = forms.cast::<PySpline>() {
        return spline_grid(&spline.get().spline, parameters, normals, out);
    }
    let list = Forms::read("forms", forms)?;
    let refs = list.refs();
    let single = forms.is_instance_of::<PyForm>();
    let leading = if single { None } else { Some(refs.len()) };
    sampled(&refs, leading.into_iter().collect(), parameters, normals, out)
}

/// The grids of forms, below the axes of `leading`.
fn sampled<'py>(
    forms: &[&Form],
    leading: Shape,
    parameters: &Bound<'py, PyTuple>,
    normals: Option<&Bound<'py, PyAny>>,
    out: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = parameters.py();
    let lines: Vec<Numbers<'py>> =
        parameters.iter().map(|given| line(&given, (0.0, 1.0))).collect::<PyResult<_>>()?;
    let lists: Vec<&[f64]> = lines.iter().map(Numbers::values).collect();
    let first = require_alike(forms, &lists).map_err(|error| raised(&error))?;
    let shape: Shape = leading.into_iter().chain(lists.iter().map(|list| list.len())).collect();
    let cost = forms.iter().map(|form| form.cost()).max().unwrap_or(0);
    let ambient = Some(first.ambient());
    if !normals.map_or(Ok(false), |normals| truth("normals", normals))? {
        let mut points = Output::new(py, &shape, ambient, out)?;
        Grids::new(forms, &lists, points.numbers()?)
            .fill(py, cost, &|part| grids_into(part.forms, &part.lists, part.points))?;
        return Ok(points.array().into_any());
    }
    let (for_points, for_normals) = out.map(pair).transpose()?.unzip();
    let mut points = Output::new(py, &shape, ambient, for_points.as_ref())?;
    let mut normals = Output::new(py, &shape, ambient, for_normals.as_ref())?;
    Grids { normals: normals.numbers()?, ..Grids::new(forms, &lists, points.numbers()?) }.fill(
        py,
        4 * cost,
        &points_and_normals,
    )?;
    (points.array(), normals.array()).into_bound_py_any(py)
}

/// The grid of a spline; counts divide its window.
fn spline_grid<'py>(
    spline: &Spline,
    parameters: &Bound<'py, PyTuple>,
    normals: Option<&Bound<'py, PyAny>>,
    out: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = parameters.py();
    let mut lines: Vec<Numbers<'py>> = Vec::with_capacity(parameters.len());
    for (axis, given) in parameters.iter().enumerate() {
        lines.push(line(&given, spline.window(axis).unwrap_or((0.0, 1.0)))?);
    }
    let lists: Vec<&[f64]> = lines.iter().map(Numbers::values).collect();
    spline.net().require_per_axis("parameters", &lists).map_err(|error| raised(&error))?;
    let shape: Shape = lists.iter().map(|list| list.len()).collect();
    let ambient = Some(spline.ambient());
    let (cost, nets) = (spline.cost(), [spline.net()]);
    if !normals.map_or(Ok(false), |normals| truth("normals", normals))? {
        let mut points = Output::new(py, &shape, ambient, out)?;
        Grids::new(&nets, &lists, points.numbers()?)
            .fill(py, cost, &|part| spline.grid_into(&part.lists, part.points))?;
        return Ok(points.array().into_any());
    }
    let (for_points, for_normals) = out.map(pair).transpose()?.unzip();
    let mut points = Output::new(py, &shape, ambient, for_points.as_ref())?;
    let mut normals = Output::new(py, &shape, ambient, for_normals.as_ref())?;
    Grids { normals: normals.numbers()?, ..Grids::new(&nets, &lists, points.numbers()?) }.fill(
        py,
        4 * cost,
        &|part| {
            spline.grid_into(&part.lists, part.points)?;
            spline.normal_grid_into(&part.lists, part.normals)
        },
    )?;
    (points.array(), normals.array()).into_bound_py_any(py)
}

/// Two arrays of the caller's.
fn pair<'py>(out: &Bound<'py, PyAny>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
    out.extract().map_err(|_| mistyped("out", out, "two arrays, for points and normals"))
}

fn points_and_normals(part: Grids) -> pforms_kernel::Result<()> {
    let Grids { forms, lists, points, normals } = part;
    let share = points.len() / forms.len();
    for (k, form) in forms.iter().enumerate() {
        let place = k * share..(k + 1) * share;
        form.grid_into(&lists, &mut points[place.clone()])?;
        operators::normal_grid_into(form, &lists, &mut normals[place])?;
    }
    Ok(())
}

/// Complains unless the forms have one number of axes, that of the lists, and one space.
fn require_alike<'a>(forms: &[&'a Form], lists: &[&[f64]]) -> pforms_kernel::Result<&'a Form> {
    let Some(first) = forms.first() else {
        return Err(Error::shape("forms", "none", "at least one form"));
    };
    for form in forms {
        form.require_per_axis("parameters", lists)?;
        if form.ambient() != first.ambient() {
            return Err(Error::shape(
                "forms",
                format!("forms in {}D and {}D", first.ambient(), form.ambient()),
                "forms in one space",
            ));
        }
    }
    Ok(first)
}

/// The parameters of one axis of a grid: a list, or a count of equal steps through the window.
fn line<'py>(given: &Bound<'py, PyAny>, (from, to): (f64, f64)) -> PyResult<Numbers<'py>> {
    if !given.is_instance_of::<PyInt>() {
        let numbers = Numbers::read("parameters", given)?;
        match numbers.shape() {
            [_] => return Ok(numbers),
            [] => {}
            shape => {
                return fail(&Error::shape(
                    "parameters",
                    format!("an array of shape {shape:?}"),
                    "for each axis a count or a list of parameters",
                ));
            }
        }
    }
    let count = whole("parameters", given)?;
    limit::check::<f64>("the grid", &[count], 1).map_err(|error| raised(&error))?;
    let last = count.saturating_sub(1).max(1) as f64;
    let at = |i: usize| match i as f64 / last {
        1.0 => to,
        share => from + share * (to - from),
    };
    Ok((0..count).map(at).collect::<Vec<f64>>().into())
}
