//! A part of the window, and the form over it seen from the point that is projected.

use super::convex::{Bends, slope};
use super::products::Products;
use super::target::Target;
use crate::measuring::vector::norm;

/// A box of parameters with the homogeneous poles of `form − point` over it.
#[derive(Clone)]
pub(super) struct Region {
    /// Least parameters.
    pub lower: Vec<f64>,
    /// Largest parameters.
    pub upper: Vec<f64>,
    poles: Vec<f64>,
    /// By how much a pole may be off.
    noise: f64,
}

/// The margin polynomial of a region, `|X − x·W|² − t²·W²`: positive where the form is farther
/// than `t` from the point `x`.
pub(super) struct Margin {
    /// Its Bernstein coefficients.
    pub coefficients: Vec<f64>,
    /// By how much each of them may be off.
    pub noise: f64,
}

impl Region {
    /// The region of a target from `lower` to `upper`, seen from a point.
    pub(super) fn new(target: &Target, point: &[f64], lower: &[f64], upper: &[f64]) -> Self {
        let mut poles = target.form.homogeneous().to_vec();
        for pole in poles.chunks_exact_mut(point.len() + 1) {
            let weight = pole[point.len()];
            pole.iter_mut().zip(point).for_each(|(x, at)| *x -= at * weight);
        }
        let axes = lower.len();
        let noise = target.noise_at(point);
        let mut region = Self { lower: vec![0.0; axes], upper: vec![1.0; axes], poles, noise };
        let (orders, width) = (target.form.orders(), point.len() + 1);
        for axis in 0..axes {
            if upper[axis] < 1.0 {
                region = region.split(orders, width, axis, upper[axis]).0;
            }
            if lower[axis] > 0.0 {
                region = region.split(orders, width, axis, lower[axis]).1;
            }
        }
        region
    }

    /// The two parts before and after parameter `t` of an axis.
    pub(super) fn split(
        &self,
        orders: &[usize],
        width: usize,
        axis: usize,
        t: f64,
    ) -> (Self, Self) {
        let share = (t - self.lower[axis]) / (self.upper[axis] - self.lower[axis]);
        let largest = self.largest();
        let mut right = self.clone();
        right.noise += orders[axis] as f64 * f64::EPSILON * largest;
        let mut left = right.clone();
        let inner = orders[axis + 1..].iter().product::<usize>() * width;
        let blocks = left.poles.chunks_exact_mut(inner * orders[axis]);
        for (left, right) in blocks.zip(right.poles.chunks_exact_mut(inner * orders[axis])) {
            casteljau(left, right, inner, share);
        }
        left.upper[axis] = t;
        right.lower[axis] = t;
        (left, right)
    }

    /// The margin over `t`.
    pub(super) fn margin(&self, products: &Products, width: usize, t: f64) -> Margin {
        let pole = |i: usize| &self.poles[i * width..][..width];
        let square = t * t;
        let mut coefficients = Vec::new();
        products.sum(
            |i, j| {
                let (a, b) = (pole(i), pole(j));
                let ambient = width - 1;
                let dot: f64 = a[..ambient].iter().zip(b).map(|(x, y)| x * y).sum();
                dot - square * a[ambient] * b[ambient]
            },
            &mut coefficients,
        );
        let reach = self.poles.chunks_exact(width).fold(0.0_f64, |most, pole| {
            let (weight, rest) = pole.split_last().unwrap_or((&0.0, &[]));
            most.max(rest.iter().map(|x| x * x).sum::<f64>() + square * weight * weight)
        });
        let terms = (self.poles.len() / width + width + 8) as f64;
        let noise = terms * f64::EPSILON * reach + 8.0 * reach.sqrt() * self.noise;
        Margin { coefficients, noise }
    }

    /// No point of the form over the region is nearer than this.
    pub(super) fn least_distance(&self, products: &Products, width: usize) -> f64 {
        let Margin { coefficients, noise } = self.margin(products, width, 0.0);
        let mut weights = Vec::new();
        let weight = |i: usize| self.poles[i * width + width - 1];
        products.sum(|i, j| weight(i) * weight(j), &mut weights);
        let pairs = coefficients.iter().zip(&weights);
        let least = pairs.fold(f64::INFINITY, |least, (square, weight)| {
            // A mean of quotients bounds the quotient of means when the weights are positive.
            least.min(if *weight > 0.0 { (square - noise) / weight } else { 0.0 })
        });
        least.max(0.0).sqrt()
    }

    /// The corner that is nearest, and its distance.
    pub(super) fn nearest_corner(&self, orders: &[usize], width: usize) -> (f64, Vec<f64>) {
        let mut nearest = (f64::INFINITY, self.lower.clone());
        for choice in 0..1_usize << orders.len().min(16) {
            let far = |axis: usize| choice >> axis & 1 == 1;
            let index = |axis: usize| if far(axis) { orders[axis] - 1 } else { 0 };
            let place = (0..orders.len()).fold(0, |place, k| place * orders[k] + index(k));
            let pole = &self.poles[place * width..][..width];
            let (weight, offset) = pole.split_last().unwrap_or((&1.0, &[]));
            let distance = norm(offset) / weight.abs();
            if distance < nearest.0 {
                let side =
                    |axis: usize| if far(axis) { self.upper[axis] } else { self.lower[axis] };
                nearest = (distance, (0..orders.len()).map(side).collect());
            }
        }
        nearest
    }

