//! Where forms meet.

use numpy::PyArray1;
use pforms_kernel::{Error, Form};
use pforms_operators::{
    self as operators, Branch, Contact, Crossings, Intersections, Poles, Shape,
};
use pyo3::IntoPyObjectExt;
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

use crate::arguments::real;
use crate::arrays::Numbers;
use crate::errors::{done, fail, mistyped, raised};
use crate::form::PyForm;
use crate::outputs::array;
use crate::shapes::read;
use crate::slices::in_slices;
use crate::spline::PySpline;

/// Where two curves, a curve and a surface, or two surfaces meet.
///
/// All places over the windows of both, each proved; or it is said where more may be. The poles are
/// taken at their word: what is called crossing or tangent and ``proved`` is one of the exact forms.
///
/// Parameters
/// ----------
/// first, second : Form, Spline or array_like
///     Curves or surfaces in one space.
/// accuracy : float, optional
///     In sizes of the forms: what comes nearer and does not meet is a touch; crossings between which
///     the forms stay nearer are one tangent, and arcs that do are an overlap. With 0 only what
///     is exactly so is told.
/// host : Form or Spline, optional
///     Where the two are immersed: they are curves in its parameters, and points are points of it.
///
/// Returns
/// -------
/// Intersection
///     For k places ``first`` (k, axes), ``second`` (k, axes), ``points`` (k, c), ``kinds``, ``orders``,
///     ``gaps``, ``errors``, ``proved``; ``overlaps``; ``curves``; ``complete`` and ``undecided``.
///
/// Raises
/// ------
/// ShapeError
///     For spaces of different dimension, and what is neither curve nor surface.
/// DomainError
///     For a weight that vanishes in the window; for an accuracy not from 0 to 1.
///
/// Examples
/// --------
/// >>> parabola = pf.Form([(-1, 1), (0, -1), (1, 1)])
/// >>> found = pf.intersect(parabola, [(-1, 0.25), (1, 0.25)])
/// >>> found.points
/// array([[-0.5 ,  0.25],
///        [ 0.5 ,  0.25]])
/// >>> found.kinds, found.complete
/// (('crossing', 'crossing'), True)
#[pyfunction]
#[pyo3(
    signature = (first, second, *, accuracy=None, host=None),
    text_signature = "(first, second, *, accuracy=1e-14, host=None)"
)]
pub(crate) fn intersect<'py>(
    first: &Bound<'py, PyAny>,
    second: &Bound<'py, PyAny>,
    accuracy: Option<&Bound<'py, PyAny>>,
    host: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let (a, b) = (read("first", first)?, read("second", second)?);
    let accuracy = accuracy.map_or(Ok(ACCURACY), |x| real("accuracy", x))?;
    let py = first.py();
    let cost = PAIR.saturating_mul(a.net().pole_count()).saturating_mul(b.net().pole_count());
    let host = host.map(|host| read("host", host)).transpose()?;
    let ambient = host.as_ref().unwrap_or(&a).net().ambient();
    let found = done(py, cost, || match &host {
        Some(host) => operators::intersect_inside(host, &a, &b, accuracy),
        None => operators::intersect(&a, &b, accuracy),
    })?;
    record(py, [a.net().axes(), b.net().axes(), ambient], found)
}

