//! Parts of a surface whose poles all have positive weights: their boxes hold them.

use pforms_kernel::{Form, Result};

use super::patch::Patch;
use super::space::{cross, norm};
use crate::split;

/// A part of a surface and its window.
pub(super) struct Positive {
    pub form: Form,
    /// The largest weight, with the sign that all are to have.
    pub weight: f64,
    pub lower: [f64; 2],
    pub upper: [f64; 2],
}

/// Where parts are cut: not in the middle, where symmetric things have their special points.
const SHARE: f64 = 0.483_721;

impl Positive {
    /// This part, cut until all poles have weights of its sign. The weight itself has it: then few
    /// cuts do.
    pub(super) fn split(self) -> Result<Vec<Self>> {
        let mut waiting = vec![self];
        let mut done = Vec::new();
        while let Some(part) = waiting.pop() {
            let Some(axis) = part.mixed_axis() else {
                done.push(part);
                continue;
            };
            let (before, after) = split(&part.form, axis, &SHARE)?;
            let t = part.lower[axis] + SHARE * (part.upper[axis] - part.lower[axis]);
            let (mut lower, mut upper) = (part.lower, part.upper);
            (lower[axis], upper[axis]) = (t, t);
            let weight = part.weight;
            waiting.extend([
                Self { form: after, weight, lower, upper: part.upper },
                Self { form: before, weight, lower: part.lower, upper },
            ]);
        }
        Ok(done)
    }

    /// Are the tangents along both axes parallel wherever it is looked at?
    pub(super) fn is_collapsed(&self) -> bool {
        let poles = self.form.homogeneous().chunks_exact(4);
        let far = |k: usize| poles.clone().map(move |p| p[k] / p[3].abs()).fold(0.0, f64::max);
        let centre = std::array::from_fn(|k| poles.clone().next().map_or(0.0, |p| p[k] / p[3]));
        let scale = (0..3).map(far).fold(f64::MIN_POSITIVE, f64::max);
        let patch = Patch::new(&self.form, &centre, scale, self.weight);
        (0..25).all(|k| {
            let jet = patch.jet::<false>(f64::from(k / 5) / 4.0, f64::from(k % 5) / 4.0);
            norm(&cross(&jet.u, &jet.v)) <= 1e-12 * norm(&jet.u) * norm(&jet.v)
        })
    }

    /// The axis to cut along: one along which signs change if there is one, the wider of two.
    fn mixed_axis(&self) -> Option<usize> {
        let columns = self.form.orders()[1];
        let weights = self.form.weights();
        let bad = |i: usize| weights[i] * self.weight <= 0.0;
        let first = (0..weights.len()).find(|i| bad(*i))?;
        let (row, column) = (first / columns, first % columns);
        let along = |axis: usize| {
            let line: Vec<usize> = if axis == 0 {
                (0..weights.len() / columns).map(|i| i * columns + column).collect()
            } else {
                (0..columns).map(|j| row * columns + j).collect()
            };
            line.into_iter().any(|i| !bad(i))
        };
        let width = |axis: usize| self.upper[axis] - self.lower[axis];
        let wider = usize::from(width(1) > width(0));
        [wider, 1 - wider].into_iter().find(|axis| along(*axis)).or(Some(wider))
    }
}
