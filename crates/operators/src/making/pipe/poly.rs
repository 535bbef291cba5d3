//! Polynomials of one variable on `[0, 1]`, by their Bernstein coefficients: what can be proved of
//! them is read off the coefficients.

use pforms_kernel::Binomials;

/// A polynomial, at least one coefficient.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Poly(pub(super) Vec<f64>);

impl Poly {
    pub(super) fn constant(value: f64) -> Self {
        Self(vec![value])
    }

    pub(super) fn degree(&self) -> usize {
        self.0.len() - 1
    }

    pub(super) fn first(&self) -> f64 {
        self.0[0]
    }

    pub(super) fn last(&self) -> f64 {
        self.0[self.degree()]
    }

    /// No value on `[0, 1]` is below it.
    pub(super) fn least(&self) -> f64 {
        self.0.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// No value on `[0, 1]` is further from 0.
    pub(super) fn most(&self) -> f64 {
        self.0.iter().fold(0.0, |most, x| most.max(x.abs()))
    }

    pub(super) fn at(&self, t: f64) -> f64 {
        let mut row = self.0.clone();
        for length in (1..row.len()).rev() {
            for i in 0..length {
                row[i] += t * (row[i + 1] - row[i]);
            }
        }
        row[0]
    }

    pub(super) fn scaled(&self, factor: f64) -> Self {
        Self(self.0.iter().map(|x| x * factor).collect())
    }

    pub(super) fn times(&self, other: &Self) -> Self {
        let (n, m) = (self.degree(), other.degree());
        if n == 0 {
            return other.scaled(self.0[0]);
        }
        if m == 0 {
            return self.scaled(other.0[0]);
        }
        let row = Binomials::<f64>::of;
        let (left, right, whole) = (row(n), row(m), row(n + m));
        let mut sums = vec![0.0; n + m + 1];
        for (i, a) in self.0.iter().enumerate() {
            let a = a * left.get(i);
            for (j, b) in other.0.iter().enumerate() {
                sums[i + j] += a * (b * right.get(j));
            }
        }
        sums.iter_mut().enumerate().for_each(|(k, sum)| *sum /= whole.get(k));
        Self(sums)
    }

    pub(super) fn raised(&self, degree: usize) -> Self {
        let mut poles = self.0.clone();
        while poles.len() <= degree {
            let n = poles.len() as f64;
            let inner = poles.windows(2).enumerate();
            let mut next = vec![poles[0]];
            next.extend(inner.map(|(i, pair)| {
                let share = (i + 1) as f64 / n;
                share * pair[0] + (1.0 - share) * pair[1]
            }));
            next.push(poles[poles.len() - 1]);
            poles = next;
        }
        Self(poles)
    }

    pub(super) fn plus(&self, factor: f64, other: &Self) -> Self {
        let degree = self.degree().max(other.degree());
        let (a, b) = (self.raised(degree), other.raised(degree));
        Self(a.0.iter().zip(&b.0).map(|(x, y)| x + factor * y).collect())
    }

    pub(super) fn derivative(&self) -> Self {
        if self.degree() == 0 {
            return Self::constant(0.0);
        }
        let n = self.degree() as f64;
        Self(self.0.windows(2).map(|pair| n * (pair[1] - pair[0])).collect())
    }

    /// The same polynomial on `[0, ½]` and `[½, 1]`, each for itself on `[0, 1]`.
    pub(super) fn halves(&self) -> (Self, Self) {
        let mut row = self.0.clone();
        let (mut left, mut right) = (vec![row[0]], vec![row[row.len() - 1]]);
        for length in (1..row.len()).rev() {
            for i in 0..length {
                row[i] = 0.5 * row[i] + 0.5 * row[i + 1];
            }
            left.push(row[0]);
            right.push(row[length - 1]);
        }
        right.reverse();
        (Self(left), Self(right))
    }

    /// The polynomial of degree 5 with these values and first two derivatives at both ends.
    pub(super) fn hermite(start: [f64; 3], end: [f64; 3]) -> Self {
        let [a, da, dda] = start;
        let [b, db, ddb] = end;
        Self(vec![
            a,
            a + da / 5.0,
            a + 2.0 * da / 5.0 + dda / 20.0,
            b - 2.0 * db / 5.0 + ddb / 20.0,
            b - db / 5.0,
            b,
        ])
    }
}
