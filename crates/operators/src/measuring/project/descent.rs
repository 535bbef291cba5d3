//! Down to a nearest point by Newton's steps, never out of a box of parameters.

use pforms_kernel::{Form, taylor_rows};

use super::convex::{factorise, solve};
use crate::measuring::vector::{dot, norm};

/// A point of the form where descent ended, with what was known there.
#[derive(Clone, Debug)]
pub(super) struct Foot {
    /// Its parameters.
    pub parameters: Vec<f64>,
    /// Its distance.
    pub distance: f64,
    /// Half the derivatives of the square distance.
    gradient: Vec<f64>,
    /// Half its second derivatives, then those without the form's own bending.
    hessian: Vec<f64>,
    metric: Vec<f64>,
}

/// Steps of a descent: Newton's need some five, halved ones more.
const STEPS: usize = 64;

/// Halvings of a step before it counts as none.
const HALVINGS: usize = 40;

/// Halvings of a Newton step before another direction is tried.
const FEW: usize = 6;

impl Foot {
    /// The form at parameters, seen from a point.
    pub(super) fn at(form: &Form, point: &[f64], parameters: Vec<f64>) -> Self {
        let axes = parameters.len();
        let jet = Jet::at(form, &parameters);
        let offset: Vec<f64> = jet.point.iter().zip(point).map(|(x, y)| x - y).collect();
        let gradient = jet.first.iter().map(|first| dot(&offset, first)).collect();
        let mut metric = vec![0.0; axes * axes];
        let mut hessian = metric.clone();
        let mut second = jet.second.iter();
        for k in 0..axes {
            for l in k..axes {
                let bend = second.next().map_or(0.0, |second| dot(&offset, second));
                let product = dot(&jet.first[k], &jet.first[l]);
                for place in [k * axes + l, l * axes + k] {
                    metric[place] = product;
                    hessian[place] = product + bend;
                }
            }
        }
        let distance = norm(&offset);
        Self { parameters, distance, gradient, hessian, metric }
    }

    /// The foot that descent from here ends at, between `lower` and `upper`.
    pub(super) fn descended(self, form: &Form, from: &[f64], lower: &[f64], upper: &[f64]) -> Self {
        let mut foot = self;
        for _ in 0..STEPS {
            let free = foot.free(lower, upper);
            let next = foot
                .newton_step(&free)
                .and_then(|step| foot.stepped(&step, FEW, form, from, lower, upper))
                .or_else(|| {
                    let step = foot.scaled_gradient(&free);
                    foot.stepped(&step, HALVINGS, form, from, lower, upper)
                });
            match next {
                Some(next) => foot = next,
                None => break,
            }
        }
        foot
    }

    /// How much less the square distance may be elsewhere in a box over which half its second
    /// derivatives, in units of the box, are at least `least`; by its slope alone if that is 0.
    pub(super) fn deficit(&self, lower: &[f64], upper: &[f64], least: f64, noise: f64) -> f64 {
        let axes = self.gradient.len();
        let free = self.free(lower, upper);
        let slopes = (0..axes).map(|axis| {
            let slope = if free.contains(&axis) { self.gradient[axis].abs() } else { 0.0 };
            let length = self.metric[axis * axes + axis].sqrt();
            (slope + noise * length) * (upper[axis] - lower[axis])
        });
        if least > 0.0 {
            return slopes.map(|slope| slope * slope).sum::<f64>() / least;
        }
        2.0 * slopes.sum::<f64>()
    }

    /// The least of half the second derivatives, in units of a box, or a lower bound of it.
    pub(super) fn least_bend(&self, lower: &[f64], upper: &[f64]) -> f64 {
        let axes = self.gradient.len();
        let wide: Vec<usize> = (0..axes).filter(|axis| upper[*axis] > lower[*axis]).collect();
        let side = |axis: usize| upper[axis] - lower[axis];
        let pairs = wide.iter().flat_map(|k| wide.iter().map(move |l| (*k, *l)));
        let mut matrix: Vec<f64> =
            pairs.map(|(k, l)| self.hessian[k * axes + l] * side(k) * side(l)).collect();
        let size = wide.len();
        if !factorise(&mut matrix, size) {
            return 0.0;
        }
        // 1 / |H⁻¹| ≥ 1 / trace(H⁻¹).
        let mut trace = 0.0;
        for axis in 0..size {
            let mut unit = vec![0.0; size];
            unit[axis] = 1.0;
            solve(&matrix, size, &mut unit);
            trace += unit[axis];
        }
        if size == 0 { 1.0 } else { 1.0 / trace }
    }

    /// Axes along which it is not held by a side of the box.
    fn free(&self, lower: &[f64], upper: &[f64]) -> Vec<usize> {
        let held = |axis: &usize| {
            let (t, slope) = (self.parameters[*axis], self.gradient[*axis]);
            (t <= lower[*axis] && slope >= 0.0) || (t >= upper[*axis] && slope <= 0.0)
        };
        (0..self.parameters.len()).filter(|axis| !held(axis)).collect()
    }