/// Where the forms of many pairs meet, in one call.
///
/// As :func:`intersect` for each pair; points and what two surfaces share only where there is more than
/// places.
///
/// Parameters
/// ----------
/// first, second : list of forms, or array_like of shape (n, order, c)
///     As many; a single form of one side meets all of the other. An array is the poles of n curves.
/// accuracy : float, optional
///
/// Returns
/// -------
/// Crossings
///     ``parameters`` (k, axes of both) and ``starts`` (n + 1): those of pair i are
///     ``parameters[starts[i]:starts[i + 1]]``; ``kinds``, ``errors``, ``complete``, ``whole``.
///
/// Examples
/// --------
/// >>> rising, falling = pf.Form([(0, 0), (1, 1)]), pf.Form([(0, 1), (1, 0)])
/// >>> arch = pf.Form([(0, 0), (0.5, 1.5), (1, 0)])
/// >>> found = pf.intersect_many([rising, arch], falling)
/// >>> found.starts, found.parameters[0]
/// (array([0, 1, 3]), array([0.5, 0.5]))
/// >>> [len(pair) for pair in found.pairs()]
/// [1, 2]
#[pyfunction]
#[pyo3(
    signature = (first, second, *, accuracy=None),
    text_signature = "(first, second, *, accuracy=1e-14)"
)]
pub(crate) fn intersect_many<'py>(
    first: &Bound<'py, PyAny>,
    second: &Bound<'py, PyAny>,
    accuracy: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let (a, b) = (several("first", first)?, several("second", second)?);
    let accuracy = accuracy.map_or(Ok(ACCURACY), |x| real("accuracy", x))?;
    let count = if a.len() == 1 { b.len() } else { a.len() };
    if b.len() != count && b.len() != 1 {
        let expected = format!("{count}, one for each of first");
        return fail(&Error::shape("second", format!("{} forms", b.len()), expected));
    }
    let at = |list: &'_ [Form], i: usize| if list.len() == 1 { 0 } else { i };
    let pairs: Vec<(&Form, &Form)> = (0..count).map(|i| (&a[at(&a, i)], &b[at(&b, i)])).collect();
    let axes = pairs.first().map_or(2, |(a, b)| a.axes() + b.axes());
    if let Some((a, b)) = pairs.iter().find(|(a, b)| a.axes() + b.axes() != axes) {
        let received = format!("a pair of {} and {}", a.kind(), b.kind());
        return fail(&Error::shape("second", received, "pairs with as many axes each"));
    }
    let py = first.py();
    let mut all = Crossings { starts: vec![0], ..Crossings::default() };
    in_slices(py, count, PAIR, |range| {
        append(&mut all, operators::intersect_many(&pairs[range], accuracy)?);
        Ok(())
    })?;
    crossings(py, &pairs, axes, all)
}

/// The default: some roundings.
const ACCURACY: f64 = 1e-14;

/// Multiplications for a pair, about.
const PAIR: usize = 1 << 12;

/// Forms in a list, one alone, or an array of the poles of curves.
fn several(argument: &str, object: &Bound<'_, PyAny>) -> PyResult<Vec<Form>> {
    if let Ok(form) = object.cast::<PyForm>() {
        return Ok(vec![form.get().form.clone()]);
    }
    if let Some(numbers) = Numbers::if_any(argument, object)? {
        let &[count, order, ambient] = numbers.shape() else {
            let received = format!("an array of shape {:?}", numbers.shape());
            return fail(&Error::shape(argument, received, "shape (n, order, c)"));
        };
        let curves = numbers.values().chunks_exact((order * ambient).max(1)).take(count);
        let curve = |points: &[f64]| Form::from_points(&[order], ambient, points, None);
        return curves.map(curve).collect::<Result<_, _>>().map_err(|e| raised(&e));
    }
    let Ok(items) = object.try_iter() else {
        return Err(mistyped(argument, object, "a list of forms"));
    };
    items
        .map(|item| match read(argument, &item?)? {
            Shape::Form(form) => Ok(form),
            Shape::Spline(_) => {
                let received = "a Spline";
                fail(&Error::shape(argument, received, "forms (intersect takes a spline)"))
            }
        })
        .collect()
}

fn append(all: &mut Crossings, more: Crossings) {
    let (before, pairs) = (all.errors.len(), all.complete.len());
    all.starts.extend(more.starts[1..].iter().map(|start| start + before));
    all.parameters.extend(more.parameters);
    all.kinds.extend(more.kinds);
    all.errors.extend(more.errors);
    all.complete.extend(more.complete);
    all.overlapping.extend(more.overlapping.into_iter().map(|(i, whole)| (i + pairs, whole)));
}

fn crossings<'py>(
    py: Python<'py>,
    pairs: &[(&Form, &Form)],
    axes: usize,
    found: Crossings,
) -> PyResult<Bound<'py, PyAny>> {
    let count = found.errors.len();
    let whole = PyDict::new(py);
    for (i, answer) in found.overlapping {
        let (a, b) = pairs[i];
        whole.set_item(i, record(py, [a.axes(), b.axes(), a.ambient()], answer)?)?;
    }
    let starts: Vec<i64> = found.starts.iter().map(|start| *start as i64).collect();
    let kinds: Vec<u8> = found.kinds.iter().map(|kind| *kind as u8).collect();
    let fields = (
        array(py, &[count, axes], found.parameters)?,
        PyArray1::from_vec(py, starts),
        PyArray1::from_vec(py, kinds),
        PyArray1::from_vec(py, found.errors),
        PyArray1::from_vec(py, found.complete),
        whole,
    );
    class(py, "Crossings")?.call1(fields)
}

