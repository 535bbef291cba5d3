//! Common factors of polynomials, found modulo primes.
//!
//! What has no common factor modulo a prime has none at all. Else the factors modulo a few primes are put
//! together until they divide (W. S. Brown, *On Euclid's algorithm and the computation of polynomial
//! greatest common divisors*, 1971): remainders in whole numbers would grow beyond all bounds.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, ToPrimitive, Zero};

use super::polynomial::Polynomial;

/// Primes are looked for below this.
const ABOVE: u64 = 1 << 61;

/// The greatest common divisor of two polynomials that are not 0, primitive.
pub(super) fn gcd(a: &Polynomial, b: &Polynomial) -> Polynomial {
    let (a, b) = (a.clone().primitive(), b.clone().primitive());
    let one = || Polynomial::new(vec![BigInt::one()]);
    let (Some(p), Some(q)) = (a.coefficients().last(), b.coefficients().last()) else {
        return one();
    };
    let lead = p.gcd(q);
    let (mut sum, mut modulus) = (Vec::<BigInt>::new(), BigInt::one());
    let mut prime = ABOVE;
    loop {
        prime = prime_below(prime);
        let field = Field(prime);
        let (p, q) = (field.residues(a.coefficients()), field.residues(b.coefficients()));
        // A degree that falls could hide a factor.
        if p.last() == Some(&0) || q.last() == Some(&0) {
            continue;
        }
        let mut factor = field.gcd(p, q);
        if factor.len() == 1 {
            return one();
        }
        let unit = field.times(field.residue(&lead), field.inverse(factor[factor.len() - 1]));
        for c in &mut factor {
            *c = field.times(*c, unit);
        }
        // More factors modulo a prime than there are: it was an unlucky one, or those before were.
        if !sum.is_empty() && factor.len() > sum.len() {
            continue;
        }
        if factor.len() < sum.len() || sum.is_empty() {
            sum = vec![BigInt::zero(); factor.len()];
            modulus = BigInt::one();
        }
        let settled = field.combine(&mut sum, &modulus, &factor);
        modulus *= prime;
        if settled {
            let found = Polynomial::new(balanced(&sum, &modulus)).primitive();
            if found.divides(&a) && found.divides(&b) {
                return found;
            }
        }
    }
}

/// Residues of least size.
fn balanced(values: &[BigInt], modulus: &BigInt) -> Vec<BigInt> {
    let half: BigInt = modulus >> 1_u32;
    values.iter().map(|c| if *c > half { c - modulus } else { c.clone() }).collect()
}

/// The largest prime below an odd number or a power of two.
fn prime_below(number: u64) -> u64 {
    let mut candidate = if number.is_multiple_of(2) { number - 1 } else { number - 2 };
    while !is_prime(candidate) {
        candidate -= 2;
    }
    candidate
}

/// By Miller's test, with bases that are enough for 64 bits (Sinclair 2011).
fn is_prime(number: u64) -> bool {
    let field = Field(number);
    let shift = (number - 1).trailing_zeros();
    [2, 325, 9375, 28178, 450_775, 9_780_504, 1_795_265_022].into_iter().all(|base| {
        let mut x = field.power(base, (number - 1) >> shift);
        let mut fine = x == 1 || x == number - 1;
        for _ in 1..shift {
            x = field.times(x, x);
            fine |= x == number - 1;
        }
        fine
    })
}

/// Whole numbers modulo a prime.
#[derive(Clone, Copy)]
struct Field(u64);

impl Field {
    fn residue(self, c: &BigInt) -> u64 {
        c.mod_floor(&BigInt::from(self.0)).to_u64().unwrap_or(0)
    }

    fn residues(self, coefficients: &[BigInt]) -> Vec<u64> {
        coefficients.iter().map(|c| self.residue(c)).collect()
    }

    fn times(self, a: u64, b: u64) -> u64 {
        (u128::from(a) * u128::from(b) % u128::from(self.0)) as u64
    }

