//! One side of a joint: the pieces that reach it, seen across it.

use pforms_kernel::{Form, Result};

use super::FormEnd;
use crate::algebra::{Pieces, Spline};

/// A spline and its pieces, found once for all joints.
pub(super) struct Parts<'a> {
    spline: &'a Spline,
    pieces: Pieces<'a>,
    breaks: Vec<Vec<f64>>,
}

impl<'a> Parts<'a> {
    pub(super) fn of(spline: &'a Spline) -> Self {
        Self { spline, pieces: Pieces::of(spline), breaks: spline.breaks() }
    }
}

/// The pieces of a spline along one of their common ends.
#[derive(Clone)]
pub(super) struct Side<'a> {
    parts: &'a Parts<'a>,
    axis: usize,
    /// The index of the pieces along `axis`.
    piece: usize,
    /// Are they met where their parameter is largest?
    far: bool,
    /// 1 when the parameter grows in the direction in which the joint is crossed, else −1.
    sign: f64,
    /// Which of the other axes are run backwards.
    pub flips: Vec<bool>,
}

impl<'a> Side<'a> {
    /// The side of a spline at one of its ends; `before` the joint, or after it.
    pub(super) fn of_end(parts: &'a Parts<'a>, at: FormEnd, before: bool) -> Result<Self> {
        parts.spline.net().require_axis(at.axis)?;
        let piece = if at.far { parts.breaks[at.axis].len() - 2 } else { 0 };
        let mut side = Self::of_piece(parts, at.axis, piece, at.far)?;
        side.sign = if at.far == before { 1.0 } else { -1.0 };
        Ok(side)
    }

    /// The side of the pieces of index `piece` along `axis`, at their far end or their near one.
    pub(super) fn of_piece(
        parts: &'a Parts<'a>,
        axis: usize,
        piece: usize,
        far: bool,
    ) -> Result<Self> {
        parts.spline.net().require_axis(axis)?;
        let flips = vec![false; parts.spline.axes() - 1];
        Ok(Self { parts, axis, piece, far, sign: 1.0, flips })
    }

    /// The other axes.
    pub(super) fn others(&self) -> Vec<usize> {
        (0..self.parts.spline.axes()).filter(|axis| *axis != self.axis).collect()
    }

    /// Where the pieces begin and end along the other axis `k`, in shares of its window.
    pub(super) fn shares(&self, k: usize) -> Vec<f64> {
        let list = &self.parts.breaks[self.others()[k]];
        let (from, to) = (list[0], list[list.len() - 1]);
        let share = |t: &f64| (t - from) / (to - from);
        let mut shares: Vec<f64> = list.iter().map(share).collect();
        if self.flips[k] {
            shares = shares.into_iter().rev().map(|share| 1.0 - share).collect();
        }
        shares
    }

    /// The degree along the other axis `k`.
    pub(super) fn degree(&self, k: usize) -> usize {
        self.parts.spline.degrees()[self.others()[k]]
    }

    /// The piece at these shares of the other windows, as seen from there.
    pub(super) fn place(&self, shares: &[f64]) -> Result<Place> {
        let mut index = vec![self.piece; self.parts.spline.axes()];
        let mut local = vec![if self.far { 1.0 } else { 0.0 }; self.parts.spline.axes()];
        let mut steps = vec![0.0; self.parts.spline.axes()];
        let list = &self.parts.breaks[self.axis];
        steps[self.axis] = self.sign / (list[self.piece + 1] - list[self.piece]);
        for ((axis, share), flip) in self.others().into_iter().zip(shares).zip(&self.flips) {
            let list = &self.parts.breaks[axis];
            let last = list.len() - 1;
            let share = if *flip { 1.0 - share } else { *share };
            let t = list[0] + share * (list[last] - list[0]);
            let i = list[1..last].partition_point(|knot| *knot <= t);
            index[axis] = i;
            local[axis] = (t - list[i]) / (list[i + 1] - list[i]);
            steps[axis] = if *flip { -1.0 } else { 1.0 } / (list[i + 1] - list[i]);
        }
        let form = self.parts.pieces.piece(&index)?;
        let size = size(&form);
        Ok(Place { form, local, steps, axis: self.axis, size })
    }
}

/// A place on a joint, as one side sees it.
pub(super) struct Place {
    form: Form,
    local: Vec<f64>,
    /// How fast the parameters of the piece run with those of the spline.
    steps: Vec<f64>,
    /// The axis that crosses the joint.
    pub axis: usize,
    /// How large the piece is.
    pub size: f64,
}

impl Place {
    /// Number of parameters.
    pub(super) fn axes(&self) -> usize {
        self.local.len()
    }

    /// A derivative by the parameters of the spline.
    pub(super) fn derivative(&self, orders: &[usize]) -> Result<Vec<f64>> {
        let mut derivative = self.form.derivative_at(&self.local, orders)?;
        let factor: f64 =
            self.steps.iter().zip(orders).map(|(step, &order)| step.powi(order as i32)).product();
        for x in &mut derivative {
            *x *= factor;
        }
        Ok(derivative)
    }

    /// The derivatives of order 0 to `order` across the joint.
    pub(super) fn across(&self, order: usize) -> Result<Vec<Vec<f64>>> {
        let along = |k: usize| {
            let mut orders = vec![0; self.local.len()];
            orders[self.axis] = k;
            self.derivative(&orders)
        };
        (0..=order).map(along).collect()
    }

    /// How large a derivative across the joint is for a piece that crosses its size once.
    pub(super) fn usual(&self, order: usize) -> f64 {
        self.size * self.steps[self.axis].abs().powi(order as i32)
    }
}

/// The largest extent of the poles that are points; 1 if there is none.
fn size(form: &Form) -> f64 {
    let ambient = form.ambient();
    let extent = |axis: usize| {
        let points = form.homogeneous().chunks_exact(form.width());
        let coordinates =
            points.filter(|pole| pole[ambient] != 0.0).map(|pole| pole[axis] / pole[ambient]);
        let (low, high) = coordinates
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
        high - low
    };
    let largest = (0..ambient).map(extent).fold(0.0_f64, f64::max);
    if largest > 0.0 { largest } else { 1.0 }
}
