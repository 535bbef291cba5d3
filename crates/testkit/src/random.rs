//! Reproducible random numbers and forms.

use std::ops::RangeInclusive;

use pforms_kernel::{Form, Rational, Scalar};

/// Which weights a random form gets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Weights {
    /// All 1: a polynomial form.
    One,
    /// Between ½ and 2.
    Positive,
    /// Any sign, 0 too: poles at infinity.
    Any,
}

/// A stream of numbers that is the same in every run (`SplitMix64`; Steele, Lea, Flood 2014).
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// The stream that starts at `seed`.
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// The next 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A whole number from `low` to `high`, both included.
    pub fn integer(&mut self, low: i64, high: i64) -> i64 {
        low + (self.bits() % (high - low + 1) as u64) as i64
    }

    /// A small size from `low` to `high`, both included.
    pub fn size(&mut self, low: usize, high: usize) -> usize {
        self.integer(low as i64, high as i64) as usize
    }

    /// A fraction in [−3, 3] whose denominator is small and often not a power of two.
    pub fn fraction<S: Scalar>(&mut self) -> S {
        let denominator = self.integer(1, 12);
        S::ratio(self.integer(-3 * denominator, 3 * denominator), denominator)
    }

    /// A fraction in [0, 1].
    pub fn parameter<S: Scalar>(&mut self) -> S {
        let denominator = self.integer(1, 12);
        S::ratio(self.integer(0, denominator), denominator)
    }

    /// An `f64` in [0, 1), all bits random.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Random parameters in [0, 1], one for each axis.
    pub fn parameters<S: Scalar>(&mut self, axes: usize) -> Vec<S> {
        (0..axes).map(|_| self.parameter()).collect()
    }

    /// Random orders from 1 to `highest`, one for each axis.
    pub fn orders(&mut self, axes: usize, highest: usize) -> Vec<usize> {
        (0..axes).map(|_| self.size(1, highest)).collect()
    }

    /// A form with fractions for coordinates.
    pub fn form<S: Scalar>(&mut self, orders: &[usize], ambient: usize, w: Weights) -> Form<S> {
        self.form_of(orders, ambient, w, Self::fraction)
    }

    /// A form whose coordinates lie in [0, 1]: one to immerse.
    pub fn inner_form<S: Scalar>(
        &mut self,
        orders: &[usize],
        ambient: usize,
        w: Weights,
    ) -> Form<S> {
        self.form_of(orders, ambient, w, Self::parameter)
    }

    fn form_of<S: Scalar>(
        &mut self,
        orders: &[usize],
        ambient: usize,
        weights: Weights,
        coordinate: fn(&mut Self) -> S,
    ) -> Form<S> {
        let count = orders.iter().product::<usize>();
        let points: Vec<S> = (0..count * ambient).map(|_| coordinate(self)).collect();
        let weights: Vec<S> = (0..count).map(|_| self.weight(weights)).collect();
        Form::from_points(orders, ambient, &points, Some(&weights)).unwrap()
    }

    fn weight<S: Scalar>(&mut self, weights: Weights) -> S {
        match weights {
            Weights::One => S::one(),
            Weights::Positive => S::ratio(self.integer(4, 16), 8),
            Weights::Any => S::ratio(self.integer(-8, 8), 4),
        }
    }

    /// An `f64` form with all bits of its numbers random: coordinates in [−1, 1], weights as told.
    pub fn rough_form(&mut self, orders: &[usize], ambient: usize, weights: Weights) -> Form {
        let count = orders.iter().product::<usize>();
        let points: Vec<f64> = (0..count * ambient).map(|_| 2.0 * self.unit() - 1.0).collect();
        let rough = |random: &mut Self| match weights {
            Weights::One => 1.0,
            Weights::Positive => 0.5 + 1.5 * random.unit(),
            Weights::Any => 2.0 * random.unit() - 1.0,
        };
        let weights: Vec<f64> = (0..count).map(|_| rough(self)).collect();
        Form::from_points(orders, ambient, &points, Some(&weights)).unwrap()
    }
}

/// Rounds of a law: as many random forms it is tried on.
pub const ROUNDS: u64 = 40;

/// Random forms with that many axes, orders up to 4, in 1 to 4 dimensions, rational or not, each with
/// the stream it came from.
pub fn exact_forms(axes: RangeInclusive<usize>) -> impl Iterator<Item = (Form<Rational>, Random)> {
    (0..ROUNDS).map(move |seed| {
        let mut random = Random::new(seed);
        let axes = random.size(*axes.start(), *axes.end());
        let orders = random.orders(axes, 4);
        let ambient = random.size(1, 4);
        let weights = [Weights::One, Weights::Positive, Weights::Any][random.size(0, 2)];
        (random.form(&orders, ambient, weights), random)
    })
}

/// The largest difference between two nets, relative to the largest number of the exact one.
///
/// `None` when their orders differ.
pub fn relative_error<S: Scalar>(computed: &Form<S>, exact: &Form<Rational>) -> Option<f64> {
    if computed.orders() != exact.orders() || computed.ambient() != exact.ambient() {
        return None;
    }
    let pairs = computed.homogeneous().iter().zip(exact.homogeneous());
    let (mut gap, mut size) = (0.0_f64, 0.0_f64);
    for (x, y) in pairs {
        let x = Rational::from_float(x.to_f64())?;
        gap = gap.max((x - y).to_f64().abs());
        size = size.max(y.to_f64().abs());
    }
    Some(if size > 0.0 { gap / size } else { gap })
}
