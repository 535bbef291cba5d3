//! The parts of a piece, halved as they are asked for: boxes of points and cones of normals.

use super::cone::Cone;
use super::patch::Patch;
use super::space::{V3, apart, dot, minus, norm};

/// What rounding may do to a coordinate, in units of the largest: pieces of a common size about 1.
pub(super) const NOISE: f64 = 1e-13;

/// Where parts are cut: not in the middle, where symmetric things have their special points.
const SHARE: f64 = 0.483_721;

/// A part of a piece.
pub(super) struct Part {
    pub lower: [f64; 2],
    pub upper: [f64; 2],
    /// Homogeneous poles.
    poles: Vec<[f64; 4]>,
    /// Euclidean poles; none while a weight is not positive.
    points: Vec<V3>,
    low: V3,
    high: V3,
    /// The cone of normals.
    pub normals: Option<Cone>,
    /// Where the part lies along the axis of its normals.
    slab: [f64; 2],
    /// Diagonal of its box.
    pub size: f64,
    /// The axis along which it is longest.
    axis: usize,
    halves: Option<[usize; 2]>,
}

/// A piece with its parts; the whole is part 0.
pub(super) struct Tree {
    pub orders: [usize; 2],
    pub parts: Vec<Part>,
    /// Are the weights products of one factor for each axis? Then tangents are mixtures of
    /// differences of neighbouring poles.
    separable: bool,
}

/// A curve on a piece, where one parameter has a value.
#[derive(Clone)]
pub(super) struct Line {
    pub lower: f64,
    pub upper: f64,
    poles: Vec<[f64; 4]>,
    points: Vec<V3>,
    low: V3,
    high: V3,
    pub tangents: Option<Cone>,
    pub size: f64,
}

impl Tree {
    pub(super) fn new(patch: &Patch) -> Self {
        let separable = is_separable(patch);
        let mut tree = Self { orders: patch.orders, parts: Vec::new(), separable };
        let whole = tree.part([0.0; 2], [1.0; 2], patch.poles.clone());
        tree.parts.push(whole);
        tree
    }

    fn part(&self, lower: [f64; 2], upper: [f64; 2], poles: Vec<[f64; 4]>) -> Part {
        let points = euclidean(&poles);
        let (low, high) = bounds(&points);
        let lengths = [0, 1].map(|axis| longest(&points, self.orders, axis));
        let normals = self.normals(&poles, &points);
        let slab = normals.map_or([0.0; 2], |cone| span(&points, &cone.axis));
        let axis = match (self.orders[0] > 1, self.orders[1] > 1) {
            (true, true) => usize::from(lengths[1] > lengths[0]),
            (first, _) => usize::from(!first),
        };
        let size = if points.is_empty() { f64::INFINITY } else { norm(&minus(&high, &low)) };
        Part { lower, upper, poles, points, low, high, normals, slab, size, axis, halves: None }
    }

    /// The cone of normals: that of the products of tangents along both axes.
    fn normals(&self, poles: &[[f64; 4]], points: &[V3]) -> Option<Cone> {
        if points.is_empty() {
            return None;
        }
        let cone = |axis: usize| {
            if self.separable {
                return Cone::around(steps(points, self.orders, axis), 0.0);
            }
            // The derivative of X/W is along X′ − (X/W)·W′: seen from the centre of the part,
            // X/W is no farther than the part is large.
            let (low, high) = bounds(points);
            let centre: V3 = std::array::from_fn(|k| f64::midpoint(low[k], high[k]));
            let radius = 0.5 * norm(&minus(&high, &low));
            let seen: Vec<V3> = poles
                .iter()
                .map(|pole| std::array::from_fn(|k| pole[k] - centre[k] * pole[3]))
                .collect();
            let weights: Vec<V3> = poles.iter().map(|pole| [pole[3], 0.0, 0.0]).collect();
            let steepest =
                steps(&weights, self.orders, axis).fold(0.0_f64, |most, d| most.max(d[0].abs()));
            Cone::around(steps(&seen, self.orders, axis), radius * steepest)
        };
        Cone::of_normals(&cone(0)?, &cone(1)?)
    }

    /// The two halves of a part, and the axis and the parameter at which they meet.
    pub(super) fn halves(&mut self, number: usize) -> ([usize; 2], usize, f64) {
        let part = &self.parts[number];
        let (axis, lower, upper) = (part.axis, part.lower, part.upper);
        let t = lower[axis] + SHARE * (upper[axis] - lower[axis]);
        if let Some(halves) = part.halves {
            return (halves, axis, t);
        }
        let (left, right) = cut(&part.poles, self.orders, axis);
        let (mut before, mut after) = (upper, lower);
        (before[axis], after[axis]) = (t, t);
        let halves = [self.parts.len(), self.parts.len() + 1];
        let (left, right) = (self.part(lower, before, left), self.part(after, upper, right));
        self.parts.extend([left, right]);
        self.parts[number].halves = Some(halves);
        (halves, axis, t)
    }

    /// The border of a part where `axis` begins or ends.
    pub(super) fn border(&self, number: usize, axis: usize, end: bool) -> Line {
        let part = &self.parts[number];
        let [rows, columns] = self.orders;
        let poles = if axis == 0 {
            let row = if end { rows - 1 } else { 0 };
            part.poles[row * columns..(row + 1) * columns].to_vec()
        } else {
            let column = if end { columns - 1 } else { 0 };
            part.poles.iter().skip(column).step_by(columns).copied().collect()
        };
        Line::new(part.lower[1 - axis], part.upper[1 - axis], poles)
    }
}

