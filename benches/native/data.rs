//! Forms to measure with: random, the same in every run.

#![expect(
    clippy::unwrap_used,
    clippy::missing_panics_doc,
    reason = "the data is fixed: a mistake in it should stop the run"
)]

use pforms_kernel::Form;

/// A rational form of three coordinates, weights between 1/2 and 2.
#[must_use]
pub fn rational(orders: &[usize]) -> Form {
    let mut numbers = Numbers(orders.iter().fold(1, |seed, order| seed * 31 + *order as u64));
    let count = orders.iter().product();
    let points: Vec<f64> = (0..3 * count).map(|_| numbers.between(-1.0, 1.0)).collect();
    let weights: Vec<f64> = (0..count).map(|_| numbers.between(0.5, 2.0)).collect();
    Form::from_points(orders, 3, &points, Some(&weights)).unwrap()
}

/// A polynomial form whose poles lie in the unit cube.
#[must_use]
pub fn inside_the_cube(orders: &[usize]) -> Form {
    let mut numbers = Numbers(7);
    let count: usize = orders.iter().product();
    let points: Vec<f64> = (0..3 * count).map(|_| numbers.between(0.0, 1.0)).collect();
    Form::from_points(orders, 3, &points, None).unwrap()
}

/// Parameters from 0 to 1, both included.
#[must_use]
pub fn parameters(count: usize) -> Vec<f64> {
    let last = (count.max(2) - 1) as f64;
    (0..count).map(|i| i as f64 / last).collect()
}

/// A linear congruential generator (Knuth, MMIX): enough for poles, and the same everywhere.
struct Numbers(u64);

impl Numbers {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * ((self.0 >> 11) as f64 / (1_u64 << 53) as f64)
    }
}
