//! Truncated power series of vectors in one variable: what a form does at first order where its
//! derivatives vanish.

use pforms_kernel::{Form, Result, taylor_rows};

use crate::space::quadruples;
use crate::vector::{Vec3, add, cross, scale};

/// Terms kept beyond the constant one: enough for an edge that collapses six times over.
const LAST: usize = 6;

/// Coefficients of `s⁰, s¹, …`.
pub(crate) type Series<T> = [T; LAST + 1];

/// A form along the line `at + s·direction`: its points, its derivatives along each axis, weights.
pub(crate) struct Line {
    points: Series<Vec3>,
    weights: Series<f64>,
    point_slopes: Vec<Series<Vec3>>,
    weight_slopes: Vec<Series<f64>>,
}

impl Line {
    /// The expansion of a form in space, of one or two axes.
    pub(crate) fn new(form: &Form, at: &[f64], direction: &[f64]) -> Result<Self> {
        let mut local = form.clone();
        for (axis, t) in at.iter().enumerate() {
            let degree = form.orders()[axis] - 1;
            local = local.along(axis, &taylor_rows(degree, degree.min(LAST + 1), t))?;
        }
        let mut line = Self {
            points: [[0.0; 3]; LAST + 1],
            weights: [0.0; LAST + 1],
            point_slopes: vec![[[0.0; 3]; LAST + 1]; at.len()],
            weight_slopes: vec![[0.0; LAST + 1]; at.len()],
        };
        let columns = if at.len() == 2 { local.orders()[1] } else { 1 };
        for (flat, &[x, y, z, w]) in quadruples(&local).iter().enumerate() {
            let exponents = [flat / columns, flat % columns];
            line.add_term(&exponents[..at.len()], direction, [x, y, z], w);
        }
        Ok(line)
    }

    /// Adds `(point, weight)·Π sᵢ^eᵢ`, where `sᵢ = directionᵢ·s`, and its partial derivatives.
    fn add_term(&mut self, exponents: &[usize], direction: &[f64], point: Vec3, weight: f64) {
        let monomial = |exponents: &[usize]| {
            let powers = exponents.iter().zip(direction);
            powers.map(|(&e, d)| d.powi(e as i32)).product::<f64>()
        };
        let total: usize = exponents.iter().sum();
        if total <= LAST {
            let factor = monomial(exponents);
            self.points[total] = add(self.points[total], scale(factor, point));
            self.weights[total] += factor * weight;
        }
        for axis in 0..exponents.len() {
            if exponents[axis] == 0 || total - 1 > LAST {
                continue;
            }
            let mut lowered = exponents.to_vec();
            lowered[axis] -= 1;
            let factor = exponents[axis] as f64 * monomial(&lowered);
            let slopes = &mut self.point_slopes[axis][total - 1];
            *slopes = add(*slopes, scale(factor, point));
            self.weight_slopes[axis][total - 1] += factor * weight;
        }
    }

    /// `∂P·w − P·∂w` along `axis`: the derivative of the point, up to the factor `w²`.
    pub(crate) fn slope(&self, axis: usize) -> Series<Vec3> {
        product(|i, j, sum| {
            let rise = scale(self.weights[j], self.point_slopes[axis][i]);
            let fall = scale(-self.weight_slopes[axis][j], self.points[i]);
            add(sum, add(rise, fall))
        })
    }

    /// `∂ᵤ × ∂ᵥ` of the point, up to the factor `w³`.
    pub(crate) fn normal(&self) -> Series<Vec3> {
        let [pu, pv] = [&self.point_slopes[0], &self.point_slopes[1]];
        let [wu, wv] = [&self.weight_slopes[0], &self.weight_slopes[1]];
        let area = product(|i, j, sum| add(sum, cross(pu[i], pv[j])));
        let shift: Series<Vec3> = product(|i, j, sum| {
            let first = scale(wv[j], pu[i]);
            let second = scale(-wu[j], pv[i]);
            add(sum, add(first, second))
        });
        product(|i, j, sum| {
            let flat = scale(self.weights[j], area[i]);
            let tilt = cross(shift[i], self.points[j]);
            add(sum, add(flat, scale(-1.0, tilt)))
        })
    }

    /// The sign of the weight at `s → 0⁺`.
    pub(crate) fn weight_sign(&self) -> f64 {
        self.weights.iter().find(|w| **w != 0.0).map_or(1.0, |w| w.signum())
    }
}

/// The truncated product whose term of index `i + j` is gathered by `gather(i, j, sum)`.
fn product(gather: impl Fn(usize, usize, Vec3) -> Vec3) -> Series<Vec3> {
    let mut series = [[0.0; 3]; LAST + 1];
    for (k, term) in series.iter_mut().enumerate() {
        *term = (0..=k).fold(*term, |sum, i| gather(i, k - i, sum));
    }
    series
}
