//! The rule of Gauss and Legendre, and basis functions at its nodes.

use pforms_kernel::bernstein_row;

use super::energy::differences;
use crate::algebra::Knots;

/// The functions of one axis at one node: those from `first` on that are not 0 there.
pub(super) struct Node {
    pub weight: f64,
    pub first: usize,
    /// Values, first and second derivatives.
    pub rows: [Vec<f64>; 3],
}

impl Node {
    /// The poles whose functions are not 0 here.
    pub(super) fn poles(&self) -> std::ops::Range<usize> {
        self.first..self.first + self.rows[0].len()
    }

    /// A line of poles mixed by the functions, or their first or second derivatives.
    pub(super) fn mix(&self, line: &[f64], derivative: usize, sum: &mut [f64]) {
        sum.fill(0.0);
        let poles = line[self.first * sum.len()..].chunks_exact(sum.len());
        for (factor, pole) in self.rows[derivative].iter().zip(poles) {
            sum.iter_mut().zip(pole).for_each(|(sum, x)| *sum += factor * x);
        }
    }
}

/// `count` nodes for each piece.
pub(super) fn nodes(knots: &Knots, count: usize) -> Vec<Node> {
    let rule = rule(count);
    let mut nodes = Vec::new();
    for (length, first, poles) in knots.bezier_rows() {
        let mut unit = 1.0;
        let mut rows = poles;
        let mut derivatives = Vec::with_capacity(3);
        for _ in 0..3 {
            derivatives.push((rows.clone(), unit));
            rows = differences(rows, 1);
            unit /= length;
        }
        for &(t, weight) in &rule {
            let row = |(rows, unit): &(Vec<Vec<f64>>, f64)| mixed(rows, t, *unit, knots.degree());
            let rows = [row(&derivatives[0]), row(&derivatives[1]), row(&derivatives[2])];
            nodes.push(Node { weight: weight * length, first, rows });
        }
    }
    nodes
}

/// The rows mixed by Bernstein's polynomials at `t`; zeros, `degree + 1` of them, when none is left.
fn mixed(rows: &[Vec<f64>], t: f64, unit: f64, degree: usize) -> Vec<f64> {
    let mut sum = vec![0.0; degree + 1];
    if let Some(last) = rows.len().checked_sub(1) {
        for (factor, row) in bernstein_row(last, &t).iter().zip(rows) {
            sum.iter_mut().zip(row).for_each(|(sum, x)| *sum += factor * unit * x);
        }
    }
    sum
}

/// Nodes and weights on [0, 1], by Newton's method on Legendre's polynomial.
fn rule(count: usize) -> Vec<(f64, f64)> {
    let node = |k: usize| {
        let mut x = libm::cos(std::f64::consts::PI * (k as f64 + 0.75) / (count as f64 + 0.5));
        for _ in 0..8 {
            let (value, slope) = legendre(count, x);
            x -= value / slope;
        }
        let slope = legendre(count, x).1;
        ((1.0 - x) / 2.0, 1.0 / ((1.0 - x * x) * slope * slope))
    };
    (0..count).map(node).collect()
}

/// Legendre's polynomial and its derivative, inside (−1, 1).
fn legendre(degree: usize, x: f64) -> (f64, f64) {
    let (mut before, mut value) = (1.0, x);
    for k in 2..=degree {
        let k = k as f64;
        (before, value) = (value, ((2.0 * k - 1.0) * x * value - (k - 1.0) * before) / k);
    }
    (value, degree as f64 * (x * value - before) / (x * x - 1.0))
}