fn class<'py>(py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
    py.import(intern!(py, "pforms.records"))?.getattr(name)
}

/// A `pforms.records.Intersection`, for the axes of both forms and the dimension of the points.
fn record(
    py: Python<'_>,
    [p, q, ambient]: [usize; 3],
    found: Intersections,
) -> PyResult<Bound<'_, PyAny>> {
    let list = &found.contacts;
    let count = list.len();
    let wide = |width: usize, part: &dyn Fn(&Contact) -> &[f64]| {
        array(py, &[count, width], list.iter().flat_map(part).copied().collect())
    };
    let column =
        |part: &dyn Fn(&Contact) -> f64| array(py, &[count], list.iter().map(part).collect());
    let ends = |pair: &[Vec<f64>; 2], axes: usize| array(py, &[2, axes], pair.concat());
    let overlaps = found.overlaps.iter().map(|o| {
        class(py, "Overlap")?.call1((ends(&o.first, p)?, ends(&o.second, q)?, o.gap, o.proved))
    });
    let undecided =
        found.undecided.iter().map(|u| PyTuple::new(py, [ends(&u.first, p)?, ends(&u.second, q)?]));
    let kinds = list.iter().map(|c| c.kind.name());
    let orders: Vec<i64> = list.iter().map(|c| c.order as i64).collect();
    let proved: Vec<bool> = list.iter().map(|c| c.proved).collect();
    let fields = [
        wide(p, &|c| &c.first)?.into_bound_py_any(py)?,
        wide(q, &|c| &c.second)?.into_bound_py_any(py)?,
        wide(ambient, &|c| &c.point)?.into_bound_py_any(py)?,
        PyTuple::new(py, kinds)?.into_any(),
        PyArray1::from_vec(py, orders).into_any(),
        column(&|c| c.gap)?.into_bound_py_any(py)?,
        column(&|c| c.error)?.into_bound_py_any(py)?,
        PyArray1::from_vec(py, proved).into_any(),
        PyTuple::new(py, overlaps.collect::<PyResult<Vec<_>>>()?)?.into_any(),
        PyTuple::new(
            py,
            found.branches.into_iter().map(|b| branch(py, b)).collect::<PyResult<Vec<_>>>()?,
        )?
        .into_any(),
        found.complete.into_bound_py_any(py)?,
        PyTuple::new(py, undecided.collect::<PyResult<Vec<_>>>()?)?.into_any(),
    ];
    class(py, "Intersection")?.call1(PyTuple::new(py, fields)?)
}

fn branch(py: Python<'_>, branch: Branch) -> PyResult<Bound<'_, PyAny>> {
    let Branch { first, second, curve, error, closed, tangent } = branch;
    let spline = |spline| PySpline::from(spline).into_bound_py_any(py);
    class(py, "Branch")?.call1((
        spline(first)?,
        spline(second)?,
        spline(curve)?,
        error,
        closed,
        tangent,
    ))
}

/// The operator as a method of a class.
macro_rules! methods {
    ($class:ident) => {
        #[pymethods]
        impl $class {
            /// Where this and another form meet: see :func:`pforms.intersect`.
            ///
            /// >>> pf.Form([(0, 0), (2, 2)]).intersect([(0, 2), (2, 0)]).points
            /// array([[1., 1.]])
            #[pyo3(signature = (other, *, accuracy=None))]
            #[pyo3(text_signature = "($self, other, *, accuracy=1e-14)")]
            fn intersect<'py>(
                slf: &Bound<'py, Self>,
                other: &Bound<'py, PyAny>,
                accuracy: Option<&Bound<'py, PyAny>>,
            ) -> PyResult<Bound<'py, PyAny>> {
                intersect(slf.as_any(), other, accuracy, None)
            }
        }
    };
}

methods!(PyForm);
methods!(PySpline);
