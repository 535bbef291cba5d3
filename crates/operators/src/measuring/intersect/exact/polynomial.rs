//! Polynomials with whole coefficients of any size.

use num_bigint::{BigInt, Sign};
use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use super::modular;

/// `Σ cᵢ xⁱ`; the last coefficient is not 0, and 0 has none.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Polynomial(Vec<BigInt>);

impl Polynomial {
    pub(super) fn new(mut coefficients: Vec<BigInt>) -> Self {
        while coefficients.last().is_some_and(Zero::is_zero) {
            coefficients.pop();
        }
        Self(coefficients)
    }

    pub(super) fn coefficients(&self) -> &[BigInt] {
        &self.0
    }

    /// The coefficient of `xⁱ`, 0 beyond the degree.
    pub(super) fn coefficient(&self, i: usize) -> BigInt {
        self.0.get(i).cloned().unwrap_or_default()
    }

    /// 0 for constants, and for 0.
    pub(super) fn degree(&self) -> usize {
        self.0.len().saturating_sub(1)
    }

    pub(super) fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// Is it a number other than 0?
    pub(super) fn is_constant(&self) -> bool {
        self.0.len() == 1
    }

    /// Divided by the greatest common divisor of its coefficients, the last made positive.
    pub(super) fn primitive(mut self) -> Self {
        let mut content = BigInt::zero();
        for c in &self.0 {
            content = content.gcd(c);
            if content.is_one() {
                break;
            }
        }
        if self.0.last().is_some_and(BigInt::is_negative) {
            content = -content;
        }
        if !content.is_zero() && !content.is_one() {
            for c in &mut self.0 {
                *c /= &content;
            }
        }
        self
    }

    pub(super) fn derivative(&self) -> Self {
        let terms = self.0.iter().enumerate().skip(1);
        Self::new(terms.map(|(i, c)| c * BigInt::from(i)).collect())
    }

    /// The sum with a multiple of another.
    pub(super) fn plus(&self, other: &Self, times: i64) -> Self {
        let length = self.0.len().max(other.0.len());
        let sum = |i: usize| self.coefficient(i) + other.coefficient(i) * times;
        Self::new((0..length).map(sum).collect())
    }

    fn minus(&self, other: &Self) -> Self {
        let length = self.0.len().max(other.0.len());
        Self::new((0..length).map(|i| self.coefficient(i) - other.coefficient(i)).collect())
    }

    /// The quotient of an exact division of primitive polynomials.
    pub(super) fn over(&self, by: &Self) -> Self {
        let (mut rest, Some(lead)) = (self.0.clone(), by.0.last()) else { return self.clone() };
        let Some(steps) = (rest.len() + 1).checked_sub(by.0.len()) else {
            return Self::new(Vec::new());
        };
        let mut quotient = vec![BigInt::zero(); steps];
        for shift in (0..steps).rev() {
            let factor = &rest[shift + by.0.len() - 1] / lead;
            for (i, c) in by.0.iter().enumerate() {
                rest[shift + i] -= &factor * c;
            }
            quotient[shift] = factor;
        }
        Self::new(quotient)
    }

    /// Does it divide another without remainder, in whole numbers?
    pub(super) fn divides(&self, other: &Self) -> bool {
        let (mut rest, Some(lead)) = (other.0.clone(), self.0.last()) else { return false };
        while rest.len() >= self.0.len() {
            let Some(top) = rest.pop() else { break };
            let (factor, left) = top.div_rem(lead);
            if !left.is_zero() {
                return false;
            }
            let shift = rest.len() + 1 - self.0.len();
            for (i, c) in self.0[..self.0.len() - 1].iter().enumerate() {
                rest[shift + i] -= &factor * c;
            }
        }
        rest.iter().all(Zero::is_zero)
    }

    /// The greatest common divisor, primitive.
    pub(super) fn gcd(&self, other: &Self) -> Self {
        match (self.is_zero(), other.is_zero()) {
            (true, _) => other.clone().primitive(),
            (_, true) => self.clone().primitive(),
            _ => modular::gcd(self, other),
        }
    }

    /// Factors without multiple roots, and how often each occurs (Yun 1976).
    pub(super) fn square_free(&self) -> Vec<(Self, usize)> {
        let whole = self.clone().primitive();
        let slope = whole.derivative();
        let common = whole.gcd(&slope);
        if common.degree() == 0 {
            return vec![(whole, 1)];
        }
        let mut factors = Vec::new();
        // Exact divisions of primitive polynomials by primitive ones stay whole.
        let mut left = whole.over(&common);
        let mut next = slope.over(&common).minus(&left.derivative());
        let mut times = 1;
        while left.degree() > 0 {
            let factor = left.gcd(&next);
            if factor.degree() > 0 {
                factors.push((factor.clone(), times));
            }
            left = left.over(&factor);
            next = next.over(&factor).minus(&left.derivative());
            times += 1;
        }
        factors
    }

    /// `2^(k·degree)` times the value at `n/2ᵏ`.
    pub(super) fn scaled_at(&self, n: &BigInt, k: u64, degree: usize) -> BigInt {
        let mut sum = BigInt::zero();
        for i in (0..=degree).rev() {
            sum *= n;
            if let Some(c) = self.0.get(i) {
                sum += c << (k * (degree - i) as u64);
            }
        }
        sum
    }

    /// The sign at `n/2ᵏ`.
    pub(super) fn sign_at(&self, n: &BigInt, k: u64) -> Sign {
        self.scaled_at(n, k, self.degree()).sign()
    }
}
