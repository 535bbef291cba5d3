//! Where a line on one piece meets the other piece: every point, by halving both.
//!
//! A line and a part whose tangents and normals are never at right angles meet once at most; then
//! Newton's steps find the point or halving shows there is none.

use super::pair::{Pair, Place};
use super::pairs::Cell;
use super::tree::{Line, Tree};

/// A line on one piece: the parameter that is kept, 0 to 3 in a [`Place`], and its value.
#[derive(Clone, Copy, Debug)]
pub(super) struct Level {
    pub axis: usize,
    pub value: f64,
}

/// What was found on a line.
#[derive(Default)]
pub(super) struct Pierced {
    /// Single common points.
    pub points: Vec<Place>,
    /// Boxes of which nothing is known but that a point may be in: touching, or lying in.
    pub loose: Vec<Cell>,
}

/// What may still be looked at.
pub(super) struct Work(pub usize);

impl Work {
    /// Counts one more look, if there is one left.
    pub(super) fn goes_on(&mut self) -> bool {
        self.0 = self.0.saturating_sub(1);
        self.0 > 0
    }
}

/// Pairs of parts looked at before what is left counts as loose.
const MOST: usize = 4000;

/// Pairs waiting that tell of a continuum.
const MANY: usize = 200;

/// Parts with a window smaller than this are not halved.
const FINEST: f64 = 1e-8;

/// Points that are nearer than this are one.
pub(super) const SAME: f64 = 1e-9;

/// All common points of a line of one tree, at `level`, and a part of the other tree.
pub(super) fn pierce(
    pair: &Pair,
    level: Level,
    line: Line,
    tree: &mut Tree,
    part: usize,
    work: &mut Work,
) -> Pierced {
    let mut found = Pierced::default();
    let mut waiting = std::collections::VecDeque::from([(line, part)]);
    let mut looked = 0;
    while let Some((line, part)) = waiting.pop_front() {
        if !tree.parts[part].may_meet_line(&line) {
            continue;
        }
        looked += 1;
        let own = &tree.parts[part];
        let start = level.place(0.5 * (line.lower + line.upper), own.middle());
        let narrow = (0..2).all(|k| own.upper[k] - own.lower[k] < FINEST);
        let short = line.upper - line.lower < FINEST || line.is_point();
        let single = match (&line.tangents, &own.normals) {
            (Some(tangents), Some(normals)) => tangents.is_never_normal_to(normals),
            _ => false,
        };
        if single
            && let Some(x) = pair.on_line(&start, level.axis)
            && level.is_within(&x, &line, own.lower, own.upper)
        {
            if !found.points.iter().any(|other| super::space::apart(other, &x) < SAME) {
                found.points.push(x);
            }
            continue;
        }
        if !work.goes_on() || looked > MOST || waiting.len() > MANY || (narrow && short) {
            let (lower, upper) = (own.lower, own.upper);
            found.loose.push(Cell {
                lower: level.place(line.lower, lower),
                upper: level.place(line.upper, upper),
            });
            continue;
        }
        if !short && (line.size >= own.size || narrow) {
            waiting.extend(line.halves().map(|half| (half, part)));
        } else {
            waiting.extend(tree.halves(part).0.map(|half| (line.clone(), half)));
        }
    }
    found
}

impl Level {
    /// The place with this parameter along the line and those on the other surface.
    pub(super) fn place(self, along: f64, other: [f64; 2]) -> Place {
        match self.axis {
            0 => [self.value, along, other[0], other[1]],
            1 => [along, self.value, other[0], other[1]],
            2 => [other[0], other[1], self.value, along],
            _ => [other[0], other[1], along, self.value],
        }
    }

    fn is_within(self, x: &Place, line: &Line, lower: [f64; 2], upper: [f64; 2]) -> bool {
        let low = self.place(line.lower, lower);
        let high = self.place(line.upper, upper);
        (0..4).all(|k| k == self.axis || (x[k] >= low[k] - SAME && x[k] <= high[k] + SAME))
    }
}
