//! The polar form.

use pforms_kernel::{Error, Form, Result, Scalar, blossom_row};

/// The blossom (polar form) of a form: for each axis as many arguments as its degree.
///
/// Symmetric and affine in each argument; with all arguments equal it is the point. Returns the
/// homogeneous point, `ambient + 1` numbers. Any reals. Ramshaw, *Blossoming*, 1987.
///
/// Errors: `Shape` when the number of arguments is not the degree, `Domain` when not finite.
///
/// ```
/// use pforms_kernel::Form;
/// let parabola: Form = Form::from_points(&[3], 1, &[0., 1., 4.], None)?;
/// assert_eq!(pforms_operators::blossom(&parabola, &[&[0.0, 1.0]])?, [1.0, 1.0]); // a pole
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn blossom<S: Scalar>(form: &Form<S>, arguments: &[&[S]]) -> Result<Vec<S>> {
    form.require_per_axis("arguments", arguments)?;
    let mut result = form.clone();
    for (axis, list) in arguments.iter().enumerate() {
        let degree = form.orders()[axis] - 1;
        if list.len() != degree {
            return Err(Error::shape(
                "arguments",
                format!("{} on axis {axis}", list.len()),
                format!("{degree}, the degree"),
            ));
        }
        if let Some(bad) = list.iter().find(|t| !t.is_finite()) {
            return Err(Error::domain("arguments", format!("{bad:?}"), "finite numbers"));
        }
        result = result.contract(0, &blossom_row(list))?;
    }
    Ok(result.homogeneous().to_vec())
}