    /// Newton's step on the free axes; Gauss's and Newton's where the square distance is not convex.
    fn newton_step(&self, free: &[usize]) -> Option<Vec<f64>> {
        let axes = self.gradient.len();
        let part = |matrix: &[f64]| -> Vec<f64> {
            let pairs = free.iter().flat_map(|k| free.iter().map(move |l| k * axes + l));
            pairs.map(|place| matrix[place]).collect()
        };
        let size = free.len();
        let mut matrix = part(&self.hessian);
        if !factorise(&mut matrix, size) {
            matrix = part(&self.metric);
            if !factorise(&mut matrix, size) {
                return None;
            }
        }
        let mut reduced: Vec<f64> = free.iter().map(|axis| -self.gradient[*axis]).collect();
        solve(&matrix, size, &mut reduced);
        Some(self.spread(free, &reduced))
    }

    /// A step against the slope, axis by axis.
    fn scaled_gradient(&self, free: &[usize]) -> Vec<f64> {
        let axes = self.gradient.len();
        let entry = |axis: &usize| {
            let square = self.metric[axis * axes + axis].max(self.hessian[axis * axes + axis]);
            if square > 0.0 { -self.gradient[*axis] / square } else { 0.0 }
        };
        self.spread(free, &free.iter().map(entry).collect::<Vec<_>>())
    }

    fn spread(&self, free: &[usize], reduced: &[f64]) -> Vec<f64> {
        let mut step = vec![0.0; self.gradient.len()];
        free.iter().zip(reduced).for_each(|(axis, x)| step[*axis] = *x);
        step
    }

    /// The foot after the step, or after a half, a quarter … of it, that is nearer; close to the
    /// end, where distances no longer tell, that has the lesser slope.
    fn stepped(
        &self,
        step: &[f64],
        halvings: usize,
        form: &Form,
        from: &[f64],
        lower: &[f64],
        upper: &[f64],
    ) -> Option<Self> {
        let mut share = 1.0;
        for _ in 0..halvings {
            let parameters: Vec<f64> = (0..step.len())
                .map(|k| (self.parameters[k] + share * step[k]).clamp(lower[k], upper[k]))
                .collect();
            if parameters == self.parameters {
                return None;
            }
            let next = Self::at(form, from, parameters);
            let level = next.distance <= self.distance * (1.0 + 4.0 * f64::EPSILON);
            let flatter = next.slope(lower, upper) < 0.5 * self.slope(lower, upper);
            if next.distance < self.distance * (1.0 - 1e-10) || (level && flatter) {
                return Some(next);
            }
            share *= 0.5;
        }
        None
    }

    /// The slope along the free axes.
    fn slope(&self, lower: &[f64], upper: &[f64]) -> f64 {
        let free = self.free(lower, upper);
        free.iter().fold(0.0, |most, axis| most.max(self.gradient[*axis].abs()))
    }
}

/// Euclidean derivatives at one place.
struct Jet {
    point: Vec<f64>,
    first: Vec<Vec<f64>>,
    /// For `k ≤ l`, in that order.
    second: Vec<Vec<f64>>,
}

impl Jet {
    fn at(form: &Form, parameters: &[f64]) -> Self {
        let axes = parameters.len();
        let degree = |axis: usize| form.orders()[axis] - 1;
        let rows: Vec<_> =
            (0..axes).map(|axis| taylor_rows(degree(axis), 2, &parameters[axis])).collect();
        let homogeneous = |along: &[usize]| {
            let mut line = form.homogeneous().to_vec();
            for (axis, rows) in rows.iter().enumerate() {
                let order = along.iter().filter(|k| **k == axis).count();
                let factor = if order == 2 { 2.0 } else { 1.0 };
                line = contracted(&line, rows.row(order), factor);
            }
            line
        };
        let (mut point, weight) = parted(homogeneous(&[]));
        for x in &mut point {
            *x /= weight;
        }
        let mut slopes = Vec::new();
        let mut first: Vec<Vec<f64>> = Vec::new();
        for k in 0..axes {
            let (mut vector, slope) = parted(homogeneous(&[k]));
            vector.iter_mut().zip(&point).for_each(|(x, p)| *x = (*x - p * slope) / weight);
            slopes.push(slope);
            first.push(vector);
        }
        let mut second = Vec::new();
        for k in 0..axes {
            for l in k..axes {
                let (mut vector, bend) = parted(homogeneous(&[k, l]));
                for (c, x) in vector.iter_mut().enumerate() {
                    let mixed = first[k][c] * slopes[l] + first[l][c] * slopes[k];
                    *x = (*x - mixed - point[c] * bend) / weight;
                }
                second.push(vector);
            }
        }
        Self { point, first, second }
    }
}

fn contracted(poles: &[f64], row: &[f64], factor: f64) -> Vec<f64> {
    let inner = poles.len() / row.len();
    let mut line = vec![0.0; inner];
    for (coefficient, part) in row.iter().zip(poles.chunks_exact(inner)) {
        line.iter_mut().zip(part).for_each(|(sum, x)| *sum += factor * coefficient * x);
    }
    line
}

fn parted(mut homogeneous: Vec<f64>) -> (Vec<f64>, f64) {
    let weight = homogeneous.pop().unwrap_or(1.0);
    (homogeneous, weight)
}
