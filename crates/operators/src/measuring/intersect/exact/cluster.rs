//! Roots that lie close together: rounding of the poles makes several of one.
//!
//! With `|r_n| ρⁿ > Σ_{k≠n} |r_k| ρᵏ` for the coefficients around a place a polynomial has exactly `n`
//! roots, complex ones among them, that are nearer than `ρ` (Pellet 1881, by Rouché's theorem). Their
//! mean is known far better than each of them.

use num_bigint::BigInt;
use num_traits::{Signed, ToPrimitive, Zero};

use super::polynomial::Polynomial;

/// So many roots around a place.
#[derive(Clone, Copy, Debug)]
pub(in crate::measuring::intersect) struct Cluster {
    pub count: usize,
    /// Their mean, as nearly as their sum is known.
    pub centre: f64,
    /// None of them is farther away from it.
    pub radius: f64,
    /// What the polynomial is at most among them, in units of its own.
    pub level: f64,
}

/// A polynomial around a place, in units of its own.
pub(in crate::measuring::intersect) struct Around {
    place: f64,
    coefficients: Vec<f64>,
}

/// Roots that are counted together, at most.
const MOST: usize = 16;

/// A cluster is no wider than this, and no farther away from where it is looked for.
const WIDEST: f64 = 1.0 / 50.0;

/// Places are multiples of `2⁻ᵏ`.
const PLACES: u64 = 60;

impl Around {
    pub(super) fn new(polynomial: &Polynomial, place: f64) -> Self {
        let n = libm::ldexp(place, PLACES as i32) as i64;
        let shifted = shifted(polynomial, &BigInt::from(n));
        // The coefficient of xⁱ is `cᵢ·2^(−k(d−i))`: only its size beside the others counts.
        let last = shifted.len().saturating_sub(1);
        let exponent = |i: usize| shifted[i].bits() as i64 - (PLACES * (last - i) as u64) as i64;
        let nonzero = (0..shifted.len()).filter(|i| !shifted[*i].is_zero());
        let top = nonzero.map(exponent).max().unwrap_or(0);
        let coefficients = (0..shifted.len())
            .map(|i| {
                let drop = shifted[i].bits().saturating_sub(64);
                let mantissa = (shifted[i].abs() >> drop).to_f64().unwrap_or(0.0);
                let sign = if shifted[i].is_negative() { -1.0 } else { 1.0 };
                let scale = drop as i64 - (PLACES * (last - i) as u64) as i64 - top;
                sign * libm::ldexp(mantissa, scale.max(-2000) as i32)
            })
            .collect();
        Self { place: n as f64 / libm::ldexp(1.0, PLACES as i32), coefficients }
    }

    /// The clusters of two roots or more around the place, the largest first.
    pub(in crate::measuring::intersect) fn clusters(&self) -> impl Iterator<Item = Cluster> + '_ {
        let most = self.coefficients.len().saturating_sub(1).min(MOST);
        (2..=most).rev().filter_map(|n| self.cluster(n))
    }

    /// The value, in units of its own.
    pub(in crate::measuring::intersect) fn value(&self, t: f64) -> f64 {
        let x = t - self.place;
        self.coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c)
    }

    fn cluster(&self, n: usize) -> Option<Cluster> {
        let (mut c, mut centre) = (self.coefficients.clone(), self.place);
        for _ in 0..3 {
            let step = -c[n - 1] / (n as f64 * c[n]);
            if step.is_nan() || step.abs() > 2.0 * WIDEST {
                return None;
            }
            shift(&mut c, step);
            centre += step;
        }
        let spread = (0..n - 1).fold(0.0_f64, |most, k| {
            most.max(libm::pow((c[k] / c[n]).abs(), 1.0 / (n - k) as f64))
        });
        let mut radius = spread.max(1e-15);
        while radius <= WIDEST {
            if holds(&c, n, radius) {
                let level = c[n].abs() * libm::pow(spread, n as f64);
                return Some(Cluster { count: n, centre, radius, level });
            }
            radius *= 1.125;
        }
        None
    }
}

/// Does Pellet's inequality hold, with room for rounding?
fn holds(c: &[f64], n: usize, radius: f64) -> bool {
    let (mut power, mut own, mut rest) = (1.0, 0.0, 0.0);
    for (k, x) in c.iter().enumerate() {
        let term = x.abs() * power;
        if k == n {
            own = term;
        } else {
            rest += term;
        }
        power *= radius;
    }
    own > rest * (1.0 + 1e-9)
}

/// `c(x + step)` in place.
fn shift(c: &mut [f64], step: f64) {
    for start in 0..c.len().saturating_sub(1) {
        for i in (start..c.len() - 1).rev() {
            c[i] += step * c[i + 1];
        }
    }
}

/// The coefficients of `2^(kd)·p((x + n)/2ᵏ)`.
fn shifted(polynomial: &Polynomial, n: &BigInt) -> Vec<BigInt> {
    let last = polynomial.degree();
    let of = |(i, c): (usize, &BigInt)| c << (PLACES * (last - i) as u64);
    let mut c: Vec<BigInt> = polynomial.coefficients().iter().enumerate().map(of).collect();
    for start in 0..last {
        for i in (start..last).rev() {
            let (low, high) = c.split_at_mut(i + 1);
            low[i] += &high[0] * n;
        }
    }
    c
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The product of `x − r/1000`, with whole coefficients.
    fn polynomial(roots: &[i64]) -> Polynomial {
        let mut c = vec![BigInt::from(1)];
        for root in roots {
            let mut next = vec![BigInt::zero(); c.len() + 1];
            for (i, x) in c.iter().enumerate() {
                next[i] -= x * root;
                next[i + 1] += x * 1000;
            }
            c = next;
        }
        Polynomial::new(c)
    }

    #[test]
    fn roots_are_counted_together() {
        let three = polynomial(&[299, 300, 301, 900, -500]);
        let around = Around::new(&three, 0.3005);
        let all: Vec<Cluster> = around.clusters().collect();
        // All three, and the two that are nearest.
        let counts: Vec<usize> = all.iter().map(|cluster| cluster.count).collect();
        assert_eq!(counts, [3, 2], "{all:?}");
        assert!((all[0].centre - 0.3).abs() < 1e-5 && all[0].radius < 0.01, "{all:?}");
        // Alone, or too far apart.
        assert_eq!(Around::new(&three, 0.9).clusters().count(), 0);
        assert_eq!(Around::new(&polynomial(&[200, 500, 800]), 0.5).clusters().count(), 0);
    }

    #[test]
    fn a_blurred_root_of_order_seven() {
        // (x − 0.3)⁷ with one coefficient off by 1e-16: roots 5e-3 apart, their mean is not.
        let exact = polynomial(&[300; 7]);
        let mut c = exact.coefficients().to_vec();
        let top = c[7].clone();
        c[0] += &top / BigInt::from(10_000_000_000_000_000_i64);
        let found = Around::new(&Polynomial::new(c), 0.302).clusters().next();
        let found = found.map(|cluster| (cluster.count, (cluster.centre - 0.3).abs() < 1e-12));
        assert_eq!(found, Some((7, true)));
    }
}
