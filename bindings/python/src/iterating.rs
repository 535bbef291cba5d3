//! Thirds, sets that are made of copies of themselves, and random points.

use numpy::PyArrayDyn;
use pforms_kernel::Error;
use pforms_operators::{self as operators, Poles, Rule, Shape, Spread};
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::{PyList, PyTuple};

use crate::arguments::{real, require_idle, whole, word};
use crate::errors::{done, fail};
use crate::form::PyForm;
use crate::outputs::array;
use crate::shapes;
use crate::spline::PySpline;

/// The forms at one third and at two thirds between forms, as :func:`midpoint` is the one at one half.
///
/// Parameters
/// ----------
/// *forms : Form or Spline
///     At least one, one by one or in a list, of the same number of axes, in the same space.
///
/// Raises
/// ------
/// ShapeError
///     When axes or spaces differ, or there is no form.
///
/// Examples
/// --------
/// >>> a, b = pf.thirds(pf.Form((0, 3)), pf.Form((3, 9)))
/// >>> a.poles, b.poles
/// (array([1., 5.]), array([2., 7.]))
#[pyfunction]
#[pyo3(signature = (*forms))]
pub(crate) fn thirds<'py>(forms: &Bound<'py, PyTuple>) -> PyResult<Bound<'py, PyList>> {
    let py = forms.py();
    let list = shapes::read_several("forms", forms)?;
    let both = done(py, usize::MAX, || operators::thirds(&list))?;
    let both = both.map(|shape| shapes::object(py, shape));
    PyList::new(py, both.into_iter().collect::<PyResult<Vec<_>>>()?)
}

/// Copies of a form, copies of these, and so on, exactly.
///
/// Parameters
/// ----------
/// form : Form
///     A curve, a surface, a volume or more.
/// generation : int
///     How often; of m copies, generation n has mⁿ.
/// rule : {"cantor", "sponge", "sierpinski"}, optional
///     The first and the last third along every axis; all thirds but those in the middle along two
///     axes or more; the homotheties of a ratio centred at the poles.
/// ratio : float, optional
///     Of the homotheties.
///
/// Returns
/// -------
/// list of Form
///
/// Raises
/// ------
/// ShapeError, DomainError
///     For a point; for a centre at infinity.
/// LimitError
///     When there would be too many.
///
/// Examples
/// --------
/// >>> [part.poles.ravel().round().tolist() for part in pf.iterate(pf.Form([(0,), (9,)]), 2)]
/// [[0.0, 1.0], [2.0, 3.0], [6.0, 7.0], [8.0, 9.0]]
/// >>> len(pf.iterate(pf.cube((2, 2, 2)), 2, "sponge"))
/// 400
#[pyfunction]
#[pyo3(
    signature = (form, generation, rule=None, *, ratio=None),
    text_signature = "(form, generation, rule='cantor', *, ratio=0.5)"
)]
pub(crate) fn iterate<'py>(
    form: &Bound<'py, PyAny>,
    generation: &Bound<'py, PyAny>,
    rule: Option<&Bound<'py, PyAny>>,
    ratio: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyList>> {
    let py = form.py();
    let Shape::Form(form) = shapes::read("form", form)? else {
        return fail(&Error::shape("form", "a Spline", "a Form"));
    };
    let rules = ["cantor", "sponge", "sierpinski"];
    let rule = rule.map_or(Ok(rules[0]), |given| word("rule", given, &rules))?;
    if rule != "sierpinski" {
        require_idle("ratio", ratio, "only \"sierpinski\" has a ratio")?;
    }
    let rule = match rule {
        "sponge" => Rule::Sponge,
        "sierpinski" => Rule::Sierpinski(ratio.map_or(Ok(0.5), |given| real("ratio", given))?),
        _ => Rule::Cantor,
    };
    let generation = whole("generation", generation)?;
    let forms = done(py, usize::MAX, || operators::iterate(&form, generation, &rule))?;
    let forms = forms.into_iter().map(|form| PyForm::from(form).into_bound_py_any(py));
    PyList::new(py, forms.collect::<PyResult<Vec<_>>>()?)
}

/// Peano's curve in the unit square or cube: a line that comes by everywhere.
///
/// Through the middles of ``3**generation`` cells along each axis, from cell to neighbouring cell;
/// immersed in a form it runs all over it.
///
/// Parameters
/// ----------
/// generation : int
///     At least 1.
/// axes : int, optional
///     2 for a square, 3 for a cube.
///
/// Returns
/// -------
/// Spline
///     Of degree 1, at equal steps of its parameter.
///
/// Raises
/// ------
/// LimitError
///     When it would have too many poles.
///
/// Examples
/// --------
/// >>> (6 * pf.peano(1).net.poles).round().astype(int).tolist()
/// [[1, 1], [1, 3], [1, 5], [3, 5], [3, 3], [3, 1], [5, 1], [5, 3], [5, 5]]
#[pyfunction]
#[pyo3(signature = (generation, axes=None), text_signature = "(generation, axes=2)")]
pub(crate) fn peano<'py>(
    generation: &Bound<'py, PyAny>,
    axes: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = generation.py();
    let generation = whole("generation", generation)?;
    let axes = axes.map_or(Ok(2), |given| whole("axes", given))?;
    let curve = done(py, usize::MAX, || operators::peano::<f64>(generation, axes))?;
    PySpline::from(curve).into_bound_py_any(py)
}

/// Random points of a form.
///
/// Parameters
/// ----------
/// form : Form or Spline
///     A curve, a surface, a volume or more.
/// count : int
///     How many.
/// law : {"uniform", "gaussian"}, optional
///     Evenly by length, area or volume, however the form is parametrised; or parameters normal
///     about the middle of the window, a sixth of it the standard deviation.
/// seed : int, optional
///     The same seed gives the same points on every machine.
///
/// Returns
/// -------
/// ndarray, shape (count, c)
///
/// Raises
/// ------
/// ShapeError, DomainError, DegenerateError
///     For a point; for a form that goes to infinity; for one without length, area or volume.
///
/// Examples
/// --------
/// >>> points = pf.random_points(pf.sphere(1), 4000)
/// >>> points.shape, bool(abs(points.mean(axis=0)).max() < 0.05)
/// ((4000, 3), True)
#[pyfunction]
#[pyo3(
    signature = (form, count, *, law=None, seed=None),
    text_signature = "(form, count, *, law='uniform', seed=0)"
)]
pub(crate) fn random_points<'py>(
    form: &Bound<'py, PyAny>,
    count: &Bound<'py, PyAny>,
    law: Option<&Bound<'py, PyAny>>,
    seed: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    let py = form.py();
    let shape = shapes::read("form", form)?;
    let count = whole("count", count)?;
    let laws = ["uniform", "gaussian"];
    let law = match law.map_or(Ok(laws[0]), |given| word("law", given, &laws))? {
        "gaussian" => Spread::Gaussian,
        _ => Spread::Uniform,
    };
    let seed = seed.map_or(Ok(0), |given| whole("seed", given))? as u64;
    let points = done(py, usize::MAX, || operators::random_points(&shape, count, law, seed))?;
    array(py, &[count, shape.net().ambient()], points)
}