    /// An upper bound of the distance between any two poles.
    pub(super) fn diameter(&self, width: usize) -> f64 {
        let ambient = width - 1;
        let mut square = 0.0;
        for k in 0..ambient {
            let values = self.poles.chunks_exact(width).map(|pole| pole[k] / pole[ambient]);
            let (low, high) =
                values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
            square += (high - low) * (high - low);
        }
        f64::sqrt(square)
    }

    fn largest(&self) -> f64 {
        self.poles.iter().fold(0.0, |most, x| most.max(x.abs()))
    }
}

impl Margin {
    /// Is every point of the region farther, beyond doubt?
    pub(super) fn is_positive(&self) -> bool {
        self.coefficients.iter().all(|x| *x > self.noise)
    }

    /// The face of the region on which the margin is least: along the axes where it only rises or
    /// only falls, beyond doubt or but for `slack` times what rounding may do.
    pub(super) fn lowest_face(&self, orders: &[usize], slack: f64) -> Face {
        let mut face =
            Face { sides: Vec::new(), margin: self.coefficients.clone(), noise: self.noise };
        for (axis, order) in orders.iter().enumerate() {
            let bound = slack * 2.0 * (order - 1) as f64 * self.noise;
            let slopes = slope(&self.coefficients, orders, axis);
            let side = if slopes.iter().all(|x| *x > -bound) {
                Some(0)
            } else if slopes.iter().all(|x| *x < bound) {
                Some(order - 1)
            } else {
                None
            };
            face.sides.push(side);
        }
        face.restrict(orders);
        face
    }

    /// The axis along which the coefficients differ most.
    pub(super) fn steepest(&self, orders: &[usize]) -> usize {
        let mut steepest = (0, -1.0);
        let mut inner = self.coefficients.len();
        for (axis, order) in orders.iter().enumerate() {
            let block = inner;
            inner /= order;
            let steps = self
                .coefficients
                .chunks_exact(block)
                .flat_map(|part| part.iter().zip(&part[inner..]).map(|(a, b)| (a - b).abs()));
            let most = steps.fold(0.0, f64::max);
            if most > steepest.1 {
                steepest = (axis, most);
            }
        }
        steepest.0
    }
}

/// A face of a region, or all of it, and the margin there.
pub(super) struct Face {
    /// For each axis the pole it is held at, if it is.
    pub sides: Vec<Option<usize>>,
    margin: Vec<f64>,
    noise: f64,
}

impl Face {
    fn restrict(&mut self, orders: &[usize]) {
        let mut outer = 1;
        let mut inner: usize = orders.iter().product();
        for (side, order) in self.sides.iter().zip(orders) {
            inner /= order;
            if let Some(i) = side {
                let lines = (0..outer).map(|block| (block * order + i) * inner);
                self.margin = lines.flat_map(|at| self.margin[at..at + inner].to_vec()).collect();
            } else {
                outer *= order;
            }
        }
    }

    /// The second derivatives on the face, in units of the region, and by how much they may be off.
    pub(super) fn bends(&self, orders: &[usize]) -> (Bends, f64) {
        let pairs = self.sides.iter().zip(orders).filter(|(side, _)| side.is_none());
        let orders: Vec<usize> = pairs.map(|(_, order)| *order).collect();
        let degree = orders.iter().fold(0, |most, order| most.max(order - 1)) as f64;
        let noise = 4.0 * degree * degree * orders.len() as f64 * self.noise;
        (Bends::new(&self.margin, &orders), noise)
    }

    /// The parameters of the face.
    pub(super) fn of(&self, region: &Region) -> (Vec<f64>, Vec<f64>) {
        let (mut lower, mut upper) = (region.lower.clone(), region.upper.clone());
        for (axis, side) in self.sides.iter().enumerate() {
            match side {
                Some(0) => upper[axis] = lower[axis],
                Some(_) => lower[axis] = upper[axis],
                None => {}
            }
        }
        (lower, upper)
    }
}

/// De Casteljau's scheme at `t` on lines of `inner` numbers: both are given the poles of the whole;
/// `left` keeps those of `[0, t]`, `right` those of `[t, 1]`.
fn casteljau(left: &mut [f64], right: &mut [f64], inner: usize, t: f64) {
    let order = right.len() / inner;
    for step in 1..order {
        for place in 0..(order - step) * inner {
            right[place] = (1.0 - t) * right[place] + t * right[place + inner];
        }
        left[step * inner..][..inner].copy_from_slice(&right[..inner]);
    }
}
