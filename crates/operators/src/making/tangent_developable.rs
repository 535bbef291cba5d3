//! The surface of the tangents of a curve (book, section 326, where it is left as an exercise).

use pforms_kernel::{Error, Form, Result, Scalar, Scaled};

use crate::measuring::guarded::{Guarded, significant};
use crate::{Spline, hodograph, raise_to, stack, tangent_form};

/// The surface `c(v) + u·length·c′(v)`: axis 0 along the tangents, axis 1 along the curve.
///
/// The tangents have their natural length, that of the derivative, so the surface is a form again:
/// a pS2n of a polynomial pLn, as the book says, and of a rational one a pS2(2n−1), since the
/// derivative of `X/W` has the denominator `W²`. Exact in every scalar. It is developable; the curve
/// is its edge of regression, where it has no normal of its own. Any dimension from 2 on.
///
/// Errors: `Degenerate` for a straight curve, whose tangents are all one line, and for the length 0;
/// `Shape` unless it is a curve in dimension 2 or more; `Limit`.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{is_developable, tangent_developable};
/// let cubic: Form =
///     Form::from_points(&[4], 3, &[0., 0., 0., 1., 0., 0., 2., 1., 0., 3., 3., 1.], None)?;
/// let surface = tangent_developable(&cubic, &1.0)?;
/// assert_eq!(surface.kind().to_string(), "pS24");
/// assert!(is_developable(surface)?.exact);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn tangent_developable<S: Scalar>(curve: &Form<S>, length: &S) -> Result<Form<S>> {
    require_curve(curve.axes(), curve.ambient(), length)?;
    if is_straight(curve)? {
        return Err(straight());
    }
    tangents(curve, length)
}

/// The [`tangent_developable`] of a spline, with derivatives by its own parameter. Where the tangent
/// turns at a knot the surface has a gap.
///
/// Errors: as there; a spline may have straight pieces, but not all of them.
pub fn tangent_developable_of_spline<S: Scalar>(
    curve: &Spline<S>,
    length: &S,
) -> Result<Spline<S>> {
    require_curve(curve.axes(), curve.ambient(), length)?;
    let breaks = curve.breaks().swap_remove(0);
    let (mut forms, mut bent) = (Vec::new(), false);
    for (index, ends) in breaks.windows(2).enumerate() {
        let piece = curve.piece(&[index])?;
        bent |= !is_straight(&piece)?;
        forms.push(tangents(&piece, &(length.clone() / (ends[1].clone() - ends[0].clone())))?);
    }
    if !bent {
        return Err(straight());
    }
    Spline::end_to_end(&forms, 1, &breaks)
}

/// The curve and the tips of its tangents, over one denominator.
fn tangents<S: Scalar>(curve: &Form<S>, length: &S) -> Result<Form<S>> {
    let tangent = hodograph(curve, 0)?;
    let start = if curve.is_rational() { over_square(curve)? } else { curve.clone() };
    let tangent = raise_to(&tangent, start.orders())?;
    let width = start.width();
    let mut tip = start.homogeneous().to_vec();
    for (pole, step) in tip.chunks_exact_mut(width).zip(tangent.homogeneous().chunks_exact(width)) {
        S::add_multiple(&mut pole[..width - 1], length, &step[..width - 1]);
    }
    stack(&[&start, &Form::from_homogeneous(start.orders(), start.ambient(), tip)?])
}

/// `X·W / W²`.
fn over_square<S: Scalar>(curve: &Form<S>) -> Result<Form<S>> {
    let all = Scaled::from_form(curve);
    all.times(&all.component(curve.ambient()))?.into_form()
}

/// Is the curve on one line: are all its tangents along one vector?
fn is_straight<S: Scalar>(curve: &Form<S>) -> Result<bool> {
    if S::EXACT {
        return turns(curve).map(|minors| minors.iter().all(Scalar::is_zero));
    }
    let floating = curve.map_scalar(Scalar::to_f64)?;
    let unit = crate::measuring::about_one::unit_of(&floating)?;
    let floating = crate::measuring::about_one::with_weights_about_one(&floating)?;
    let local = crate::measuring::about_one::seen_locally(&floating, unit)?;
    Ok(!significant(&turns::<Guarded>(&local)?))
}

/// The coefficients of all `T_i·T_j′ − T_j·T_i′`, with `T` along the tangent.
fn turns<S: Scalar>(curve: &Form<S>) -> Result<Vec<S>> {
    let tangent = Scaled::from_form(&tangent_form(curve, 0)?);
    let slope = tangent.derivative(0);
    let mut minors = Vec::new();
    for i in 0..curve.ambient() {
        for j in 0..i {
            let product = tangent.component(i).times(&slope.component(j))?;
            let other = tangent.component(j).times(&slope.component(i))?;
            minors.extend_from_slice(product.minus(&other).coefficients());
        }
    }
    Ok(minors)
}

fn require_curve<S: Scalar>(axes: usize, ambient: usize, length: &S) -> Result<()> {
    if axes != 1 || ambient < 2 {
        return Err(Error::shape(
            "curve",
            format!("a form of {axes} axes in dimension {ambient}"),
            "a curve in dimension 2 or more",
        ));
    }
    if !length.is_finite() {
        return Err(Error::domain("length", format!("{length:?}"), "a finite number"));
    }
    if length.is_zero() {
        return Err(Error::degenerate("length", 0, "a length other than 0"));
    }
    Ok(())
}

fn straight() -> Error {
    Error::degenerate(
        "curve",
        "a straight line",
        "a curve that bends: the tangents of a line are one",
    )
}
