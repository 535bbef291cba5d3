//! The equation of a plane curve, met by another: Bézout's determinant, evaluated and interpolated.

use num_bigint::BigInt;
use num_traits::{One, Zero};

use super::polynomial::Polynomial;

/// A plane curve `X : Y : W` with whole coefficients, without common factor.
#[derive(Clone, Debug)]
pub(super) struct ExactCurve {
    parts: [Polynomial; 3],
    pub degree: usize,
}

impl ExactCurve {
    fn new(mut parts: [Polynomial; 3]) -> Self {
        let common = parts[0].gcd(&parts[1]).gcd(&parts[2]);
        if common.degree() > 0 {
            parts = parts.map(|part| divided(&part, &common));
        }
        let degree = parts.iter().map(Polynomial::degree).max().unwrap_or(0);
        Self { parts, degree }
    }

    /// The homogeneous point at `n/2ᵏ`, times a power of two.
    fn at(&self, n: &BigInt, k: u64) -> [BigInt; 3] {
        [0, 1, 2].map(|i| self.parts[i].scaled_at(n, k, self.degree))
    }

    /// Its coordinates, the weight last.
    pub(super) fn whole(&self) -> &[Polynomial] {
        &self.parts
    }

    /// The length of its longest coefficient.
    fn bits(&self) -> u64 {
        let all = self.parts.iter().flat_map(Polynomial::coefficients);
        all.map(BigInt::bits).max().unwrap_or(0)
    }

    fn coefficient(&self, i: usize) -> [BigInt; 3] {
        [0, 1, 2].map(|k| self.parts[k].coefficient(i))
    }
}

/// A curve of any space: its coordinates with whole coefficients, the weight last.
pub(super) struct Coordinates(Vec<Polynomial>);

impl Coordinates {
    /// Some coordinates of homogeneous poles in floating arithmetic, each a whole number of units.
    pub(super) fn new(poles: &[Vec<f64>]) -> Self {
        let exponent = poles.iter().flatten().map(|x| lowest_bit(*x)).min().unwrap_or(0);
        let width = poles.first().map_or(0, Vec::len);
        let part = |k: usize| powers(poles.iter().map(|p| whole(p[k], exponent)).collect());
        Self((0..width).map(part).collect())
    }

    /// All of them.
    pub(super) fn whole(&self) -> &[Polynomial] {
        &self.0
    }

    /// As seen in a plane: there is one view of a plane, and [`VIEWS`] of a space.
    pub(super) fn seen(&self, view: usize) -> ExactCurve {
        let Some((weight, rest)) = self.0.split_last() else {
            return ExactCurve::new([0, 1, 2].map(|_| Polynomial::new(Vec::new())));
        };
        let sum = |row: usize| match rest.len() {
            0..=2 => rest.get(row).cloned().unwrap_or_else(|| Polynomial::new(Vec::new())),
            _ => rest.iter().enumerate().fold(Polynomial::new(Vec::new()), |sum, (i, part)| {
                sum.plus(part, slant(view, row, i))
            }),
        };
        ExactCurve::new([sum(0), sum(1), weight.clone()])
    }

    /// Ways of seeing it.
    pub(super) fn views(&self) -> usize {
        if self.0.len() > 3 { VIEWS } else { 1 }
    }
}

/// Ways of seeing a space in a plane: what meets in three of them, at the same parameters, meets.
const VIEWS: usize = 3;

/// Coefficients of the views, as odd as any.
fn slant(view: usize, row: usize, coordinate: usize) -> i64 {
    let root = (31 * coordinate + 17 * view + 7 * row + 3) as i64;
    root * root % 23 - 11
}

/// The exact quotient by a primitive divisor: contents are kept in proportion by Gauss's lemma.
fn divided(part: &Polynomial, by: &Polynomial) -> Polynomial {
    if part.is_zero() { part.clone() } else { part.over(by) }
}

/// The exponent of the last bit of a number that is not 0.
fn lowest_bit(x: f64) -> i32 {
    if x == 0.0 {
        return i32::MAX;
    }
    let (mantissa, exponent) = libm::frexp(x);
    let digits = (mantissa.abs() * 9_007_199_254_740_992.0) as u64;
    exponent - 53 + digits.trailing_zeros() as i32
}

/// A number in units of a power of two below its last bit.
fn whole(x: f64, exponent: i32) -> BigInt {
    if x == 0.0 {
        return BigInt::zero();
    }
    let (mantissa, own) = libm::frexp(x);
    let digits = BigInt::from((mantissa * 9_007_199_254_740_992.0) as i64);
    let shift = own - 53 - exponent;
    if shift >= 0 { digits << shift } else { digits >> -shift }
}

/// Bernstein coefficients as those of powers: differences times binomials.
fn powers(mut values: Vec<BigInt>) -> Polynomial {
    let last = values.len() - 1;
    for step in 0..last {
        for i in (step + 1..=last).rev() {
            let (low, high) = values.split_at_mut(i);
            high[0] -= &low[i - 1];
        }
    }
    let mut binomial = BigInt::one();
    for (k, value) in values.iter_mut().enumerate() {
        *value *= &binomial;
        binomial = binomial * BigInt::from(last - k) / BigInt::from(k + 1);
    }
    Polynomial::new(values)
}

