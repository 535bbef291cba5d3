//! The rules of Gauss and Legendre, and the error they are proved to make.

use std::collections::HashMap;

use pforms_kernel::{Matrix, bernstein_row};

/// Numbers of nodes to choose from.
pub(super) const COUNTS: [usize; 10] = [3, 4, 6, 8, 10, 12, 16, 20, 26, 32];

/// Half axes of the ellipses in which integrands are bounded, in halves of the window.
pub(super) const RADII: [f64; 9] = [1.08, 1.25, 1.5, 1.8, 2.3, 3.0, 4.5, 7.0, 12.0];

/// The error over a window of length 1 of `count` nodes for an integrand that is analytic and at most
/// `most` in the ellipse of Bernstein with the long half axis `radius`: half of `64/15·M·ρ^(2−2n)/(1−ρ⁻²)`
/// with `ρ = R + √(R² − 1)`. Trefethen, *Approximation Theory and Approximation Practice*, theorem 19.3.
pub(super) fn remainder(most: f64, radius: f64, count: usize) -> f64 {
    let rho = radius + (radius * radius - 1.0).sqrt();
    let rule = 32.0 / 15.0 * rho.powi(2 - 2 * count as i32) / (1.0 - rho.powi(-2));
    rule * most
}

/// Nodes on `[0, 1]` and their weights.
#[derive(Clone, Debug)]
pub(super) struct Rule {
    pub nodes: Vec<f64>,
    pub weights: Vec<f64>,
}

impl Rule {
    /// The nodes by Newton's method on Legendre's polynomial, from Tricomi's starts.
    pub(super) fn new(count: usize) -> Self {
        let legendre = |x: f64| {
            let (mut before, mut here) = (1.0, x);
            for k in 2..=count {
                let k = k as f64;
                (before, here) = (here, ((2.0 * k - 1.0) * x * here - (k - 1.0) * before) / k);
            }
            (here, count as f64 * (x * here - before) / (x * x - 1.0))
        };
        let (mut nodes, mut weights) = (vec![0.0; count], vec![0.0; count]);
        for i in 0..count.div_ceil(2) {
            let angle = std::f64::consts::PI * (i as f64 + 0.75) / (count as f64 + 0.5);
            let middle = 2 * i + 1 == count;
            let mut x = if middle { 0.0 } else { -libm::cos(angle) };
            for _ in 0..NEWTON {
                let (value, slope) = legendre(x);
                x -= if middle { 0.0 } else { value / slope };
            }
            let slope = legendre(x).1;
            let weight = 1.0 / ((1.0 - x * x) * slope * slope);
            for (place, x) in [(i, x), (count - 1 - i, -x)] {
                nodes[place] = f64::midpoint(1.0, x);
                weights[place] = weight;
            }
        }
        Self { nodes, weights }
    }
}

/// Steps after which the nodes have all their digits; the starts have some four.
const NEWTON: usize = 6;

/// Rules, and Bernstein's polynomials at their nodes.
#[derive(Debug, Default)]
pub(super) struct Rules {
    rules: HashMap<usize, Rule>,
    rows: HashMap<(usize, usize), Matrix>,
}

impl Rules {
    /// The rule of so many nodes.
    pub(super) fn rule(&mut self, count: usize) -> &Rule {
        self.rules.entry(count).or_insert_with(|| Rule::new(count))
    }

    /// A row of Bernstein values of this degree for each node.
    pub(super) fn rows(&mut self, degree: usize, count: usize) -> &Matrix {
        let nodes = self.rule(count).nodes.clone();
        self.rows.entry((degree, count)).or_insert_with(|| {
            let table: Vec<Vec<f64>> = nodes.iter().map(|t| bernstein_row(degree, t)).collect();
            Matrix::from_rule(count, degree + 1, |i, j| table[i][j])
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rules_integrate_powers() {
        for count in COUNTS {
            let rule = Rule::new(count);
            for power in 0..2 * count {
                let values = rule.nodes.iter().map(|x| x.powi(power as i32));
                let sum: f64 =
                    values.zip(&rule.weights).map(|(value, weight)| value * weight).sum();
                assert!((sum - 1.0 / (power as f64 + 1.0)).abs() < 1e-15, "{count} {power}");
            }
        }
    }

    /// `1/(c − x)` has its pole outside of the ellipse, and its integral is a logarithm.
    #[test]
    fn remainders_bound_what_is_left() {
        let pole = 1.3_f64;
        for radius in [1.05, 1.1, 1.2] {
            for count in [3, 6, 10] {
                let rule = Rule::new(count);
                let values = rule.nodes.iter().map(|x| 1.0 / (pole - (2.0 * x - 1.0)));
                let sum: f64 =
                    values.zip(&rule.weights).map(|(value, weight)| value * weight).sum();
                let exact = 0.5 * ((pole + 1.0) / (pole - 1.0)).ln();
                let bound = remainder(1.0 / (pole - radius), radius, count);
                assert!((sum - exact).abs() <= bound, "{radius} {count}");
            }
        }
    }
}
