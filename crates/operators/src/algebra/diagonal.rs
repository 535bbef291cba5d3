//! Diagonalisation: two parameters become one.
//!
//! `q_k = Σ_{i+j=k} C(m−1,i)·C(n−1,j)/C(m+n−2,k) · p_ij` (book 12 and 13): in the scaled Bernstein
//! basis, plain sums along the antidiagonals.

use pforms_kernel::{Error, Form, Result, Scalar, Scaled};

/// The form on the diagonal of axes `first` and `second`: orders `m` and `n` give `m + n − 1`.
///
/// The new axis stands where the lower of the two stood. In `f64` every pole is a mean of old
/// ones with positive weights, within `order + 5` roundings of the exact one.
///
/// Errors: `Shape` when the axes are the same or not there; `Limit`.
///
/// ```
/// use pforms_kernel::Form;
/// let facet: Form = Form::from_points(&[2, 2], 1, &[0., 1., 3., 4.], None)?;
/// assert_eq!(pforms_operators::diagonal(&facet, 0, 1)?.points()?, [0., 2., 4.]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn diagonal<S: Scalar>(form: &Form<S>, first: usize, second: usize) -> Result<Form<S>> {
    require_two_axes(form)?;
    if first == second {
        return Err(Error::shape("axes", format!("({first}, {second})"), "two different axes"));
    }
    form.require_axis(first)?;
    form.require_axis(second)?;
    let (low, high) = (first.min(second), first.max(second));
    let merged = Scaled::from_form(form).merged(low, high).into_form()?;
    Ok(match form.uniform_weight() {
        Some(weight) => merged.with_uniform_weight(weight),
        None => merged,
    })
}

/// The curve on the diagonal of all axes: the last two are merged until one is left.
///
/// Errors: as [`diagonal`]; a form of fewer than two axes has no diagonal.
pub fn diagonal_all<S: Scalar>(form: &Form<S>) -> Result<Form<S>> {
    require_two_axes(form)?;
    let mut curve = form.clone();
    while curve.axes() > 1 {
        curve = diagonal(&curve, curve.axes() - 2, curve.axes() - 1)?;
    }
    Ok(curve)
}

fn require_two_axes<S: Scalar>(form: &Form<S>) -> Result<()> {
    if form.axes() >= 2 {
        return Ok(());
    }
    Err(Error::shape("form", format!("a {}", form.kind()), "a form with at least two axes"))
}
