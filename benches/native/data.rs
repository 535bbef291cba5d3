//! Forms and parameters to measure with: random, the same in every run.

use std::fmt;

use pforms_kernel::{Form, Kind as KernelKind};

/// A form of three coordinates; when rational, with weights between 1/2 and 2.
#[must_use]
pub fn form(orders: &[usize], rational: bool) -> Form {
    let mut numbers = Numbers(orders.iter().fold(1, |seed, order| seed * 31 + *order as u64));
    let count = orders.iter().product();
    let points: Vec<f64> = (0..3 * count).map(|_| numbers.between(-1.0, 1.0)).collect();
    let weights: Vec<f64> = (0..count).map(|_| numbers.between(0.5, 2.0)).collect();
    Form::from_points(orders, 3, &points, rational.then_some(&weights[..])).unwrap()
}

/// A form in as many coordinates as the host has axes, with poles between 0 and 1.
#[must_use]
pub fn inside(axes: usize, orders: &[usize], rational: bool) -> Form {
    let mut numbers = Numbers(7);
    let count: usize = orders.iter().product();
    let points: Vec<f64> = (0..axes * count).map(|_| numbers.between(0.0, 1.0)).collect();
    let weights: Vec<f64> = (0..count).map(|_| numbers.between(0.5, 2.0)).collect();
    Form::from_points(orders, axes, &points, rational.then_some(&weights[..])).unwrap()
}

/// Parameters from 0 to 1, both included.
#[must_use]
pub fn parameters(count: usize) -> Vec<f64> {
    let last = (count.max(2) - 1) as f64;
    (0..count).map(|i| i as f64 / last).collect()
}

/// Scattered parameters between 0 and 1: one list for each of so many axes.
#[must_use]
pub fn scattered(axes: usize, count: usize) -> Vec<Vec<f64>> {
    let mut numbers = Numbers(3);
    (0..axes).map(|_| (0..count).map(|_| numbers.between(0.0, 1.0)).collect()).collect()
}

/// What a bench sweeps: axes, poles along each, and whether weights differ.
#[derive(Clone, Copy)]
pub struct Kind {
    /// Number of axes.
    pub axes: usize,
    /// Number of poles along each.
    pub order: usize,
    /// Whether there are weights.
    pub rational: bool,
}

impl Kind {
    /// Each pair of axes and order, polynomial and rational.
    ///
    /// # Panics
    ///
    /// When there is not room for exactly twice as many kinds.
    #[must_use]
    pub const fn sweep<const N: usize, const M: usize>(pairs: [(usize, usize); N]) -> [Self; M] {
        assert!(M == 2 * N);
        let mut kinds = [Self { axes: 0, order: 0, rational: false }; M];
        let mut k = 0;
        while k < M {
            let (axes, order) = pairs[k / 2];
            kinds[k] = Self { axes, order, rational: k % 2 == 1 };
            k += 1;
        }
        kinds
    }

    /// A form of this kind.
    #[must_use]
    pub fn form(self) -> Form {
        form(&vec![self.order; self.axes], self.rational)
    }
}

/// The book's name: `pS44`, with `*` when rational.
impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let star = if self.rational { "*" } else { "" };
        write!(f, "{}{star}", KernelKind::new(&vec![self.order; self.axes]))
    }
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
