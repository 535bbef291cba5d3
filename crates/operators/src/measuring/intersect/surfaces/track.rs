//! What can be followed: a curve given by equations between two pieces.

use super::pair::{Knot, Pair, Place};
use super::space::{V3, dot};

/// A curve of places that can be corrected and has a direction.
pub(super) trait Track {
    /// The place of the curve near `start` with `(P − from)·along = 0`.
    fn in_plane(&self, start: &Place, from: &V3, along: &V3) -> Option<Place>;

    /// The place of the curve near `start` where a parameter keeps its value.
    fn on_line(&self, start: &Place, axis: usize) -> Option<Place>;

    /// The knot at a place of the curve, run in the direction nearest to `along`.
    fn knot(&self, x: &Place, along: &V3) -> Option<Knot>;

    /// The points of both pieces there.
    fn points(&self, x: &Place) -> [V3; 2];
}

impl Track for Pair<'_> {
    fn in_plane(&self, start: &Place, from: &V3, along: &V3) -> Option<Place> {
        Pair::in_plane(self, start, from, along)
    }

    fn on_line(&self, start: &Place, axis: usize) -> Option<Place> {
        Pair::on_line(self, start, axis)
    }

    fn knot(&self, x: &Place, along: &V3) -> Option<Knot> {
        let knot = Pair::knot(self, x, 1.0)?;
        Some(if dot(&knot.dp, along) < 0.0 { knot.reversed() } else { knot })
    }

    fn points(&self, x: &Place) -> [V3; 2] {
        [self.a.point(x[0], x[1]), self.b.point(x[2], x[3])]
    }
}

impl Knot {
    /// The same knot, run the other way.
    pub(super) fn reversed(mut self) -> Self {
        self.dx.iter_mut().chain(&mut self.dp).for_each(|x| *x = -*x);
        self
    }
}
