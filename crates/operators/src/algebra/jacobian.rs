//! The Jacobian determinant as a form.

use pforms_kernel::{Error, Form, Result, Scalar, Scaled};

use super::minors::tangent_minors;
use super::{Shape, Spline};

/// The determinant of the derivatives of a form with as many axes as coordinates, a form in dimension 1.
///
/// Exact. A polynomial form with `d` axes of degrees `n` gives degrees `d·n − 1`. A rational one, `X/W`,
/// gives `N/W^(d+1)`, whose numerator has degrees `(d+1)·n − 2` and is raised to those of the
/// denominator, `(d+1)·n`: the determinant of the rows `(X, W)` and their derivatives, of which the
/// highest term cancels (Goldman, *Illicit expressions in vector algebra*, 1985, for one axis).
///
/// Errors: `Shape` with other numbers of axes; `Degenerate` when the form is at infinity; `Limit`.
///
/// ```
/// use pforms_kernel::Form;
/// // (u·v, v): the determinant is v.
/// let form: Form = Form::from_points(&[2, 2], 2, &[0., 0., 0., 1., 0., 0., 1., 1.], None)?;
/// assert_eq!(pforms_operators::jacobian(&form)?.points()?, [0., 1., 0., 1.]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn jacobian<S: Scalar>(form: &Form<S>) -> Result<Form<S>> {
    require_square(form.axes(), form.ambient(), form)?;
    let minors = tangent_minors(form)?;
    if minors.power == 0 {
        return minors.into_vectors();
    }
    let weight = Scaled::from_form(form).component(form.ambient());
    let mut below = weight.clone();
    for _ in 1..minors.power {
        below = below.times(&weight)?;
    }
    minors.numerators.raised_to(below.degrees())?.beside(&below).into_form()
}

/// The same of a form or a spline: that of each piece, over its own part of the window.
///
/// At knots where the derivatives may jump the determinant may do so too: the spline has a gap there.
///
/// Errors: as [`jacobian`].
pub fn jacobian_shape<S: Scalar>(shape: &Shape<S>) -> Result<Shape<S>> {
    let spline = match shape {
        Shape::Form(form) => return jacobian(form).map(Shape::Form),
        Shape::Spline(spline) => spline,
    };
    require_square(spline.axes(), spline.ambient(), spline.net())?;
    let parted: Spline<S> = spline.parted_by(&vec![1; spline.axes()])?;
    let determinants = parted.map_pieces(|piece, window| {
        let stretch =
            window.iter().fold(S::one(), |all, (from, to)| all / (to.clone() - from.clone()));
        let form = jacobian(piece)?;
        let mut poles = form.homogeneous().to_vec();
        for pole in poles.chunks_exact_mut(2) {
            pole[0] = pole[0].clone() * stretch.clone();
        }
        Form::from_homogeneous(form.orders(), 1, poles)
    })?;
    Ok(determinants.into())
}

pub(crate) fn require_square<S: Scalar>(axes: usize, ambient: usize, net: &Form<S>) -> Result<()> {
    if axes == ambient {
        return Ok(());
    }
    Err(Error::shape(
        "form",
        format!("a {} in dimension {ambient}", net.kind()),
        "as many axes as coordinates: a surface in the plane, a volume in space",
    ))
}
