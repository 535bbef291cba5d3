//! Bounds of a polynomial where one of its variables is complex.

use std::ops::Range;

use pforms_kernel::{Form, Result, taylor_rows};

use super::rule::{COUNTS, RADII, remainder};

/// A polynomial over its window, one variable in a disc around the middle, the others real.
///
/// Along that axis it is expanded in powers about the middle; along the others it stays in
/// Bernstein's basis, whose values are weights of a mean. So it lies in the convex hull of the
/// values that its lines of coefficients take, and each of these is its constant and a rest.
pub(super) struct Series {
    /// For each of [`RADII`] the least that all constants exceed their rests by; negative where the
    /// polynomial may vanish.
    pub least: [f64; RADII.len()],
    /// For each the largest modulus.
    pub most: [f64; RADII.len()],
    /// How much it varies along the axis.
    pub variation: f64,
}

/// Least share of the largest modulus that counts as more than 0: far above rounding.
const ABOVE: f64 = 1e-9;

impl Series {
    /// The bounds of some components of a form, taken as polynomials; `least` is that of the first.
    pub(super) fn new(form: &Form, axis: usize, components: Range<usize>) -> Result<Self> {
        let (order, width) = (form.orders()[axis], form.width());
        let series = form.along(axis, &taylor_rows(order - 1, order - 1, &0.5))?;
        let inner = form.orders()[axis + 1..].iter().product::<usize>() * width;
        let mut this =
            Self { least: [f64::INFINITY; RADII.len()], most: [0.0; RADII.len()], variation: 0.0 };
        let (mut positive, mut negative) = (true, true);
        let (mut constants, mut rests) = (0.0, 0.0);
        for block in series.homogeneous().chunks_exact(order * inner) {
            for pole in (0..inner).step_by(width) {
                let mut squares = [0.0; RADII.len()];
                for (place, component) in components.clone().enumerate() {
                    let line = block[pole + component..].iter().step_by(inner);
                    let constant = block[pole + component];
                    let rest = rests_of(line);
                    if place == 0 {
                        positive &= constant > 0.0;
                        negative &= constant < 0.0;
                        for (least, rest) in this.least.iter_mut().zip(rest) {
                            *least = least.min(constant.abs() - rest);
                        }
                    }
                    constants += constant.abs();
                    rests += rest[0];
                    for (square, rest) in squares.iter_mut().zip(rest) {
                        *square += (constant.abs() + rest) * (constant.abs() + rest);
                    }
                }
                for (most, square) in this.most.iter_mut().zip(squares) {
                    *most = most.max(square);
                }
            }
        }
        this.most.iter_mut().for_each(|most| *most = most.sqrt());
        this.variation = if rests == 0.0 { 0.0 } else { rests / constants };
        if !positive && !negative {
            this.least = [-1.0; RADII.len()];
        }
        for (least, most) in this.least.iter_mut().zip(this.most) {
            *least -= ABOVE * most;
        }
        Ok(this)
    }
}

/// `Σ |c_j|·R^j` from the second coefficient on, for coefficients over a window of length 1.
fn rests_of<'a>(line: impl Iterator<Item = &'a f64>) -> [f64; RADII.len()] {
    let mut sums = [0.0; RADII.len()];
    let mut powers = [1.0; RADII.len()];
    for coefficient in line.skip(1) {
        for ((sum, power), radius) in sums.iter_mut().zip(&mut powers).zip(RADII) {
            *power *= 0.5 * radius;
            *sum += coefficient.abs() * *power;
        }
    }
    sums
}

/// What is known of the integrand along one axis.
pub(super) struct AlongAxis {
    /// For each of [`RADII`] the largest modulus in the disc, infinite where it is not analytic.
    pub most: [f64; RADII.len()],
    /// Its degree, where it is a polynomial.
    pub degree: Option<usize>,
    /// How much it varies along the axis.
    pub variation: f64,
}

impl AlongAxis {
    /// The fewest nodes whose error is at most `target`, and the error; some nodes, if none are
    /// enough; `None` if the integrand is not shown to be analytic.
    pub(super) fn nodes(&self, target: f64, axes: usize) -> Option<(usize, f64)> {
        let error = |count: usize| match self.degree {
            Some(degree) if degree < 2 * count => 0.0,
            _ => {
                let each = self.most.iter().zip(RADII);
                each.map(|(most, radius)| remainder(*most, radius, count))
                    .fold(f64::INFINITY, f64::min)
            }
        };
        let most = MOST[axes.min(MOST.len()) - 1];
        let counts = COUNTS.into_iter().filter(|count| *count <= most);
        let enough = counts.map(|count| (count, error(count))).find(|(_, error)| *error <= target);
        enough.or_else(|| Some((FALLBACK, error(FALLBACK)))).filter(|(_, error)| error.is_finite())
    }
}

/// Nodes along each axis at most, for one axis, two, three, more.
const MOST: [usize; 4] = [32, 26, 16, 10];

/// Nodes where the target is out of reach and halving is to follow.
const FALLBACK: usize = 8;
