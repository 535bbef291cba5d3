//! Forms brought to a size where no product overflows or vanishes.

use pforms_kernel::{Error, Form, Result};

use super::guarded::Guarded;

/// The exponent of the largest coordinate: 2 to it is a good unit of length.
///
/// Errors: `Domain` when all weights are 0.
pub(crate) fn unit_of(net: &Form) -> Result<i32> {
    let width = net.width();
    let poles = net.homogeneous().chunks_exact(width);
    let weight = poles.clone().fold(0.0_f64, |most, pole| most.max(pole[width - 1].abs()));
    let reach =
        poles.flat_map(|pole| &pole[..width - 1]).fold(0.0_f64, |most, x| most.max(x.abs()));
    if weight == 0.0 {
        return Err(Error::domain("form", "a form at infinity", "a weight that is not 0"));
    }
    Ok(exponent(reach) - exponent(weight))
}

fn exponent(x: f64) -> i32 {
    if x > 0.0 { (x.to_bits() >> 52) as i32 - 1023 } else { 0 }
}

/// `x·2^exponent`, in two steps: 2 to the power of all of it may overflow.
pub(crate) fn shifted(x: f64, exponent: i32) -> f64 {
    let half = exponent / 2;
    x * 2.0_f64.powi(half) * 2.0_f64.powi(exponent - half)
}

/// The same form with the largest weight between 1 and 2.
pub(crate) fn with_weights_about_one(form: &Form) -> Result<Form> {
    let weights = form.weights();
    let largest = weights.iter().fold(0.0_f64, |a, w| if w.abs() > a.abs() { *w } else { a });
    let down = -exponent(largest.abs());
    form.map_scalar(|x| shifted(*x, down) * largest.signum())
}

/// The form seen from its heaviest pole, in units of `2^unit`, in numbers that know what the
/// subtraction cost.
///
/// Errors: `Domain` when all its weights are 0.
pub(crate) fn seen_locally(form: &Form, unit: i32) -> Result<Form<Guarded>> {
    let width = form.width();
    let poles = form.homogeneous();
    let heaviest = poles.chunks_exact(width).fold(&poles[..width], |best, pole| {
        if pole[width - 1].abs() > best[width - 1].abs() { pole } else { best }
    });
    let weight = heaviest[width - 1];
    let seen = poles.chunks_exact(width).flat_map(|pole| {
        let w = pole[width - 1];
        let origin = |k: usize| Guarded::from(shifted(heaviest[k], -unit) / weight * w);
        let from = |k: usize| Guarded::from(shifted(pole[k], -unit)) - origin(k);
        (0..width - 1).map(from).chain([Guarded::from(w)]).collect::<Vec<_>>()
    });
    Form::from_homogeneous(form.orders(), form.ambient(), seen.collect())
}
