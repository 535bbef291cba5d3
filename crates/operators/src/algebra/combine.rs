//! Homogeneous combinations of forms.

use pforms_kernel::{Error, Form, Result, Scalar};

use super::raise_together;

/// `Σ kᵢ·fᵢ` on the homogeneous poles, orders raised as needed.
///
/// `Σk = 1` gives points from points, `Σk = 0` gives directions (weight 0). A point (a form
/// without axes) combines with forms of any axes: it is the same everywhere.
///
/// Errors: `Shape` when the counts, the axes or the spaces differ; `Domain` when a `k` is not finite.
///
/// ```
/// use pforms_kernel::Form;
/// let [p, q]: [Form; 2] = [Form::point(&[0., 0.])?, Form::point(&[1., 2.])?];
/// let mirrored = pforms_operators::combine(&[2.0, -1.0], &[&p, &q])?;
/// assert_eq!(mirrored.points()?, [-1., -2.]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn combine<S: Scalar>(k: &[S], forms: &[&Form<S>]) -> Result<Form<S>> {
    if k.len() != forms.len() {
        return Err(Error::shape(
            "k",
            format!("{} numbers", k.len()),
            format!("{}, one for each form", forms.len()),
        ));
    }
    if let Some(bad) = k.iter().find(|factor| !factor.is_finite()) {
        return Err(Error::domain("k", format!("{bad:?}"), "finite numbers"));
    }
    let axes = forms.iter().map(|form| form.axes()).max().unwrap_or(0);
    let spread: Vec<Form<S>> = forms
        .iter()
        .map(|form| match form.axes() {
            0 => form.reshape(&vec![1; axes]),
            _ => Ok((*form).clone()),
        })
        .collect::<Result<_>>()?;
    let raised = raise_together(&spread.iter().collect::<Vec<_>>())?;
    let first = &raised[0];
    let mut sum = vec![S::zero(); first.homogeneous().len()];
    for (factor, form) in k.iter().zip(&raised) {
        S::add_multiple(&mut sum, factor, form.homogeneous());
    }
    Form::from_homogeneous(first.orders(), first.ambient(), sum)
}
