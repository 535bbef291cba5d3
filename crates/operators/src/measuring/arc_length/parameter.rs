//! From parameters to lengths and back.

use pforms_kernel::{Error, Result};

use super::{ArcLength, ROUNDINGS, Stretch};

/// Steps after which halving has used up all digits.
const STEPS: usize = 128;

impl ArcLength {
    /// The length from the start of the window to parameter `t`.
    ///
    /// Errors: `Domain` when `t` lies outside the window.
    pub fn up_to(&self, t: f64) -> Result<f64> {
        let (first, last) = self.window();
        if !(first <= t && t <= last) {
            return Err(Error::domain("t", t, format!("a parameter from {first} to {last}")));
        }
        let later = &self.breaks[1..self.breaks.len() - 1];
        let piece = later.partition_point(|knot| *knot <= t);
        let local = (t - self.breaks[piece]) / (self.breaks[piece + 1] - self.breaks[piece]);
        let index = self.stretches.partition_point(|s| (s.piece, s.to) < (piece, local));
        let Some(stretch) = self.stretches.get(index) else { return Ok(self.length) };
        let share = (local - stretch.from) / (stretch.to - stretch.from);
        Ok((stretch.before + stretch.up_to(share)?) * self.unit)
    }

    /// The parameter to which the curve has gone `length` from its start.
    ///
    /// Where the curve stands still many parameters would do; it is one of them.
    ///
    /// Errors: `Domain` when `length` is negative or longer than the curve.
    pub fn parameter(&self, length: f64) -> Result<f64> {
        // What the length itself may be off is forgiven at its end.
        let most = self.length + self.error.max(ROUNDINGS * f64::EPSILON * self.length);
        if !(0.0 <= length && length <= most) {
            let expected = format!("a length from 0 to {}", self.length);
            return Err(Error::domain("length", length, expected));
        }
        let wanted = length / self.unit;
        let index = self.stretches.partition_point(|s| s.before + s.length < wanted);
        let Some(stretch) = self.stretches.get(index) else { return Ok(self.window().1) };
        let share = stretch.share(wanted - stretch.before)?;
        let local = stretch.from + share * (stretch.to - stretch.from);
        let (from, to) = (self.breaks[stretch.piece], self.breaks[stretch.piece + 1]);
        Ok((from + local * (to - from)).clamp(from, to))
    }

    /// The parameters of both ends.
    pub fn window(&self) -> (f64, f64) {
        (self.breaks[0], self.breaks[self.breaks.len() - 1])
    }
}

impl Stretch {
    /// The length of the first `share` of it.
    fn up_to(&self, share: f64) -> Result<f64> {
        match (self.smooth, share) {
            (false, _) => Ok(self.length * share),
            (true, 0.0) => Ok(0.0),
            (true, 1.0) => Ok(self.length),
            // From the nearer end, so that lengths never go back.
            (true, _) if share <= 0.5 => self.speed.integral(0.0, share),
            (true, _) => Ok(self.length - self.speed.integral(share, 1.0)?),
        }
    }

    /// The share that has this length: Newton's steps, halving where one would leave the bracket.
    fn share(&self, length: f64) -> Result<f64> {
        if length <= 0.0 || self.length == 0.0 {
            return Ok(0.0);
        }
        if length >= self.length {
            return Ok(1.0);
        }
        let (mut low, mut high) = (0.0, 1.0);
        let mut share = length / self.length;
        if !self.smooth {
            return Ok(share);
        }
        for _ in 0..STEPS {
            let excess = self.up_to(share)? - length;
            if excess > 0.0 {
                high = share;
            } else {
                low = share;
            }
            let step = share - excess / self.speed.at(share)?;
            let next = if low < step && step < high { step } else { 0.5 * (low + high) };
            if (next - share).abs() <= f64::EPSILON * share || excess == 0.0 {
                return Ok(share);
            }
            share = next;
        }
        Ok(share)
    }
}
