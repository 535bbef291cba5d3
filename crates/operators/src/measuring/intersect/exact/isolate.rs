//! The roots of a polynomial in `[0, 1]`, each in a window of its own (Vincent, Collins, Akritas).

use num_bigint::{BigInt, Sign};
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::polynomial::Polynomial;

/// A root: exactly `low/2ᵏ`, or inside `(low/2ᵏ, (low + 1)/2ᵏ)`.
#[derive(Clone, Debug)]
pub(super) struct RealRoot {
    pub low: BigInt,
    pub k: u64,
    pub exact: bool,
    /// How often it is one.
    pub times: usize,
}

/// Places of a root after the point that are kept.
pub(super) const BITS: u64 = 192;

impl RealRoot {
    /// The nearest `f64`.
    pub(super) fn value(&self) -> f64 {
        let shift = self.k.saturating_sub(80);
        let low: BigInt = &self.low >> shift;
        let scale = libm::ldexp(1.0, -((self.k - shift) as i32));
        low.to_f64().unwrap_or(0.0) * scale
    }

    /// Narrowed until it has [`BITS`] places: to the share of the window where the chord is 0, and so to
    /// twice as many places each time, or to a half of it when that fails (J. Abbott 2006).
    fn refined(mut self, polynomial: &Polynomial, before: Sign) -> Self {
        let mut bits = 2_u64;
        while !self.exact && self.k < BITS {
            if self.on_chord(polynomial, before, bits.min(BITS - self.k)) {
                bits = (2 * bits).min(BITS);
            } else {
                bits = (bits / 2).max(1);
                self.halve(polynomial, before);
            }
        }
        self
    }

    fn halve(&mut self, polynomial: &Polynomial, before: Sign) {
        self.low <<= 1_u32;
        self.k += 1;
        let middle: BigInt = &self.low + BigInt::one();
        match polynomial.sign_at(&middle, self.k) {
            Sign::NoSign => (self.low, self.exact) = (middle, true),
            sign if sign == before => self.low = middle,
            _ => {}
        }
    }

    /// Is the root in the one of `2^bits` parts of the window that the chord passes? Then in that.
    fn on_chord(&mut self, polynomial: &Polynomial, before: Sign, bits: u64) -> bool {
        let size = |n: &BigInt| polynomial.scaled_at(n, self.k, polynomial.degree()).abs();
        let (from, to) = (size(&self.low), size(&(&self.low + BigInt::one())));
        let whole: BigInt = &from + to;
        if whole.is_zero() {
            return false;
        }
        let last = (BigInt::one() << bits) - BigInt::one();
        let part = ((from << bits) / whole).min(last.clone());
        let (left, k) = ((&self.low << bits) + &part, self.k + bits);
        let right: BigInt = &left + BigInt::one();
        // At the ends of the window other roots may be.
        let sign = |place: &BigInt, at_end: bool, there: Sign| {
            if at_end { there } else { polynomial.sign_at(place, k) }
        };
        let (start, end) =
            (sign(&left, part.is_zero(), before), sign(&right, part == last, -before));
        match (start, end) {
            (Sign::NoSign, _) => (self.low, self.k, self.exact) = (left, k, true),
            (_, Sign::NoSign) => (self.low, self.k, self.exact) = (right, k, true),
            _ if start == before && end != before => (self.low, self.k) = (left, k),
            _ => return false,
        }
        true
    }
}

/// All roots in `[0, 1]`, in order, each with its multiplicity.
pub(super) fn real_roots(polynomial: &Polynomial) -> Vec<RealRoot> {
    let mut all = Vec::new();
    for (factor, times) in polynomial.square_free() {
        all.extend(simple_roots(&factor).into_iter().map(|root| RealRoot { times, ..root }));
    }
    all.sort_by(|a, b| {
        let k = a.k.max(b.k);
        (&a.low << (k - a.k)).cmp(&(&b.low << (k - b.k)))
    });
    all
}

/// The roots of a polynomial without multiple ones.
fn simple_roots(polynomial: &Polynomial) -> Vec<RealRoot> {
    let exact = |low: BigInt, k: u64| RealRoot { low, k, exact: true, times: 1 };
    let mut found = Vec::new();
    if polynomial.degree() == 0 {
        return found;
    }
    for end in [BigInt::zero(), BigInt::one()] {
        if polynomial.sign_at(&end, 0) == Sign::NoSign {
            found.push(exact(end, 0));
        }
    }
    let mut waiting = vec![(polynomial.coefficients().to_vec(), BigInt::zero(), 0_u64)];
    while let Some((local, low, k)) = waiting.pop() {
        match variations(&local) {
            0 => {}
            1 => {
                let before = local.iter().map(BigInt::sign).find(|s| *s != Sign::NoSign);
                let root = RealRoot { low, k, exact: false, times: 1 };
                found.push(root.refined(polynomial, before.unwrap_or(Sign::NoSign)));
            }
            _ => {
                let last = local.len() - 1;
                let left: Vec<BigInt> =
                    local.iter().enumerate().map(|(i, c)| c << (last - i)).collect();
                let mut right = left.clone();
                shift(&mut right);
                let (low, k) = (low << 1_u32, k + 1);
                let middle = &low + BigInt::one();
                if right[0].is_zero() {
                    found.push(exact(middle.clone(), k));
                }
                waiting.push((right, middle, k));
                waiting.push((left, low, k));
            }
        }
    }
    found
}

/// `p(x + 1)` in place.
fn shift(p: &mut [BigInt]) {
    for start in (0..p.len().saturating_sub(1)).rev() {
        for i in start..p.len() - 1 {
            let (low, high) = p.split_at_mut(i + 1);
            low[i] += &high[0];
        }
    }
}

/// Changes of sign of the coefficients on `(1 − x)` and `x`: no less than the roots inside, and as
/// many if there is one or none.
fn variations(p: &[BigInt]) -> usize {
    let mut turned: Vec<BigInt> = p.iter().rev().cloned().collect();
    shift(&mut turned);
    let signs: Vec<Sign> =
        turned.iter().map(BigInt::sign).filter(|sign| *sign != Sign::NoSign).collect();
    signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
}
