//! Polynomials modulo a prime: what has no common factor there has none at all.

use num_bigint::BigInt;
use num_traits::ToPrimitive;

/// The prime `2⁶¹ − 1`.
const PRIME: u64 = (1 << 61) - 1;

/// Is it sure that two polynomials have no common factor but constants?
pub(super) fn are_coprime(a: &[BigInt], b: &[BigInt]) -> bool {
    let (mut p, mut q) = (residues(a), residues(b));
    // A degree that falls could hide a factor.
    if p.last().is_none_or(|x| *x == 0) || q.last().is_none_or(|x| *x == 0) {
        return false;
    }
    if p.len() < q.len() {
        std::mem::swap(&mut p, &mut q);
    }
    while q.len() > 1 {
        remainder(&mut p, &q);
        std::mem::swap(&mut p, &mut q);
    }
    // A constant that is not 0 divides everything.
    !q.is_empty()
}

fn residues(coefficients: &[BigInt]) -> Vec<u64> {
    let prime = BigInt::from(PRIME);
    let residue = |c: &BigInt| {
        let rest = (c % &prime).to_i64().unwrap_or(0);
        if rest < 0 { (rest + PRIME as i64) as u64 } else { rest as u64 }
    };
    coefficients.iter().map(residue).collect()
}

fn times(a: u64, b: u64) -> u64 {
    (u128::from(a) * u128::from(b) % u128::from(PRIME)) as u64
}

fn inverse(a: u64) -> u64 {
    let (mut result, mut square, mut rest) = (1, a, PRIME - 2);
    while rest > 0 {
        if rest & 1 == 1 {
            result = times(result, square);
        }
        square = times(square, square);
        rest >>= 1;
    }
    result
}

/// The remainder of `p` by `q`, whose last coefficient is not 0, without leading zeros.
fn remainder(p: &mut Vec<u64>, q: &[u64]) {
    let Some((lead, lower)) = q.split_last() else { return };
    let unit = inverse(*lead);
    while p.len() >= q.len() {
        let factor = times(p.pop().unwrap_or(0), unit);
        let shift = p.len() - lower.len();
        for (x, y) in p[shift..].iter_mut().zip(lower) {
            *x = (*x + PRIME - times(factor, *y)) % PRIME;
        }
    }
    while p.last() == Some(&0) {
        p.pop();
    }
}
