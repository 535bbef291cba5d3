//! Convexity of a polynomial over the window, from its Bernstein coefficients.
//!
//! The second derivatives, raised to the degrees of the polynomial, have matrices for coefficients.
//! Each of their values is a mean of these; so they are positive definite wherever all of the
//! coefficients are.

/// The derivative along `axis`, raised to the orders of `poles`:
/// `i·(F_i − F_{i−1}) + (m − i)·(F_{i+1} − F_i)`, `m` the degree.
pub(super) fn slope(poles: &[f64], orders: &[usize], axis: usize) -> Vec<f64> {
    let inner: usize = orders[axis + 1..].iter().product();
    let degree = orders[axis] - 1;
    let mut slopes = vec![0.0; poles.len()];
    let blocks = poles.chunks_exact(inner * orders[axis]);
    for (poles, slopes) in blocks.zip(slopes.chunks_exact_mut(inner * orders[axis])) {
        for i in 0..degree {
            let (low, high) = poles[i * inner..][..2 * inner].split_at(inner);
            let (before, after) = slopes[i * inner..][..2 * inner].split_at_mut(inner);
            let (left, right) = ((degree - i) as f64, (i + 1) as f64);
            for (k, (low, high)) in low.iter().zip(high).enumerate() {
                before[k] += left * (high - low);
                after[k] = right * (high - low);
            }
        }
    }
    slopes
}

/// Second derivatives over the window: the coefficients of `∂²F/∂u_k∂u_l` for `k ≤ l`.
pub(super) struct Bends {
    axes: usize,
    coefficients: Vec<Vec<f64>>,
}

impl Bends {
    pub(super) fn new(poles: &[f64], orders: &[usize]) -> Self {
        let axes = orders.len();
        let slopes: Vec<Vec<f64>> = (0..axes).map(|axis| slope(poles, orders, axis)).collect();
        let pairs = (0..axes).flat_map(|k| (k..axes).map(move |l| (k, l)));
        Self { axes, coefficients: pairs.map(|(k, l)| slope(&slopes[k], orders, l)).collect() }
    }

    /// Are all second derivatives, in every direction, at least `least` times its square length?
    pub(super) fn at_least(&self, least: f64) -> bool {
        match &self.coefficients[..] {
            [] => true,
            [second] => second.iter().all(|x| *x > least),
            [uu, uv, vv] => uu.iter().zip(uv).zip(vv).all(|((a, f), q)| {
                let (a, q) = (a - least, q - least);
                a > 0.0 && a * q > f * f
            }),
            [first, ..] => (0..first.len()).all(|place| self.is_definite(place, least)),
        }
    }

    /// Is the matrix at one place positive definite, with `least` taken off its diagonal?
    fn is_definite(&self, place: usize, least: f64) -> bool {
        let mut matrix = vec![0.0; self.axes * self.axes];
        let mut entries = self.coefficients.iter();
        for k in 0..self.axes {
            for l in k..self.axes {
                let entry = entries.next().map_or(0.0, |entry| entry[place]);
                matrix[k * self.axes + l] = entry;
                matrix[l * self.axes + k] = entry;
            }
            matrix[k * self.axes + k] -= least;
        }
        factorise(&mut matrix, self.axes)
    }
}

/// Cholesky's factor in place of the lower half; false unless the matrix is positive definite.
pub(super) fn factorise(matrix: &mut [f64], size: usize) -> bool {
    for k in 0..size {
        for j in 0..=k {
            let dot: f64 = (0..j).map(|i| matrix[k * size + i] * matrix[j * size + i]).sum();
            let rest = matrix[k * size + j] - dot;
            if j < k {
                matrix[k * size + j] = rest / matrix[j * size + j];
            } else if rest > 0.0 {
                matrix[k * size + k] = rest.sqrt();
            } else {
                return false;
            }
        }
    }
    true
}

/// Solves with the factor of [`factorise`].
pub(super) fn solve(factor: &[f64], size: usize, vector: &mut [f64]) {
    for k in 0..size {
        let dot: f64 = (0..k).map(|i| factor[k * size + i] * vector[i]).sum();
        vector[k] = (vector[k] - dot) / factor[k * size + k];
    }
    for k in (0..size).rev() {
        let dot: f64 = (k + 1..size).map(|i| factor[i * size + k] * vector[i]).sum();
        vector[k] = (vector[k] - dot) / factor[k * size + k];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slopes_are_derivatives() {
        // u²·v on degrees (2, 1): its derivative along u is 2·u·v, raised to the same degrees.
        assert_eq!(slope(&[0., 0., 0., 0., 0., 1.], &[3, 2], 0), [0., 0., 0., 1., 0., 2.]);
        assert_eq!(slope(&[0., 0., 0., 0., 0., 1.], &[3, 2], 1), [0., 0., 0., 0., 1., 1.]);
    }

    #[test]
    fn a_bowl_is_convex_and_a_saddle_is_not() {
        // u² ± v² on degrees (2, 2): second derivatives 2 and ±2.
        let bowl = [0., 0., 1., 0., 0., 1., 1., 1., 2.];
        let bends = Bends::new(&bowl, &[3, 3]);
        assert!(bends.at_least(1.999) && !bends.at_least(2.001));
        let saddle = [0., 0., -1., 0., 0., -1., 1., 1., 0.];
        assert!(!Bends::new(&saddle, &[3, 3]).at_least(-1.999));
        assert!(Bends::new(&saddle, &[3, 3]).at_least(-2.001));
    }

    #[test]
    fn a_factor_solves_its_system() {
        let mut matrix = [4.0, 2.0, 2.0, 5.0];
        assert!(factorise(&mut matrix, 2));
        let mut vector = [8.0, 12.0];
        solve(&matrix, 2, &mut vector);
        assert_eq!(vector, [1.0, 2.0]);
        assert!(!factorise(&mut [1.0, 2.0, 2.0, 1.0], 2));
    }
}
