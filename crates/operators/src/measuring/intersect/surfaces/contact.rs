//! Contacts found so far, and the parts of the pieces that they explain.

use super::hermite::Piece;
use super::pair::{Knot, Pair, Place};
use super::pairs::Cell;
use super::space::{V3, apart, cross, minus, norm, times};
use super::touch::{Kind, Tangency};
use super::trace::{Arc, End, Limits, trace};

/// A place where surfaces touch.
pub(super) struct Touch {
    pub x: Place,
    pub p: V3,
    pub gap: f64,
    /// The branches that leave it; none where the surfaces touch in this point alone.
    pub halves: Vec<Knot>,
    /// Could its kind be told?
    pub known: bool,
    /// Do the surfaces cross there, a corner of the one on the other?
    pub crossing: bool,
    /// For each surface the parameter and its value that give this point alone, when it is a
    /// border that is collapsed.
    pub poles: [Option<(usize, f64)>; 2],
}

/// All contacts of two pieces.
pub(super) struct Touching {
    /// Single points and nodes.
    pub points: Vec<Touch>,
    /// Curves along which the surfaces touch.
    pub curves: Vec<Arc>,
    /// Boxes in which the surfaces coincide.
    pub overlaps: Vec<Cell>,
    limits: Limits,
    /// Distance up to which surfaces count as having a common point.
    reach: f64,
}

/// Does what is known explain why a cell does not cross cleanly?
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Found {
    Explained,
    Nothing,
}

/// Cells wider than this hold more than one contact can explain.
const SMALL: f64 = 0.13;

impl Touching {
    pub(super) fn new(limits: Limits) -> Self {
        let reach = limits.reach;
        Self { points: vec![], curves: vec![], overlaps: vec![], limits, reach }
    }

    /// Looks for a contact in a cell, unless a known one is near. When it is the `last` time, what
    /// cannot be told apart counts too.
    pub(super) fn explain(&mut self, pair: &Pair, cell: &Cell, last: bool) -> Found {
        let small = cell.width() <= SMALL || last;
        if self.is_near(cell, small) {
            return Found::Explained;
        }
        let tangency = Tangency { pair, reach: self.reach };
        let Some(x) = self.settled(&tangency, cell) else { return Found::Nothing };
        let kind = tangency.kind(&x);
        if kind == Some(Kind::Flat)
            && let Some(common) = coincide(&tangency, cell, self.reach)
        {
            self.overlaps.push(common);
            return Found::Explained;
        }
        if !small {
            return Found::Nothing;
        }
        match kind {
            Some(Kind::Single) => self.add_point(&tangency, x, &[], true),
            Some(Kind::Node(directions)) => self.add_point(&tangency, x, &directions, true),
            Some(Kind::Along(direction)) if self.add_curve(&tangency, &x, &direction, cell) => {}
            Some(Kind::Along(_) | Kind::Flat) if last => self.add_point(&tangency, x, &[], false),
            _ => return Found::Nothing,
        }
        Found::Explained
    }

    /// The place in a cell where the surfaces touch, if Newton's steps find one.
    fn settled(&self, tangency: &Tangency, cell: &Cell) -> Option<Place> {
        let x = tangency.settle(&cell.middle(), None, None)?;
        let x = if let Some(x) = clamped(&x) {
            x
        } else {
            // Out of the window of one: perhaps they touch where both end.
            let mut x = x.map(|t| t.clamp(0.0, 1.0));
            for _ in 0..3 {
                let (there, _) = foot(tangency.pair, &x)?;
                x = there.map(|t| t.clamp(0.0, 1.0));
                let turned = Pair { a: tangency.pair.b, b: tangency.pair.a };
                let (back, _) = foot(&turned, &[x[2], x[3], x[0], x[1]])?;
                x = [back[2], back[3], back[0], back[1]].map(|t| t.clamp(0.0, 1.0));
            }
            x
        };
        (cell.holds(&x, 0.5) && tangency.gap(&x) <= self.reach).then_some(x)
    }

    fn is_near(&self, cell: &Cell, small: bool) -> bool {
        self.points.iter().any(|touch| touch.is_near(cell, small))
            || small && self.curves.iter().any(|arc| arc.pieces().any(|piece| meets(&piece, cell)))
    }

    /// Adds the point of a collapsed border if it is on the other surface, within this box.
    pub(super) fn add_pole(&mut self, pair: &Pair, axis: usize, value: f64, cell: &Cell) {
        let mut x = cell.middle();
        let on_first = axis < 2;
        let turned = Pair { a: pair.b, b: pair.a };
        let found =
            if on_first { foot(pair, &x) } else { foot(&turned, &[x[2], x[3], x[0], x[1]]) };
        let Some((there, gap)) = found else { return };
        let at = if on_first { 2 } else { 0 };
        (x[at], x[at + 1]) = (there[2], there[3]);
        let Some(x) = clamped(&x).filter(|_| gap <= self.reach) else { return };
        let p = if on_first { pair.a.point(x[0], x[1]) } else { pair.b.point(x[2], x[3]) };
        let side = axis / 2;
        if let Some(known) = self.points.iter_mut().find(|touch| apart(&touch.p, &p) < 1e-9) {
            known.poles[side] = Some((axis, value));
            return;
        }
        let mut poles = [None; 2];
        poles[side] = Some((axis, value));
        let halves = Vec::new();
        self.points.push(Touch { x, p, gap, halves, known: false, crossing: true, poles });
    }

