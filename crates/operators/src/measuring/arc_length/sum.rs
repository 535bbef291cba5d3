//! Sums of many numbers that are not negative.

/// A sum and what rounding left out of it (Neumaier): off by some roundings of the result, however
/// many are added.
#[derive(Clone, Copy, Default)]
pub(super) struct Sum {
    high: f64,
    low: f64,
}

impl Sum {
    /// Adds a number.
    pub(super) fn add(&mut self, x: f64) {
        let sum = self.high + x;
        let (large, small) =
            if self.high.abs() >= x.abs() { (self.high, x) } else { (x, self.high) };
        self.low += (large - sum) + small;
        self.high = sum;
    }

    /// The sum so far.
    pub(super) fn value(&self) -> f64 {
        self.high + self.low
    }
}

impl FromIterator<f64> for Sum {
    fn from_iter<I: IntoIterator<Item = f64>>(numbers: I) -> Self {
        let mut sum = Self::default();
        numbers.into_iter().for_each(|x| sum.add(x));
        sum
    }
}