impl Part {
    /// Do the boxes and slabs of two parts leave room for a common point?
    pub(super) fn may_meet(&self, other: &Self) -> bool {
        overlap(&self.low, &self.high, &other.low, &other.high)
            && self.slab_meets(&other.points)
            && other.slab_meets(&self.points)
    }

    /// The same for a line.
    pub(super) fn may_meet_line(&self, line: &Line) -> bool {
        overlap(&self.low, &self.high, &line.low, &line.high) && self.slab_meets(&line.points)
    }

    fn slab_meets(&self, points: &[V3]) -> bool {
        let Some(cone) = self.normals.filter(|_| !points.is_empty()) else { return true };
        let [low, high] = span(points, &cone.axis);
        low <= self.slab[1] + NOISE && self.slab[0] <= high + NOISE
    }

    /// How far its normals turn, half of it.
    pub(super) fn turn(&self) -> f64 {
        self.normals.map_or(std::f64::consts::FRAC_PI_2, |cone| cone.angle)
    }

    /// The middle of its window.
    pub(super) fn middle(&self) -> [f64; 2] {
        [0, 1].map(|k| f64::midpoint(self.lower[k], self.upper[k]))
    }
}

impl Line {
    fn new(lower: f64, upper: f64, poles: Vec<[f64; 4]>) -> Self {
        let points = euclidean(&poles);
        let (low, high) = bounds(&points);
        let size = if points.is_empty() { f64::INFINITY } else { norm(&minus(&high, &low)) };
        // Differences of neighbouring euclidean poles span the tangents of any rational curve.
        let tangents = Cone::around(steps(&points, [1, points.len()], 1), 0.0);
        Self { lower, upper, poles, points, low, high, tangents, size }
    }

    /// Its two halves.
    pub(super) fn halves(&self) -> [Self; 2] {
        let (left, right) = cut(&self.poles, [1, self.poles.len()], 1);
        let t = self.lower + SHARE * (self.upper - self.lower);
        [Self::new(self.lower, t, left), Self::new(t, self.upper, right)]
    }

    /// Are all its points one and the same?
    pub(super) fn is_point(&self) -> bool {
        self.points.windows(2).all(|pair| apart(&pair[0], &pair[1]) <= 4.0 * f64::EPSILON)
    }
}

fn euclidean(poles: &[[f64; 4]]) -> Vec<V3> {
    if poles.iter().any(|pole| pole[3] <= 0.0) {
        return Vec::new();
    }
    poles.iter().map(|pole| [pole[0] / pole[3], pole[1] / pole[3], pole[2] / pole[3]]).collect()
}

fn bounds(points: &[V3]) -> (V3, V3) {
    if points.is_empty() {
        return ([f64::NEG_INFINITY; 3], [f64::INFINITY; 3]);
    }
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for point in points {
        for k in 0..3 {
            low[k] = low[k].min(point[k]);
            high[k] = high[k].max(point[k]);
        }
    }
    (low, high)
}

fn overlap(low: &V3, high: &V3, other_low: &V3, other_high: &V3) -> bool {
    (0..3).all(|k| low[k] <= other_high[k] + NOISE && other_low[k] <= high[k] + NOISE)
}

/// Where points lie along an axis.
fn span(points: &[V3], axis: &V3) -> [f64; 2] {
    points.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], point| {
        let x = dot(point, axis);
        [low.min(x), high.max(x)]
    })
}

/// Differences of neighbours along an axis.
fn steps(points: &[V3], orders: [usize; 2], axis: usize) -> impl Iterator<Item = V3> + Clone {
    let stride = if axis == 0 { orders[1] } else { 1 };
    let inside = move |i: &usize| axis == 0 || !(i + 1).is_multiple_of(orders[1]);
    let count = points.len().saturating_sub(stride);
    (0..count).filter(inside).map(move |i| minus(&points[i + stride], &points[i]))
}

/// The longest polygon along an axis.
fn longest(points: &[V3], orders: [usize; 2], axis: usize) -> f64 {
    let mut lengths = vec![0.0; if axis == 0 { orders[1] } else { orders[0] }];
    let per_line = orders[axis] - 1;
    for (i, step) in steps(points, orders, axis).enumerate() {
        let line = if axis == 0 { i % orders[1] } else { i / per_line.max(1) };
        lengths[line] += norm(&step);
    }
    lengths.into_iter().fold(0.0, f64::max)
}

/// The poles of both parts of an array cut along an axis.
fn cut(poles: &[[f64; 4]], orders: [usize; 2], axis: usize) -> (Vec<[f64; 4]>, Vec<[f64; 4]>) {
    let (mut left, mut right) = (poles.to_vec(), poles.to_vec());
    let (stride, count) = (if axis == 0 { orders[1] } else { 1 }, orders[axis]);
    for line in 0..poles.len() / count {
        let start = if axis == 0 { line } else { line * orders[1] };
        let at = |i: usize| start + i * stride;
        for step in 0..count {
            left[at(step)] = right[at(0)];
            for i in 0..count - 1 - step {
                let (a, b) = (right[at(i)], right[at(i + 1)]);
                right[at(i)] = std::array::from_fn(|k| a[k] + SHARE * (b[k] - a[k]));
            }
        }
    }
    (left, right)
}

/// Do the weights of all lines have the same ratios?
fn is_separable(patch: &Patch) -> bool {
    let columns = patch.orders[1];
    let weight = |i: usize| patch.poles[i][3];
    (0..patch.poles.len()).all(|place| {
        let (i, j) = (place / columns, place % columns);
        let (one, other) = (weight(place) * weight(0), weight(i * columns) * weight(j));
        (one - other).abs() <= 8.0 * f64::EPSILON * one.abs()
    })
}
