//! Pairs of parts of two pieces, halved until each is apart, crosses cleanly, or is very small.
//!
//! In a pair whose normals are never parallel the intersection has no loops: every branch runs from
//! border to border. The borders are lines on which the pieces were halved, or their own: the
//! points on all of them are found, so that no branch is missed.

use super::contact::{Found, Touching};
use super::pair::{Pair, Place};
use super::pierce::{Level, Pierced, Work, pierce};
use super::tree::{Line, Tree};

/// A box of places.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cell {
    pub lower: Place,
    pub upper: Place,
}

/// A point of the intersection on a known line.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mark {
    pub x: Place,
    pub level: Level,
}

/// What the halving found.
#[derive(Default)]
pub(super) struct Search {
    /// Points on the borders of the pieces, and on the lines where they were halved.
    pub marks: Vec<Mark>,
    /// Boxes on such lines where the pieces touch or where the line lies in the other piece.
    pub loose: Vec<Cell>,
    /// Boxes in which a loop may be.
    pub undecided: Vec<Cell>,
}

/// Pairs of one size that tell of a continuum of contacts.
const MANY: usize = 1500;

/// Halvings of all four parameters together.
const DEEPEST: usize = 120;

/// Halvings between two looks for contacts.
const BETWEEN: usize = 4;

/// Looks for everything that two pieces have in common; contacts go to `touching`.
pub(super) fn search(
    pair: &Pair,
    trees: &mut [&mut Tree; 2],
    touching: &mut Touching,
    work: &mut Work,
) -> Search {
    let mut found = Search::default();
    if !trees[0].parts[0].may_meet(&trees[1].parts[0]) {
        return found;
    }
    for axis in 0..4 {
        for end in [false, true] {
            let line = trees[axis / 2].border(0, axis % 2, end);
            let level = Level { axis, value: if end { 1.0 } else { 0.0 } };
            if line.is_point() {
                let pierced = pierce(pair, level, line, trees[1 - axis / 2], 0, work);
                pierced.loose.iter().for_each(|c| touching.add_pole(pair, axis, level.value, c));
            } else {
                found.add(pair, level, line, trees[1 - axis / 2], 0, work);
            }
        }
    }
    let mut pairs = vec![[0, 0]];
    for depth in 0.. {
        let mut next = Vec::new();
        let last = depth == DEEPEST || pairs.len() > MANY || !work.goes_on();
        let look = last || depth % BETWEEN == 0;
        for &[i, j] in &pairs {
            let (a, b) = (&trees[0].parts[i], &trees[1].parts[j]);
            if !work.goes_on() {
                found.undecided.push(Cell::of(trees, i, j));
                continue;
            }
            if !a.may_meet(b) {
                continue;
            }
            if let (Some(m), Some(n)) = (&a.normals, &b.normals)
                && m.is_across(n)
            {
                continue;
            }
            let cell = Cell::of(trees, i, j);
            if look && touching.explain(pair, &cell, last) == Found::Explained {
                continue;
            }
            if last {
                found.undecided.push(cell);
                continue;
            }
            let first = a.size * (0.1 + a.turn()) >= b.size * (0.1 + b.turn());
            let (halves, axis, value) =
                trees[usize::from(!first)].halves([i, j][usize::from(!first)]);
            let level = Level { axis: axis + if first { 0 } else { 2 }, value };
            let (own, other) = if first { (0, j) } else { (1, i) };
            let line = trees[own].border(halves[0], axis, true);
            found.add(pair, level, line, trees[1 - own], other, work);
            next.extend(halves.map(|half| if first { [half, j] } else { [i, half] }));
        }
        if next.is_empty() || last {
            break;
        }
        pairs = next;
    }
    found
}

impl Search {
    fn add(
        &mut self,
        pair: &Pair,
        level: Level,
        line: Line,
        tree: &mut Tree,
        part: usize,
        work: &mut Work,
    ) {
        let Pierced { points, loose } = pierce(pair, level, line, tree, part, work);
        self.marks.extend(points.into_iter().map(|x| Mark { x, level }));
        self.loose.extend(loose);
    }
}

impl Cell {
    fn of(trees: &[&mut Tree; 2], i: usize, j: usize) -> Self {
        let (a, b) = (&trees[0].parts[i], &trees[1].parts[j]);
        let join = |p: [f64; 2], q: [f64; 2]| [p[0], p[1], q[0], q[1]];
        Self { lower: join(a.lower, b.lower), upper: join(a.upper, b.upper) }
    }

    /// The box that reaches so far around a place.
    pub(super) fn around(x: &Place, reach: f64) -> Self {
        Self { lower: x.map(|t| t - reach), upper: x.map(|t| t + reach) }
    }

    /// Its middle.
    pub(super) fn middle(&self) -> Place {
        std::array::from_fn(|k| f64::midpoint(self.lower[k], self.upper[k]))
    }

    /// Is a place in it, or out of it by no more than a share of its width?
    pub(super) fn holds(&self, x: &Place, share: f64) -> bool {
        (0..4).all(|k| {
            let room = share * (self.upper[k] - self.lower[k]);
            x[k] >= self.lower[k] - room && x[k] <= self.upper[k] + room
        })
    }

    /// Is a place no farther out of it than this?
    pub(super) fn reaches(&self, x: &Place, room: f64) -> bool {
        (0..4).all(|k| x[k] >= self.lower[k] - room && x[k] <= self.upper[k] + room)
    }

    /// The longest side.
    pub(super) fn width(&self) -> f64 {
        (0..4).fold(0.0, |most, k| f64::max(most, self.upper[k] - self.lower[k]))
    }
}