    fn add_point(&mut self, tangency: &Tangency, x: Place, directions: &[V3], known: bool) {
        let mut halves = Vec::new();
        for direction in directions {
            for sign in [1.0, -1.0] {
                halves.extend(tangency.bent(tangency.pair, &x, &times(direction, sign)));
            }
        }
        let known = known && halves.len() == 2 * directions.len();
        let [a, b] = tangency.pair.jets::<false>(&x);
        let p = std::array::from_fn(|k| f64::midpoint(a.p[k], b.p[k]));
        self.points.push(Touch {
            x,
            p,
            gap: norm(&minus(&a.p, &b.p)),
            halves,
            known,
            crossing: false,
            poles: [None; 2],
        });
    }

    /// Follows the curve along which the surfaces touch; it must lead out of the cell.
    fn add_curve(&mut self, tangency: &Tangency, x: &Place, dp: &V3, cell: &Cell) -> bool {
        use super::track::Track;
        let Some(start) = tangency.knot(x, dp) else { return false };
        let forth = trace(tangency, start, self.limits, &[]);
        let mut arc = if forth.ends[1] == End::Closed {
            forth
        } else {
            trace(tangency, start.reversed(), self.limits, &[]).reversed().then(&forth)
        };
        arc.tangent = true;
        let leads_out = arc.ends[1] == End::Closed
            || [arc.knots.first(), arc.knots.last()].iter().flatten().any(|k| {
                !cell.holds(&k.x, 0.0) || k.x.iter().any(|t| *t < 1e-9 || *t > 1.0 - 1e-9)
            });
        let fine = arc.knots.len() > 1 && leads_out;
        if fine {
            self.curves.push(arc);
        }
        fine
    }
}

impl Touch {
    /// Is it in a small cell, or near it?
    fn is_near(&self, cell: &Cell, small: bool) -> bool {
        let (mut flat, mut x) = (*cell, self.x);
        for (axis, value) in self.poles.into_iter().flatten() {
            // All values of the other parameter of the collapsed border are this point.
            let free = axis ^ 1;
            (flat.lower[free], flat.upper[free], x[axis]) = (x[free], x[free], value);
        }
        (small || flat.width() <= SMALL) && flat.holds(&x, 0.5)
    }

    /// Is it this place, or nearly?
    pub(super) fn is_at(&self, x: &Place, reach: f64) -> bool {
        let free = |k: usize| self.poles[k / 2].is_some_and(|(axis, _)| axis ^ 1 == k);
        (0..4).all(|k| free(k) || (self.x[k] - x[k]).abs() < reach)
    }

    /// Is it the point of a collapsed border?
    pub(super) fn is_pole(&self) -> bool {
        self.poles != [None; 2]
    }
}

/// A place moved into the window, if it is out by rounding only.
pub(super) fn clamped(x: &Place) -> Option<Place> {
    let inside = x.map(|t| t.clamp(0.0, 1.0));
    (apart(x, &inside) < 1e-7).then_some(inside)
}

/// Does a piece come into a cell, or near it?
fn meets(piece: &Piece, cell: &Cell) -> bool {
    piece.passes(&cell.middle(), cell.width())
}

/// The box of the places in a cell where the surfaces coincide, if they do wherever it is looked at
/// and the second has a point there.
fn coincide(tangency: &Tangency, cell: &Cell, reach: f64) -> Option<Cell> {
    const STEPS: i32 = 8;
    let at = |i: i32, k: usize| {
        cell.lower[k] + f64::from(i) / f64::from(STEPS) * (cell.upper[k] - cell.lower[k])
    };
    let (mut lower, mut upper) = ([f64::INFINITY; 4], [f64::NEG_INFINITY; 4]);
    let mut start = cell.middle();
    for i in 0..=STEPS {
        for step in 0..=STEPS {
            // There and back, so that each start is near.
            let j = if i % 2 == 0 { step } else { STEPS - step };
            (start[0], start[1]) = (at(i, 0), at(j, 1));
            let jet = tangency.pair.a.jet::<false>(start[0], start[1]);
            if norm(&cross(&jet.u, &jet.v)) <= 1e-9 * norm(&jet.u) * norm(&jet.v) {
                continue;
            }
            // At a collapsed border there is no foot to speak of.
            let Some((x, distance)) = foot(tangency.pair, &start) else { continue };
            // Beyond the cell there is nothing to coincide with.
            if !cell.holds(&x, 1e-9) {
                continue;
            }
            if distance > reach {
                return None;
            }
            start = x;
            lower = std::array::from_fn(|k| lower[k].min(x[k]));
            upper = std::array::from_fn(|k| upper[k].max(x[k]));
        }
    }
    // What coincides may begin a step before the first place that was looked at.
    let room = |k: usize| (cell.upper[k] - cell.lower[k]) / f64::from(STEPS);
    let lower = std::array::from_fn(|k| f64::max(lower[k] - room(k), cell.lower[k]));
    let upper = std::array::from_fn(|k| f64::min(upper[k] + room(k), cell.upper[k]));
    (lower[0] <= upper[0]).then_some(Cell { lower, upper })
}

/// The nearest point of the second surface, its parameters followed from `start`, and its distance.
pub(super) fn foot(pair: &Pair, start: &Place) -> Option<(Place, f64)> {
    let mut x = *start;
    for _ in 0..12 {
        let [a, b] = pair.jets::<false>(&x);
        let gap = minus(&a.p, &b.p);
        let [ds, dt] = b.split(&gap)?;
        (x[2], x[3]) = (x[2] + ds, x[3] + dt);
        if !x[2..].iter().all(|t| (-2.0..=3.0).contains(t)) {
            return None;
        }
        if ds.abs().max(dt.abs()) < 1e-14 {
            break;
        }
    }
    let [a, b] = pair.jets::<false>(&x);
    Some((x, norm(&minus(&a.p, &b.p))))
}
