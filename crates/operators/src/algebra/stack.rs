//! The primitive gesture: the middle of forms, and the form that generates it.

use pforms_kernel::{Form, Result, Scalar};

use super::{raise_together, sub};

/// The form *generated* by `n` forms (the book's MIR): a new axis 0 of order `n`.
///
/// Points make a curve, curves a surface, surfaces a volume, and so on. Orders that differ are
/// raised to the largest first. Exact: the given forms are the poles along the new axis.
///
/// Errors: `Shape` when the forms differ in axes or space, or there is none; `Limit`. Book 11–13.
///
/// ```
/// use pforms_kernel::Form;
/// let [p, q]: [Form; 2] = [Form::point(&[0., 0.])?, Form::point(&[1., 2.])?];
/// assert_eq!(pforms_operators::stack(&[&p, &q])?.kind().to_string(), "pL2");
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn stack<S: Scalar>(forms: &[&Form<S>]) -> Result<Form<S>> {
    let raised = raise_together(forms)?;
    let mut orders = vec![raised.len()];
    orders.extend_from_slice(raised[0].orders());
    let ambient = raised[0].ambient();
    let poles = raised.iter().flat_map(|form| form.homogeneous().to_vec());
    Form::from_homogeneous(&orders, ambient, poles.collect())
}

/// The forms that generate this one along axis 0: [`stack`] undone, to the bit.
///
/// So the net of a form with one axis more can hold many forms of the same orders, and an operator
/// that leaves axis 0 alone acts on all of them at once.
///
/// Errors: `Shape` for a point.
///
/// ```
/// use pforms_kernel::Form;
/// let segment: Form = Form::from_points(&[2], 2, &[0., 0., 1., 2.], None)?;
/// let [p, q] = &pforms_operators::unstack(&segment)?[..] else { panic!("two points") };
/// assert_eq!(pforms_operators::stack(&[p, q])?, segment);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn unstack<S: Scalar>(form: &Form<S>) -> Result<Vec<Form<S>>> {
    form.require_axis(0)?;
    let (orders, ambient) = (&form.orders()[1..], form.ambient());
    let nets = form.homogeneous().chunks_exact(form.homogeneous().len() / form.orders()[0]);
    nets.map(|net| Form::from_homogeneous(orders, ambient, net.to_vec())).collect()
}

/// The middle of `n` forms (the book's MI): `Σ C(n−1, i)·fᵢ / 2ⁿ⁻¹`.
///
/// By definition the sub-form at ½ of their [`stack`]. The coefficients are dyadic, so in `f64`
/// two forms of equal orders have their exact middle, rounded once.
///
/// Errors: as [`stack`].
///
/// ```
/// use pforms_kernel::Form;
/// let [p, q]: [Form; 2] = [Form::point(&[0., 0.])?, Form::point(&[1., 2.])?];
/// assert_eq!(pforms_operators::midpoint(&[&p, &q])?.points()?, [0.5, 1.0]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn midpoint<S: Scalar>(forms: &[&Form<S>]) -> Result<Form<S>> {
    sub(&stack(forms)?, 0, &S::ratio(1, 2))
}