    fn minus(self, a: u64, b: u64) -> u64 {
        if a >= b { a - b } else { a + (self.0 - b) }
    }

    fn power(self, base: u64, mut exponent: u64) -> u64 {
        let (mut result, mut square) = (1, base % self.0);
        while exponent > 0 {
            if exponent & 1 == 1 {
                result = self.times(result, square);
            }
            square = self.times(square, square);
            exponent >>= 1;
        }
        result
    }

    fn inverse(self, a: u64) -> u64 {
        self.power(a, self.0 - 2)
    }

    /// Of polynomials whose last coefficients are not 0, by Euclid's remainders.
    fn gcd(self, mut p: Vec<u64>, mut q: Vec<u64>) -> Vec<u64> {
        while !q.is_empty() {
            self.remainder(&mut p, &q);
            std::mem::swap(&mut p, &mut q);
        }
        p
    }

    /// The remainder of `p` by `q`, whose last coefficient is not 0, without leading zeros.
    fn remainder(self, p: &mut Vec<u64>, q: &[u64]) {
        let Some((lead, lower)) = q.split_last() else { return };
        let unit = self.inverse(*lead);
        while p.len() >= q.len() {
            let factor = self.times(p.pop().unwrap_or(0), unit);
            let shift = p.len() - lower.len();
            for (x, y) in p[shift..].iter_mut().zip(lower) {
                *x = self.minus(*x, self.times(factor, *y));
            }
        }
        while p.last() == Some(&0) {
            p.pop();
        }
    }

    /// Changes `sum`, known up to `modulus`, by a multiple of that so that it has these residues too;
    /// true if it had them, as numbers of least size.
    fn combine(self, sum: &mut [BigInt], modulus: &BigInt, residues: &[u64]) -> bool {
        let unit = self.inverse(self.residue(modulus));
        let top = self.0 - 1;
        let mut settled = true;
        for (c, residue) in sum.iter_mut().zip(residues) {
            let step = self.times(self.minus(*residue, self.residue(c)), unit);
            // 0, or −1 for a number below 0, changes nothing.
            settled &= step == 0 || step == top;
            *c += modulus * step;
        }
        settled
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polynomial(c: &[i64]) -> Polynomial {
        Polynomial::new(c.iter().map(|c| BigInt::from(*c)).collect())
    }

    #[test]
    fn factors_of_products() {
        // (x − 3)(2x + 5)·7 and (x − 3)(x² + 1)·10.
        let (a, b) = (polynomial(&[-105, -7, 14]), polynomial(&[-30, 10, -30, 10]));
        assert_eq!(gcd(&a, &b), polynomial(&[-3, 1]));
        assert_eq!(gcd(&b, &polynomial(&[5, 2])), polynomial(&[1]));
        assert_eq!(gcd(&a, &a), polynomial(&[-15, -1, 2]));
    }

    #[test]
    fn factors_with_long_coefficients() {
        let long = |seed: u64| BigInt::from(seed).pow(40) + BigInt::one();
        let common = Polynomial::new(vec![-long(777_777), long(31_337), long(271_828)]).primitive();
        let times = |c: BigInt| {
            // common·(x + c)
            let f = common.coefficients();
            let shifted = |i: usize| if i == 0 { BigInt::zero() } else { f[i - 1].clone() };
            let scaled = |i: usize| f.get(i).map_or_else(BigInt::zero, |x| x * &c);
            Polynomial::new((0..=f.len()).map(|i| shifted(i) + scaled(i)).collect())
        };
        assert_eq!(gcd(&times(long(5)), &times(long(6))), common);
    }

    #[test]
    fn primes() {
        assert_eq!(prime_below(1 << 61), (1 << 61) - 1);
        assert!(is_prime(1_000_000_007) && !is_prime(1_000_000_007 * 3));
    }
}
