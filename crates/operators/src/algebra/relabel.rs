//! Sub-forms, and changes of the axes' direction and order.

use pforms_kernel::{Error, Form, Matrix, Result, Scalar, bernstein_row};

/// The sub-form (isoparametric form) where parameter `axis` is `t`: one axis less.
///
/// Any real `t`. In `f64` and for `t` in `[0, 1]` each pole is within `2·degree + 1` roundings of
/// the exact one, relative to the largest pole.
///
/// Errors: `Shape` when there is no such axis, `Domain` when `t` is not finite. Book 2141.
pub fn sub<S: Scalar>(form: &Form<S>, axis: usize, t: &S) -> Result<Form<S>> {
    form.require_axis(axis)?;
    if !t.is_finite() {
        return Err(Error::domain("t", format!("{t:?}"), "a finite number"));
    }
    let result = form.contract(axis, &bernstein_row(form.orders()[axis] - 1, t))?;
    Ok(match form.uniform_weight() {
        Some(weight) => result.with_uniform_weight(weight),
        None => result,
    })
}

/// The form run backwards along `axis`: `u` becomes `1 − u`. Exact.
///
/// Errors: `Shape` when there is no such axis.
pub fn reverse<S: Scalar>(form: &Form<S>, axis: usize) -> Result<Form<S>> {
    form.require_axis(axis)?;
    let order = form.orders()[axis];
    let flip =
        Matrix::from_rule(
            order,
            order,
            |i, j| {
                if i + j + 1 == order { S::one() } else { S::zero() }
            },
        );
    form.along(axis, &flip)
}

/// The form with its axes in another order: axis `k` of the result is axis `axes[k]` of `form`.
///
/// Errors: `Shape` unless `axes` is a permutation.
pub fn transpose<S: Scalar>(form: &Form<S>, axes: &[usize]) -> Result<Form<S>> {
    let mut sorted = axes.to_vec();
    sorted.sort_unstable();
    if !sorted.iter().copied().eq(0..form.axes()) {
        return Err(Error::shape(
            "axes",
            format!("{axes:?}"),
            format!("each of the axes of a {} once", form.kind()),
        ));
    }
    let orders: Vec<usize> = axes.iter().map(|&axis| form.orders()[axis]).collect();
    let mut poles = Vec::with_capacity(form.homogeneous().len());
    let mut old = vec![0; form.axes()];
    for flat in 0..form.pole_count() {
        let mut rest = flat;
        for (&axis, &order) in axes.iter().zip(&orders).rev() {
            old[axis] = rest % order;
            rest /= order;
        }
        poles.extend_from_slice(form.pole(&old)?);
    }
    Form::from_homogeneous(&orders, form.ambient(), poles)
}
