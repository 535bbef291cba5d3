//! Forms scaled by a power of two, so that squares of their coordinates neither over- nor underflow.

use pforms_kernel::{Form, Result};

use crate::algebra::Spline;

/// The power of two next below the largest coordinate of all poles; 1 if there is none.
pub(crate) fn unit<'a>(forms: impl IntoIterator<Item = &'a Form>) -> f64 {
    let mut size = 0.0_f64;
    for form in forms {
        let width = form.width();
        for pole in form.homogeneous().chunks_exact(width) {
            let weight = pole[width - 1].abs();
            let largest = pole[..width - 1].iter().fold(0.0_f64, |most, x| most.max(x.abs()));
            size = size.max(if weight > 0.0 { largest / weight } else { largest });
        }
    }
    if size == 0.0 {
        return 1.0;
    }
    libm::ldexp(1.0, libm::ilogb(size).clamp(-1000, 1000))
}

/// The form with coordinates divided by a power of two.
pub(crate) fn in_units(form: &Form, unit: f64) -> Result<Form> {
    let width = form.width();
    let mut poles = form.homogeneous().to_vec();
    for pole in poles.chunks_exact_mut(width) {
        pole[..width - 1].iter_mut().for_each(|x| *x /= unit);
    }
    Form::from_homogeneous(form.orders(), form.ambient(), poles)
}

/// The same for a spline.
pub(super) fn spline_in_units(spline: &Spline, unit: f64) -> Result<Spline> {
    Spline::on(in_units(spline.net(), unit)?, spline.knots().to_vec())
}
