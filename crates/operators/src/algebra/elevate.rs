//! Elevation: the same form with more poles.
//!
//! The poles of degree `n + r` are `q_i = Σ_j C(n,j)·C(r,i−j)/C(n+r,i) · p_j`: a product with the
//! polynomial 1 written in degree `r` (book 212; Farin, section 6.1).

use pforms_kernel::{Binomials, Error, Form, Matrix, Result, Scalar, limit};

use super::along::act_along;

/// The form with `by[k]` more poles along each axis `k`. Exact; the shape does not change.
///
/// In `f64` every new pole is a mean of old ones with positive weights, within 8 roundings for
/// each axis of the exact one, relative to the largest pole.
///
/// Errors: `Shape` unless there is one number for each axis; `Limit`.
///
/// ```
/// use pforms_kernel::Form;
/// let parabola: Form = Form::from_points(&[3], 1, &[0., 3., 0.], None)?;
/// let cubic = pforms_operators::elevate(&parabola, &[1])?;
/// assert_eq!(cubic.points()?, [0., 2., 2., 0.]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn elevate<S: Scalar>(form: &Form<S>, by: &[usize]) -> Result<Form<S>> {
    form.require_per_axis("by", by)?;
    let orders: Vec<usize> =
        form.orders().iter().zip(by).map(|(order, more)| order.saturating_add(*more)).collect();
    limit::check::<S>("the elevated form", &orders, form.width())?;
    let axes = (0..form.axes()).filter(|&axis| by[axis] > 0);
    act_along(
        form,
        axes,
        |axis| (form.orders()[axis] - 1, by[axis]),
        |&(degree, more)| elevation_matrix(degree, more),
    )
}

/// The matrix that raises a degree by `by`: `degree + by + 1` rows, `degree + 1` columns.
///
/// Errors: `Limit` when it is larger than the cap, `Accuracy` where binomials overflow.
pub fn elevation_matrix<S: Scalar>(degree: usize, by: usize) -> Result<Matrix<S>> {
    let raised = degree.saturating_add(by);
    limit::check::<S>("the elevation matrix", &[raised, degree + 1], 1)?;
    limit::check_degree::<S>(raised)?;
    let row = Binomials::<S>::of;
    let (old, gap, new) = (row(degree), row(by), row(raised));
    Ok(Matrix::from_writer(raised + 1, degree + 1, |i, entries| {
        let whole = new.get(i);
        let first = i.saturating_sub(by);
        for (j, entry) in entries.iter_mut().enumerate().take(i + 1).skip(first) {
            *entry = old.get(j) * gap.get(i - j) / whole.clone();
        }
    }))
}

/// The form raised to the given orders, none of which may be below its own.
///
/// Errors: `Shape` when one is, or unless there is one order for each axis; `Limit`.
pub fn raise_to<S: Scalar>(form: &Form<S>, orders: &[usize]) -> Result<Form<S>> {
    form.require_per_axis("orders", orders)?;
    let by: Option<Vec<usize>> =
        orders.iter().zip(form.orders()).map(|(to, from)| to.checked_sub(*from)).collect();
    let by = by.ok_or_else(|| {
        Error::shape("orders", format!("{orders:?}"), format!("at least {:?}", form.orders()))
    })?;
    elevate(form, &by)
}

/// The forms, each raised to the largest order that occurs along each axis.
///
/// Errors: `Shape` when they differ in their number of axes or in their space, or there is none.
pub fn raise_together<S: Scalar>(forms: &[&Form<S>]) -> Result<Vec<Form<S>>> {
    let Some(first) = forms.first() else {
        return Err(Error::shape("forms", "none", "at least one form"));
    };
    let mut orders = first.orders().to_vec();
    for (index, form) in forms.iter().enumerate() {
        if form.axes() != first.axes() || form.ambient() != first.ambient() {
            return Err(Error::shape(
                "forms",
                format!("a {} in {}D as form {index}", form.kind(), form.ambient()),
                format!(
                    "forms with {} axes in {}D like the first, a {}",
                    first.axes(),
                    first.ambient(),
                    first.kind()
                ),
            ));
        }
        for (largest, order) in orders.iter_mut().zip(form.orders()) {
            *largest = (*largest).max(*order);
        }
    }
    forms.iter().map(|form| raise_to(form, &orders)).collect()
}
