//! Homogeneous combinations of forms.

use pforms_kernel::{Error, Form, Result, Scalar};

use super::pointwise::combine_spline_points;
use super::{Poles, Shape, Spline, combine_pointwise, raise_together};

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
    require_coefficients(k, forms.len())?;
    let spread = spread(forms)?;
    let raised = raise_together(&spread.iter().collect::<Vec<_>>())?;
    let first = &raised[0];
    let mut sum = vec![S::zero(); first.homogeneous().len()];
    for (factor, form) in k.iter().zip(&raised) {
        S::add_multiple(&mut sum, factor, form.homogeneous());
    }
    Form::from_homogeneous(first.orders(), first.ambient(), sum)
}

/// [`combine`] of forms and splines: with a spline among them, on their common knots.
///
/// With `pointwise` the points are combined in place of the poles, see [`combine_pointwise`].
///
/// Errors: as [`combine`]; `Shape` when the windows of splines differ.
pub fn combine_shapes<S: Scalar>(
    k: &[S],
    shapes: &[Shape<S>],
    pointwise: bool,
) -> Result<Shape<S>> {
    let splines = shapes.iter().find_map(|shape| match shape {
        Shape::Spline(spline) => Some(spline),
        Shape::Form(_) => None,
    });
    let Some(first) = splines else {
        let forms: Vec<&Form<S>> = shapes.iter().map(Poles::net).collect();
        let combined = if pointwise { combine_pointwise } else { combine };
        return Ok(combined(k, &forms)?.into());
    };
    require_coefficients(k, shapes.len())?;
    let together = if shapes.iter().all(|shape| fits(shape, first)) && !pointwise {
        None
    } else {
        let all =
            shapes.iter().map(|shape| on_window_of(shape, first)).collect::<Result<Vec<_>>>()?;
        if pointwise {
            return Ok(combine_spline_points(k, &all)?.into());
        }
        Some(Spline::on_common_knots(&all)?)
    };
    let (nets, result): (Vec<&Form<S>>, _) = match &together {
        None => (shapes.iter().map(Poles::net).collect(), first),
        Some(common) => (common.iter().map(Spline::net).collect(), &common[0]),
    };
    Ok(result.with_net(combine(k, &nets)?)?.into())
}

/// May the poles be combined as they are? Those of a point count for all.
fn fits<S: Scalar>(shape: &Shape<S>, spline: &Spline<S>) -> bool {
    match shape {
        Shape::Form(form) => form.axes() == 0,
        Shape::Spline(other) => other.knots() == spline.knots(),
    }
}

/// A spline as it is; a point as the spline that is the same everywhere.
pub(super) fn on_window_of<S: Scalar>(shape: &Shape<S>, first: &Spline<S>) -> Result<Spline<S>> {
    let Shape::Form(point) = shape else { return Ok(shape.clone().into_spline()) };
    if point.axes() > 0 {
        return Ok(point.clone().into());
    }
    let ends = |axis| first.window(axis).map(|(from, to)| vec![from, to]);
    let breaks = (0..first.axes()).map(ends).collect::<Result<Vec<_>>>()?;
    Spline::joined(point.reshape(&vec![1; first.axes()])?, &vec![0; first.axes()], &breaks)
}

/// Complains unless there is a finite number for each form.
pub(super) fn require_coefficients<S: Scalar>(k: &[S], forms: usize) -> Result<()> {
    if k.len() != forms {
        return Err(Error::shape(
            "k",
            format!("{} numbers", k.len()),
            format!("{forms}, one for each form"),
        ));
    }
    match k.iter().find(|factor| !factor.is_finite()) {
        Some(bad) => Err(Error::domain("k", format!("{bad:?}"), "finite numbers")),
        None => Ok(()),
    }
}

/// The forms, points with as many axes as the others have.
pub(super) fn spread<S: Scalar>(forms: &[&Form<S>]) -> Result<Vec<Form<S>>> {
    let axes = forms.iter().map(|form| form.axes()).max().unwrap_or(0);
    let spread = forms.iter().map(|form| match form.axes() {
        0 => form.reshape(&vec![1; axes]),
        _ => Ok((*form).clone()),
    });
    spread.collect()
}
