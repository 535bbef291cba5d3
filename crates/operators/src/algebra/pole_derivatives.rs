//! How a point of a form follows its poles.

use pforms_kernel::{Error, Form, Result, Scalar, bernstein_row};

use super::{Poles, Shape, Spline};

/// How the point at `parameters` follows each pole that it depends on: the index of the pole in the
/// net and the factor by which every coordinate of the pole moves that of the point, in ascending
/// order of the poles.
///
/// These are the rational basis functions `w_i·B_i/W`, or `B_i/W` for a direction (a pole of weight
/// 0), whose coordinates count as they are stored. Weights do not move. Exact in every scalar.
///
/// Errors: `Shape` unless there is one parameter for each axis; `Domain` where the weight vanishes
/// or a parameter is not finite.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::pole_derivatives;
/// let parabola: Form = Form::from_points(&[3], 2, &[0., 0., 1., 2., 2., 0.], None)?;
/// let row = pole_derivatives(&parabola.into(), &[0.5])?;
/// assert_eq!(row, [(0, 0.25), (1, 0.5), (2, 0.25)]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn pole_derivatives<S: Scalar>(shape: &Shape<S>, parameters: &[S]) -> Result<Vec<(usize, S)>> {
    let net = shape.net();
    net.require_per_axis("parameters", parameters)?;
    if let Some(t) = parameters.iter().find(|t| !t.is_finite()) {
        return Err(Error::domain("parameters", format!("{t:?}"), "finite numbers"));
    }
    let rows = match shape {
        Shape::Form(form) => rows_of_form(form, parameters),
        Shape::Spline(spline) => rows_of_spline(spline, parameters),
    };
    let mut row = vec![(0, S::one())];
    for ((first, factors), order) in rows.iter().zip(net.orders()) {
        let product = |(place, value): &(usize, S)| -> Vec<(usize, S)> {
            let (place, value) = (place * order + first, value.clone());
            let factors = factors.iter().enumerate();
            factors.map(|(i, factor)| (place + i, value.clone() * factor.clone())).collect()
        };
        row = row.iter().flat_map(product).collect();
    }
    if net.uniform_weight().is_some_and(|weight| !weight.is_zero()) {
        return Ok(row);
    }
    weighted(net, row)
}

/// Over the weight of the point, and times those of the poles.
fn weighted<S: Scalar>(net: &Form<S>, mut row: Vec<(usize, S)>) -> Result<Vec<(usize, S)>> {
    let (width, ambient) = (net.width(), net.ambient());
    let weight = |place: usize| &net.homogeneous()[place * width + ambient];
    let mut sum = S::zero();
    for (place, factor) in &row {
        sum += factor.clone() * weight(*place).clone();
    }
    if sum.is_zero() {
        let received = "a point where the weight vanishes";
        return Err(Error::domain("parameters", received, "parameters where the form is finite"));
    }
    for (place, factor) in &mut row {
        let own = weight(*place);
        let share = if own.is_zero() { S::one() } else { own.clone() };
        *factor = factor.clone() * share / sum.clone();
    }
    if row.iter().all(|(_, factor)| factor.is_finite()) {
        return Ok(row);
    }
    let received = "a point beyond the largest floating number";
    Err(Error::domain("parameters", received, "parameters where the form is finite"))
}

/// The first pole that counts along each axis, and the factors from there on.
fn rows_of_form<S: Scalar>(form: &Form<S>, parameters: &[S]) -> Vec<(usize, Vec<S>)> {
    let pairs = form.orders().iter().zip(parameters);
    pairs.map(|(order, t)| (0, bernstein_row(order - 1, t))).collect()
}

fn rows_of_spline<S: Scalar>(spline: &Spline<S>, parameters: &[S]) -> Vec<(usize, Vec<S>)> {
    spline.knots().iter().zip(parameters).map(|(knots, t)| knots.basis(t)).collect()
}
