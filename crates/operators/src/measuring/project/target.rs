//! The form as projection works on it: at the origin, of size about one, no axis without extent.

use pforms_kernel::{Error, Form, Result, limit};

use super::weight::{Weights, positive_weights};

/// Points farther than this many sizes of the form are refused: their squares would overflow.
const FARTHEST: f64 = 1e120;

/// A form moved to the origin and scaled by a power of two, its weights at most 1.
pub(super) struct Target {
    /// The form, along its live axes only.
    pub form: Form,
    /// Those with more than one pole; along the others nothing changes.
    pub live: Vec<usize>,
    /// Largest side of its box.
    pub extent: f64,
    /// No weight in the window is less.
    pub least_weight: f64,
    centre: Vec<f64>,
    scale: f64,
    noise: f64,
}

impl Target {
    /// Errors: `Domain` when the weight vanishes in the window or a pole overflows; `Accuracy` when
    /// the squares of distances are of too high a degree.
    pub(super) fn new(form: &Form) -> Result<Self> {
        form.degrees().iter().try_for_each(|degree| limit::check_degree::<f64>(2 * degree))?;
        let Weights { sign, least, largest, lower, upper } = positive_weights(form)?;
        let centre: Vec<f64> = lower.iter().zip(&upper).map(|(a, b)| a / 2.0 + b / 2.0).collect();
        let halves = lower.iter().zip(&upper).map(|(a, b)| b / 2.0 - a / 2.0);
        let half = halves.fold(0.0, f64::max);
        let away = centre.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let scale = binade(if half > 0.0 { half } else { away });
        let axes = form.axes();
        let live = (0..axes).filter(|axis| form.orders()[*axis] > 1).collect::<Vec<_>>();
        let orders: Vec<usize> = live.iter().map(|axis| form.orders()[*axis]).collect();
        // An equal weight becomes exactly 1, which is left out of sums.
        let unit = if form.is_rational() { binade(largest) } else { largest };
        let mut poles = Vec::with_capacity(form.homogeneous().len());
        for pole in form.homogeneous().chunks_exact(form.width()) {
            normalise(pole, &centre, scale, sign * unit, &mut poles);
        }
        let form = Form::from_homogeneous(&orders, form.ambient(), poles)?;
        let least_weight = least / unit;
        let amplified = amplification(&form, least_weight);
        let degrees: usize = form.degrees().iter().sum();
        let roundings = (2 * degrees + axes + 8) as f64;
        let noise = roundings * f64::EPSILON * amplified * (1.0 + away / scale);
        let extent = 2.0 * half / scale;
        Ok(Self { form, live, extent, least_weight, centre, scale, noise })
    }

    /// A point in the coordinates of the target.
    ///
    /// Errors: `Domain` when it is not finite or out of reach.
    pub(super) fn place(&self, point: &[f64], placed: &mut [f64]) -> Result<()> {
        for ((to, x), centre) in placed.iter_mut().zip(point).zip(&self.centre) {
            *to = (x - centre) / self.scale;
            if !x.is_finite() {
                return Err(Error::domain("points", x, "finite coordinates"));
            }
            if to.abs().is_nan() || to.abs() > FARTHEST {
                let expected = format!("points within {FARTHEST:e} times the size of the form");
                return Err(Error::domain("points", x, expected));
            }
        }
        Ok(())
    }

    /// A length of the target as one of the form.
    pub(super) fn length(&self, placed: f64) -> f64 {
        placed * self.scale
    }

    /// What rounding may do to a distance from this point.
    pub(super) fn noise_at(&self, placed: &[f64]) -> f64 {
        self.noise * (1.0 + placed.iter().fold(0.0_f64, |most, x| most.max(x.abs())))
    }

    /// [`Target::noise_at`] for a point within the unit cube.
    pub(super) fn noise(&self) -> f64 {
        self.noise
    }
}

/// `(X − centre·w) / scale` and the weight, in units of `unit`. A pole that is a point is divided
/// first, so that what is far away and small keeps its digits.
fn normalise(pole: &[f64], centre: &[f64], scale: f64, unit: f64, into: &mut Vec<f64>) {
    let weight = pole[centre.len()];
    let share = weight / unit;
    for (x, centre) in pole.iter().zip(centre) {
        into.push(if weight * unit > 0.0 {
            (x / weight - centre) / scale * share
        } else {
            (x / unit - centre * share) / scale
        });
    }
    into.push(share);
}

/// The largest pole in units of the least weight: 1 when all weights are positive, for then no
/// rounding exceeds the weight it is divided by.
fn amplification(form: &Form, least: f64) -> f64 {
    let poles = form.homogeneous().chunks_exact(form.width());
    if poles.clone().all(|pole| pole[form.ambient()] > 0.0) {
        return 1.0;
    }
    let largest = poles.flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
    largest / least
}

/// The power of two at or below a size; the least normal number for anything less.
pub(in crate::measuring) fn binade(size: f64) -> f64 {
    let exponent = size.to_bits() & (0x7ff << 52);
    if size == 0.0 { 1.0 } else { f64::from_bits(exponent).max(f64::MIN_POSITIVE) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_binade_is_a_power_of_two_below() {
        for (size, expected) in [(1.0, 1.0), (3.9, 2.0), (0.7, 0.5), (0.0, 1.0), (1e-320, 2e-308)] {
            let found = binade(size);
            assert!((found - expected).abs() <= 0.2 * expected, "{size}: {found}");
            assert!(found == 1.0 || found <= size.max(f64::MIN_POSITIVE));
        }
    }

    #[test]
    fn points_are_seen_from_the_centre_of_the_form() {
        let form: Form = Form::from_points(&[2], 2, &[3.0, 5.0, 7.0, 5.0], None).unwrap();
        let target = Target::new(&form).unwrap();
        let mut placed = [0.0; 2];
        target.place(&[4.0, 6.5], &mut placed).unwrap();
        assert_eq!(placed, [-0.5, 0.75]);
        assert_eq!(target.length(0.75), 1.5);
    }
}
