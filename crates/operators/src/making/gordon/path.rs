//! A curve that is followed by its parameter, from 0 to 1.

use pforms_kernel::{Form, Result};

use crate::algebra::Spline;
use crate::measuring::vector::{norm, plus};

/// Parameters that differ less are one and the same knot.
const SAME: f64 = 1e-10;

/// Points looked at on a curve, at least.
const POINTS: usize = 96;

/// The pieces of a curve, and where they begin and end.
pub(super) struct Path {
    spline: Spline,
    breaks: Vec<f64>,
    pieces: Vec<Form>,
}

/// On which side of a knot.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Side {
    Before,
    After,
}

impl Path {
    /// The curve over the window from 0 to 1.
    pub(super) fn new(curve: &Spline) -> Result<Self> {
        let spline = curve.on_window(0, &0.0, &1.0)?;
        Ok(Self { breaks: spline.breaks().concat(), pieces: spline.pieces()?, spline })
    }

    /// The same curve run backwards.
    pub(super) fn reversed(&self) -> Result<Self> {
        Self::new(&self.spline.reverse(0)?)
    }

    pub(super) fn spline(&self) -> &Spline {
        &self.spline
    }

    fn place(&self, t: f64, side: Side) -> (usize, f64) {
        let last = self.pieces.len() - 1;
        let near = match side {
            Side::After => self.breaks.partition_point(|knot| *knot <= t + SAME),
            Side::Before => self.breaks.partition_point(|knot| *knot < t - SAME),
        };
        let piece = near.saturating_sub(1).min(last);
        let (from, to) = (self.breaks[piece], self.breaks[piece + 1]);
        (piece, ((t - from) / (to - from)).clamp(0.0, 1.0))
    }

    pub(super) fn at(&self, t: f64) -> Result<Vec<f64>> {
        let (piece, local) = self.place(t, Side::After);
        self.pieces[piece].at(&[local])
    }

    /// The derivative on one side of `t`.
    pub(super) fn velocity(&self, t: f64, side: Side) -> Result<Vec<f64>> {
        let (piece, local) = self.place(t, side);
        let rate = 1.0 / (self.breaks[piece + 1] - self.breaks[piece]);
        let velocity = self.pieces[piece].derivative_at(&[local], &[1])?;
        Ok(velocity.iter().map(|x| x * rate).collect())
    }

    /// Where the derivative jumps, by more than rounding.
    pub(super) fn kinks(&self) -> Result<Vec<f64>> {
        const JUMP: f64 = 1e-9;
        let mut kinks = Vec::new();
        for &t in &self.breaks[1..self.pieces.len()] {
            let (a, b) = (self.velocity(t, Side::Before)?, self.velocity(t, Side::After)?);
            if norm(&plus(&a, -1.0, &b)) > JUMP * (norm(&a) + norm(&b)) {
                kinks.push(t);
            }
        }
        Ok(kinks)
    }

    /// Parameters of points all along the curve, those of its knots among them.
    pub(super) fn parameters(&self) -> Vec<f64> {
        let degree = self.pieces[0].orders()[0] - 1;
        let steps = POINTS.div_ceil(self.pieces.len()).max(degree + 1);
        let part = |pair: &[f64]| {
            let (from, to) = (pair[0], pair[1]);
            (0..steps).map(move |i| from + (to - from) * i as f64 / steps as f64)
        };
        self.breaks.windows(2).flat_map(part).chain([1.0]).collect()
    }

    /// The points at these parameters, one after another.
    pub(super) fn points(&self, parameters: &[f64]) -> Result<Vec<f64>> {
        self.spline.scattered(&[parameters])
    }

    /// Its length, as a polygon.
    pub(super) fn length(&self) -> Result<f64> {
        let points = self.points(&self.parameters())?;
        let corners: Vec<&[f64]> = points.chunks_exact(self.spline.ambient()).collect();
        Ok(corners.windows(2).map(|pair| norm(&plus(pair[1], -1.0, pair[0]))).sum())
    }
}
