//! Derivatives that are forms: hodographs, and the exact quotients of rational forms.

use pforms_kernel::{Form, Result, Scalar, Scaled};

/// The derivative `∂^orders` of a form, as a form whose points are the derivative vectors.
///
/// A polynomial form of degree `d` gives degree `d − r`. A rational form `X/W` gives the exact
/// quotient: numerators `N_{k+1} = N_k'·W − k·N_k·W'` over `W^{k+1}`, so the degree grows to
/// `(r + 1)·d` for a derivative of total order `r`. Exact; Farin, sections 5.3 and 13.5.
///
/// Errors: `Shape` unless there is one order for each axis; `Limit`.
///
/// ```
/// use pforms_kernel::Form;
/// let cubic: Form = Form::from_points(&[4], 1, &[0., 0., 0., 1.], None)?; // t³
/// assert_eq!(pforms_operators::derivative(&cubic, &[2])?.points()?, [0., 6.]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn derivative<S: Scalar>(form: &Form<S>, orders: &[usize]) -> Result<Form<S>> {
    form.require_per_axis("orders", orders)?;
    let steps: Vec<usize> = orders
        .iter()
        .enumerate()
        .flat_map(|(axis, &order)| std::iter::repeat_n(axis, order.min(order_cap(form, axis))))
        .collect();
    if steps.is_empty() {
        return Ok(form.clone());
    }
    let all = Scaled::from_form(form);
    match form.uniform_weight() {
        Some(weight) => polynomial(&all, &steps, weight),
        None => rational(&all, &steps),
    }
}

/// The hodograph: the first derivative along `axis`, as a form.
///
/// Errors: `Shape` when there is no such axis; `Limit`.
pub fn hodograph<S: Scalar>(form: &Form<S>, axis: usize) -> Result<Form<S>> {
    form.require_axis(axis)?;
    let mut orders = vec![0; form.axes()];
    orders[axis] = 1;
    derivative(form, &orders)
}

/// A polynomial vanishes after as many derivatives as it has poles: more change nothing.
fn order_cap<S: Scalar>(form: &Form<S>, axis: usize) -> usize {
    if form.is_rational() { usize::MAX } else { form.orders()[axis] }
}

fn polynomial<S: Scalar>(all: &Scaled<S>, steps: &[usize], weight: &S) -> Result<Form<S>> {
    let derived = steps.iter().fold(all.clone(), |form, &axis| form.derivative(axis));
    Ok(derived.into_form()?.with_uniform_weight(weight))
}

fn rational<S: Scalar>(all: &Scaled<S>, steps: &[usize]) -> Result<Form<S>> {
    let ambient = all.width() - 1;
    let weight = all.component(ambient);
    let mut numerator = all.truncated(ambient);
    let mut denominator = weight.clone();
    for (index, &axis) in steps.iter().enumerate() {
        let power = S::from_integer(index as i64 + 1);
        let mut next = numerator.derivative(axis).times(&weight)?;
        let slope = numerator.times(&weight.derivative(axis))?;
        next.add_multiple(&-power, &slope);
        denominator = denominator.times(&weight)?;
        numerator = next.raised_to(denominator.degrees())?;
    }
    numerator.beside(&denominator).into_form()
}
