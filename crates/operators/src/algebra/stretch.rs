//! Stretching: the same form over another window; splitting is two stretches.

use pforms_kernel::{Error, Form, Matrix, Result, Scalar, blossom_row};

use super::along::act_along;

/// The form on the window `[a, b]`: restricted, extended or reversed along each axis.
///
/// Any reals: `a > b` reverses, values outside `[0, 1]` extrapolate, `a = b` collapses the axis to
/// a point. Pole `i` is the blossom value with `n − i` arguments `a` and `i` arguments `b`, so
/// nothing is divided. Stretches compose. Book 213; Ramshaw 1987.
///
/// In `f64` and for `a`, `b` in `[0, 1]` within `2·degree + 2` roundings for each axis; outside,
/// the same times `((|1−a|+|a|) · (|1−b|+|b|))^degree`, the growth of the extrapolation itself.
///
/// Errors: `Shape` unless there is one `a` and one `b` for each axis; `Domain` when not finite.
///
/// ```
/// use pforms_kernel::Form;
/// let segment: Form = Form::from_points(&[2], 1, &[0., 1.], None)?;
/// assert_eq!(pforms_operators::stretch(&segment, &[3.0], &[-1.0])?.points()?, [3., -1.]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn stretch<S: Scalar>(form: &Form<S>, a: &[S], b: &[S]) -> Result<Form<S>> {
    form.require_per_axis("a", a)?;
    form.require_per_axis("b", b)?;
    require_finite("a", a)?;
    require_finite("b", b)?;
    let axes = (0..form.axes()).filter(|&axis| !(a[axis].is_zero() && b[axis] == S::one()));
    let window = |axis: usize| (form.orders()[axis] - 1, a[axis].clone(), b[axis].clone());
    act_along(form, axes, window, |(degree, from, to)| Ok(stretch_matrix(*degree, from, to)))
}

/// The two parts of a form at parameter `t` of `axis`: the windows `[0, t]` and `[t, 1]`.
///
/// Any real `t`; the first pole of the second part is the last of the first, to the bit.
///
/// Errors: `Shape` when there is no such axis, `Domain` when `t` is not finite.
pub fn split<S: Scalar>(form: &Form<S>, axis: usize, t: &S) -> Result<(Form<S>, Form<S>)> {
    form.require_axis(axis)?;
    require_finite("t", std::slice::from_ref(t))?;
    let degree = form.orders()[axis] - 1;
    let low = form.along_affine(axis, &stretch_matrix(degree, &S::zero(), t))?;
    let high = form.along_affine(axis, &stretch_matrix(degree, t, &S::one()))?;
    Ok((low, high))
}

/// The square matrix that takes the poles of a degree to those on the window `[a, b]`.
pub fn stretch_matrix<S: Scalar>(degree: usize, a: &S, b: &S) -> Matrix<S> {
    let mut entries = Vec::with_capacity((degree + 1) * (degree + 1));
    let mut arguments = vec![a.clone(); degree];
    for i in 0..=degree {
        if i > 0 {
            arguments[degree - i] = b.clone();
        }
        entries.extend(blossom_row(&arguments));
    }
    Matrix::from_rule(degree + 1, degree + 1, |i, j| entries[i * (degree + 1) + j].clone())
}

fn require_finite<S: Scalar>(argument: &str, values: &[S]) -> Result<()> {
    match values.iter().find(|value| !value.is_finite()) {
        None => Ok(()),
        Some(value) => Err(Error::domain(
            argument,
            format!("{value:?}"),
            "finite numbers (for a window that reaches infinity see whole_line)",
        )),
    }
}
