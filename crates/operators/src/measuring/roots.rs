//! Where a polynomial in Bernstein form changes its sign.

/// Halvings before an interval counts as a point: the window then is 2⁻⁵³ wide.
const FINEST: u32 = 53;

/// The parameters inside `(0, 1)` where the polynomial with these Bernstein coefficients goes from
/// one sign to the other, in order; where it only touches 0 is not among them.
///
/// A part without a change of sign among its coefficients has no root, one with a single change has
/// exactly one (variation diminishing): parts are halved until one or the other holds, or the part
/// is 2⁻⁵³ wide. Lane and Riesenfeld, *Bounds on a polynomial*, 1981.
pub(crate) fn sign_changes(coefficients: &[f64]) -> Vec<f64> {
    let mut found = Vec::new();
    search(coefficients, 0.0, 1.0, 0, &mut found);
    found
}

fn search(coefficients: &[f64], from: f64, to: f64, depth: u32, found: &mut Vec<f64>) {
    let middle = f64::midpoint(from, to);
    match variations(coefficients) {
        0 => {}
        odd if depth == FINEST || from == middle || middle == to => {
            if odd % 2 == 1 {
                found.push(middle);
            }
        }
        1 => found.push(from + (to - from) * single_root(coefficients)),
        _ => {
            let (low, high) = halves(coefficients);
            search(&low, from, middle, depth + 1, found);
            // A root at the very middle ends one half and begins the other.
            if let (Some(before), Some(after)) = (last_sign(&low), first_sign(&high))
                && low[low.len() - 1] == 0.0
                && before != after
            {
                found.push(middle);
            }
            search(&high, middle, to, depth + 1, found);
        }
    }
}

fn signs(coefficients: &[f64]) -> impl DoubleEndedIterator<Item = bool> {
    coefficients.iter().filter(|x| **x != 0.0).map(|x| *x > 0.0)
}

fn first_sign(coefficients: &[f64]) -> Option<bool> {
    signs(coefficients).next()
}

fn last_sign(coefficients: &[f64]) -> Option<bool> {
    signs(coefficients).next_back()
}

/// Changes of sign from coefficient to coefficient, zeros passed over.
fn variations(coefficients: &[f64]) -> usize {
    let all: Vec<bool> = signs(coefficients).collect();
    all.windows(2).filter(|pair| pair[0] != pair[1]).count()
}

/// De Casteljau at a half.
fn halves(coefficients: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let mut rest = coefficients.to_vec();
    let mut low = Vec::with_capacity(rest.len());
    let mut high = Vec::with_capacity(rest.len());
    while let (Some(&first), Some(&last)) = (rest.first(), rest.last()) {
        low.push(first);
        high.push(last);
        rest = rest.windows(2).map(|pair| f64::midpoint(pair[0], pair[1])).collect();
    }
    high.reverse();
    (low, high)
}

/// The root of a polynomial whose coefficients change sign once: regula falsi, the Illinois way,
/// which keeps it between two bounds.
fn single_root(coefficients: &[f64]) -> f64 {
    let value = |t: f64| {
        let mut row = coefficients.to_vec();
        for length in (1..row.len()).rev() {
            for i in 0..length {
                row[i] = (1.0 - t) * row[i] + t * row[i + 1];
            }
        }
        row[0]
    };
    // Coefficients of 0 at an end put a root there that is no change: the signs are those inside.
    let rising = last_sign(coefficients) == Some(true);
    let sign = |x: f64| if rising { x } else { -x };
    let (mut low, mut high) = (0.0_f64, 1.0_f64);
    let (mut below, mut above) = (-1.0_f64, 1.0_f64);
    let (start, end) = (sign(coefficients[0]), sign(coefficients[coefficients.len() - 1]));
    if start < 0.0 && end > 0.0 {
        (below, above) = (start, end);
    }
    let mut side = 0;
    for step in 0..200 {
        let secant = low + (high - low) * (-below / (above - below));
        let middle = f64::midpoint(low, high);
        // Every third step halves, so that the interval surely shrinks.
        let t = if step % 3 == 2 || !(low < secant && secant < high) { middle } else { secant };
        if t == low || t == high {
            break;
        }
        let here = sign(value(t));
        if here == 0.0 {
            return t;
        }
        if here < 0.0 {
            (low, below) = (t, here);
            above *= if side == -1 { 0.5 } else { 1.0 };
            side = -1;
        } else {
            (high, above) = (t, here);
            below *= if side == 1 { 0.5 } else { 1.0 };
            side = 1;
        }
    }
    f64::midpoint(low, high)
}

#[cfg(test)]
mod tests {
    use super::sign_changes;

    /// Bernstein coefficients of `Π (t − r)`.
    fn with_roots(roots: &[f64]) -> Vec<f64> {
        let mut product = vec![1.0];
        for root in roots {
            let degree = product.len() as f64;
            let mut next = vec![0.0; product.len() + 1];
            for (i, c) in product.iter().enumerate() {
                next[i] += c * -root * (degree - i as f64) / degree;
                next[i + 1] += c * (1.0 - root) * (i as f64 + 1.0) / degree;
            }
            product = next;
        }
        product
    }

    #[test]
    fn changes_are_found_and_touches_are_not() {
        for (roots, changes) in [
            (vec![0.25], vec![0.25]),
            (vec![0.2, 0.5, 0.9], vec![0.2, 0.5, 0.9]),
            (vec![0.5], vec![0.5]),
            (vec![0.25, 0.25, 0.75], vec![0.75]),
            (vec![-1.0, 2.0], vec![]),
            (vec![0.0, 1.0], vec![]),
            (vec![0.0, 0.375, 1.0], vec![0.375]),
        ] {
            let found = sign_changes(&with_roots(&roots));
            assert_eq!(found.len(), changes.len(), "{roots:?}: {found:?}");
            // Coefficients carry some roundings; a root of slope near 1 moves by as many.
            assert!(found.iter().zip(&changes).all(|(a, b)| (a - b).abs() < 1e-13), "{found:?}");
        }
        assert!(sign_changes(&[0.0, 0.0]).is_empty());
        assert!(sign_changes(&[]).is_empty());
    }

    #[test]
    fn a_triple_root_is_one_change() {
        let found = sign_changes(&with_roots(&[0.3, 0.3, 0.3]));
        // The cube root of a rounding.
        assert!(found.len() % 2 == 1 && found.iter().all(|t| (t - 0.3).abs() < 1e-4), "{found:?}");
    }
}