/// The equation of a curve as Bézout's matrix: each entry a linear form in `x, y, w`.
pub(super) struct Equation {
    size: usize,
    entries: Vec<[BigInt; 3]>,
}

impl Equation {
    pub(super) fn new(curve: &ExactCurve) -> Self {
        let size = curve.degree;
        let rows: Vec<[BigInt; 3]> = (0..=size).map(|i| curve.coefficient(i)).collect();
        let mut entries = vec![[const { BigInt::ZERO }; 3]; size * size];
        for i in 0..size {
            for j in 1..=size {
                let bracket = cross(&rows[i], &rows[j]);
                for k in 0..3 {
                    let before = if i > 0 && j < size {
                        entries[(i - 1) * size + j][k].clone()
                    } else {
                        BigInt::zero()
                    };
                    entries[i * size + j - 1][k] = before - &bracket[k];
                }
            }
        }
        Self { size, entries }
    }

    /// Its value at a homogeneous point.
    pub(super) fn at(&self, point: &[BigInt; 3]) -> BigInt {
        let dot = |e: &[BigInt; 3]| &e[0] * &point[0] + &e[1] * &point[1] + &e[2] * &point[2];
        determinant(self.entries.iter().map(dot).collect(), self.size)
    }

    /// Along another curve: a polynomial, 0 if that lies on this one, or if this one is run through
    /// more than once.
    pub(super) fn along(&self, other: &ExactCurve) -> Polynomial {
        let degree = self.size * other.degree;
        let start = -((degree / 2) as i64);
        let places = (0..=degree as i64).map(|i| BigInt::from(start + i));
        let values: Vec<BigInt> = places.map(|n| self.at(&other.at(&n, 0))).collect();
        interpolated(values, start)
    }

    /// Does the equation hold everywhere? Then the curve is run through more than once.
    pub(super) fn is_void(&self) -> bool {
        // A polynomial of low degree that vanishes at a point as odd as this is 0.
        let odd = |text: &[u8]| BigInt::from_bytes_be(num_bigint::Sign::Plus, text);
        self.at(&[odd(b"an odd abscissa 1"), odd(b"and ordinate 2"), odd(b"weight 3")]).is_zero()
    }
}

/// About how many nanoseconds it takes to have the equation of one curve along another: so many
/// determinants of so many products of so many digits.
pub(super) fn work(one: &ExactCurve, other: &ExactCurve) -> f64 {
    let [n, m] = [one, other].map(|curve| curve.degree as f64);
    let bits = 2.0 * one.bits() as f64 + other.bits() as f64 + 6.0 * m;
    let digits = n * bits / 64.0;
    n * m * (n * n * n / 3.0) * libm::pow(digits, 1.6).max(64.0)
}

fn cross(a: &[BigInt; 3], b: &[BigInt; 3]) -> [BigInt; 3] {
    [&a[1] * &b[2] - &a[2] * &b[1], &a[2] * &b[0] - &a[0] * &b[2], &a[0] * &b[1] - &a[1] * &b[0]]
}

/// Without fractions (Bareiss 1968).
fn determinant(mut m: Vec<BigInt>, size: usize) -> BigInt {
    let mut before = BigInt::one();
    let mut negative = false;
    for k in 0..size {
        let Some(pivot) = (k..size).find(|row| !m[row * size + k].is_zero()) else {
            return BigInt::zero();
        };
        if pivot != k {
            for column in 0..size {
                m.swap(k * size + column, pivot * size + column);
            }
            negative = !negative;
        }
        for i in k + 1..size {
            for j in k + 1..size {
                let term =
                    &m[i * size + j] * &m[k * size + k] - &m[i * size + k] * &m[k * size + j];
                m[i * size + j] = term / &before;
            }
        }
        before.clone_from(&m[k * size + k]);
    }
    if negative { -before } else { before }
}

/// The polynomial with whole coefficients that has these values at `start`, `start + 1`, …
fn interpolated(mut values: Vec<BigInt>, start: i64) -> Polynomial {
    let last = values.len() - 1;
    // Divided differences are whole.
    for step in 1..=last {
        for i in (step..=last).rev() {
            let (low, high) = values.split_at_mut(i);
            high[0] -= &low[i - 1];
            high[0] /= BigInt::from(step);
        }
    }
    let mut sum: Vec<BigInt> = Vec::with_capacity(last + 1);
    for (i, c) in values.iter().enumerate().rev() {
        // sum·(x − place) + c
        let place = BigInt::from(start + i as i64);
        sum.insert(0, BigInt::zero());
        for k in 0..sum.len() - 1 {
            let (low, high) = sum.split_at_mut(k + 1);
            low[k] -= &place * &high[0];
        }
        sum[0] += c;
    }
    Polynomial::new(sum)
}
