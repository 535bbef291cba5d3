//! Pascal's triangle.

use crate::Scalar;

/// The highest degree whose row is exact in `f64`.
const TABULATED: usize = 56;

/// The first rows, one after another: row `n` begins at `n(n+1)/2`.
static TRIANGLE: [i64; (TABULATED + 1) * (TABULATED + 2) / 2] = triangle();

const fn triangle() -> [i64; (TABULATED + 1) * (TABULATED + 2) / 2] {
    let mut entries = [1; (TABULATED + 1) * (TABULATED + 2) / 2];
    let mut degree = 2;
    while degree <= TABULATED {
        let (start, above) = (degree * (degree + 1) / 2, degree * (degree - 1) / 2);
        let mut k = 1;
        while k < degree {
            entries[start + k] = entries[above + k - 1] + entries[above + k];
            k += 1;
        }
        degree += 1;
    }
    entries
}

/// A row of Pascal's triangle, each entry made when it is asked for.
///
/// From a table up to degree 56. Above, rationals go on by `C(n, k+1) = C(n, k)·(n−k)/(k+1)`; what
/// would round there is summed in the triangle, from the last row of the table.
#[derive(Clone, Debug)]
pub struct Binomials<S> {
    tabulated: &'static [i64],
    computed: Vec<S>,
}

impl<S: Scalar> Binomials<S> {
    /// Row `degree`: exact for rationals; in `f64` exact up to degree 56, and within `degree`
    /// roundings above.
    pub fn of(degree: usize) -> Self {
        if degree <= TABULATED {
            let tabulated = &TRIANGLE[degree * (degree + 1) / 2..][..=degree];
            return Self { tabulated, computed: Vec::new() };
        }
        let computed = if S::EXACT { by_ratios(degree) } else { by_sums(degree) };
        Self { tabulated: &[], computed }
    }

    /// `C(degree, k)`, for `k` up to the degree.
    #[inline]
    pub fn get(&self, k: usize) -> S {
        match self.tabulated.get(k) {
            Some(&entry) => S::from_integer(entry),
            None => self.computed[k].clone(),
        }
    }

    /// All entries.
    #[inline]
    pub fn iter(&self) -> impl Iterator<Item = S> {
        (0..self.tabulated.len() + self.computed.len()).map(|k| self.get(k))
    }
}

/// Row `degree` of Pascal's triangle: `C(degree, 0), …, C(degree, degree)`.
///
/// As right as [`Binomials::of`].
pub fn pascal_row<S: Scalar>(degree: usize) -> Vec<S> {
    Binomials::of(degree).iter().collect()
}

fn by_sums<S: Scalar>(degree: usize) -> Vec<S> {
    let mut row = pascal_row::<S>(TABULATED);
    for _ in TABULATED..degree {
        let mut left = S::zero();
        for entry in &mut row {
            let above = entry.clone();
            *entry += left;
            left = above;
        }
        row.push(S::one());
    }
    row
}

fn by_ratios<S: Scalar>(degree: usize) -> Vec<S> {
    let mut row = Vec::with_capacity(degree + 1);
    row.push(S::one());
    for k in 0..degree {
        row.push(row[k].clone() * S::ratio((degree - k) as i64, k as i64 + 1));
    }
    row
}

/// The binomial coefficient `C(n, k)`; 0 when `k > n`.
pub fn binomial<S: Scalar>(n: usize, k: usize) -> S {
    if k > n {
        return S::zero();
    }
    Binomials::<S>::of(n).get(k)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Rational;

    #[test]
    fn every_row_is_what_its_ratios_say() {
        for degree in 0..=80 {
            let ratios = by_ratios::<Rational>(degree);
            assert_eq!(pascal_row::<Rational>(degree), ratios);
            for (rough, exact) in pascal_row::<f64>(degree).iter().zip(&ratios) {
                let exact = exact.to_f64();
                let roundings = if degree <= TABULATED { 0.0 } else { degree as f64 };
                assert!((rough - exact).abs() <= roundings * f64::EPSILON * exact);
            }
        }
    }
}
