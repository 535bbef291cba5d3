//! Everything two pieces have in common: their contacts, and every branch from end to end.

use super::contact::{Touch, Touching, clamped};
use super::pair::{Knot, Pair, Place};
use super::pairs::{Cell, Mark, Search, search};
use super::patch::Patch;
use super::pierce::{Level, Work};
use super::space::{apart, cross, dot, plus, unit};
use super::touch::Tangency;
use super::trace::{Arc, End, Limits, is_inside, trace};
use super::tree::Tree;

/// What two pieces have in common.
#[derive(Default)]
pub(super) struct Meeting {
    pub arcs: Vec<Arc>,
    pub touches: Vec<Touch>,
    pub overlaps: Vec<Cell>,
    pub undecided: Vec<Cell>,
    /// Is it proved that there is nothing else, outside of these boxes?
    pub proved: bool,
}

/// A mark counts as passed by an arc that comes as near as this, in every parameter.
const REACH: f64 = 1e-6;

/// What is nearer to a branch than this, in every parameter, is on it.
const NEAR: f64 = 1e-5;

/// A box on a line that is narrower is explained by what passes through it.
const SMALL: f64 = 0.05;

/// Near a contact marks are not counted: several branches pass them.
const CROWDED: f64 = 1e-3;

/// Boxes on lines that are looked at closely.
const MANY: usize = 400;

/// Each attempt with steps this much shorter than those of the one before.
const ATTEMPTS: [f64; 3] = [1.0, 0.15, 0.02];

pub(super) fn meet(
    patches: [&Patch; 2],
    trees: &mut [&mut Tree; 2],
    limits: Limits,
    work: &mut Work,
) -> Meeting {
    let pair = Pair { a: patches[0], b: patches[1] };
    let mut touching = Touching::new(limits);
    let found = search(&pair, trees, &mut touching, work);
    let mut following = Following::new(&pair, &found, &touching, limits);
    for share in ATTEMPTS {
        let limits = Limits { longest: limits.longest * share, ..limits };
        following = Following::new(&pair, &found, &touching, limits);
        following.all();
        if following.is_consistent() {
            break;
        }
    }
    let doubts = following.doubts();
    let proved = found.loose.is_empty()
        && touching.points.is_empty()
        && touching.overlaps.is_empty()
        && touching.curves.is_empty();
    let Following { mut arcs, touches, mut undecided, .. } = following;
    undecided.extend(doubts);
    undecided.extend(&found.undecided);
    arcs.extend(touching.curves);
    touching.points.extend(touches);
    Meeting { arcs, touches: touching.points, overlaps: touching.overlaps, undecided, proved }
}

/// The branches of two pieces, one after another.
struct Following<'a> {
    pair: &'a Pair<'a>,
    touching: &'a Touching,
    limits: Limits,
    /// Places known to be on branches, with the number of arcs that pass them.
    marks: Vec<(Mark, usize)>,
    loose: Vec<Cell>,
    arcs: Vec<Arc>,
    touches: Vec<Touch>,
    undecided: Vec<Cell>,
}

impl<'a> Following<'a> {
    fn new(pair: &'a Pair, found: &Search, touching: &'a Touching, limits: Limits) -> Self {
        let crowded = |x: &Place| touching.points.iter().any(|touch| touch.is_at(x, CROWDED));
        let marks = found.marks.iter().filter(|mark| !crowded(&mark.x)).map(|mark| (*mark, 0));
        let marks = marks.collect();
        let loose = found.loose.iter().filter(|cell| !crowded(&cell.middle())).copied().collect();
        let (arcs, touches, undecided) = (Vec::new(), Vec::new(), Vec::new());
        Self { pair, touching, limits, marks, loose, arcs, touches, undecided }
    }

    fn all(&mut self) {
        for node in &self.touching.points {
            for half in &node.halves {
                if enters(half) && !self.is_taken(half) {
                    let nodes = &self.touching.points;
                    self.add(trace(self.pair, *half, self.limits, nodes).begun(End::Node));
                }
            }
        }
        // What begins on a border first: then only loops are left.
        for at in 0..self.marks.len() {
            if on_border(self.marks[at].0.level) {
                self.begin(at);
            }
        }
        for at in 0..self.marks.len() {
            self.begin(at);
        }
        for (number, cell) in std::mem::take(&mut self.loose).into_iter().enumerate() {
            if number < MANY {
                self.settle(&cell);
            } else if !self.explains(&cell) {
                self.undecided.push(cell);
            }
        }
    }

    /// Has an arc come to a node along this branch?
    fn is_taken(&self, half: &Knot) -> bool {
        self.arcs.iter().any(|arc| {
            let ends = [arc.knots.first().copied(), arc.knots.last().map(|k| k.reversed())];
            ends.iter()
                .flatten()
                .any(|end| apart(&end.x, &half.x) < REACH && dot(&end.dp, &half.dp) > 0.999)
        })
    }

    /// Follows the branch through a mark, unless an arc passes it.
    fn begin(&mut self, at: usize) {
        let (mark, passed) = self.marks[at];
        if passed > 0 {
            return;
        }
        match self.pair.knot(&mark.x, 1.0) {
            Some(knot) if knot.sine > 1e-9 => {
                if !self.both_ways(knot) {
                    self.touches.push(self.point(mark.x));
                    self.marks[at].1 += 1;
                }
            }
            _ => self.loose.push(Cell::around(&mark.x, REACH)),
        }
    }

    /// Follows the branch through a knot both ways, as far as it stays inside; false when it does
    /// not come in at all.
    fn both_ways(&mut self, knot: Knot) -> bool {
        let nodes = &self.touching.points;
        let run = |knot: Knot| trace(self.pair, knot, self.limits, nodes);
        let arc = match (enters(&knot), enters(&knot.reversed())) {
            (false, false) => return false,
            (true, false) => run(knot).begun(End::Border),
            (false, true) => run(knot.reversed()).begun(End::Border),
            (true, true) => {
                let forth = run(knot);
                if forth.ends[1] == End::Closed {
                    forth.begun(End::Closed)
                } else {
                    run(knot.reversed()).reversed().then(&forth)
                }
            }
        };
        if arc.lengths.is_empty() {
            return false;
        }
        self.add(arc);
        true
    }

    fn add(&mut self, arc: Arc) {
        for (mark, passed) in &mut self.marks {
            *passed += usize::from(arc.passes(&mark.x, REACH));
        }
        if arc.ends.contains(&End::Lost) {
            let ends = [(0, &arc.knots[0]), (1, &arc.knots[arc.knots.len() - 1])];
            for (_, knot) in ends.iter().filter(|(k, _)| arc.ends[*k] == End::Lost) {
                self.undecided.push(Cell::around(&knot.x, CROWDED));
            }
        }
        if !arc.lengths.is_empty() {
            self.arcs.push(arc);
        }
    }

    /// Explains a box where a line touches the other piece, or lies in it.
    fn settle(&mut self, cell: &Cell) {
        let middle = cell.middle();
        if self.explains(cell) {
            return;
        }
        if let Some(knot) = self.nearest(&middle) {
            if !self.is_known(&knot.x, NEAR) && !self.both_ways(knot) {
                self.touches.push(self.point(knot.x));
            }
            return;
        }
        let tangency = Tangency { pair: self.pair, reach: self.limits.reach };
        let settled = tangency.settle(&middle, None, None).and_then(|x| clamped(&x));
        let explained = settled.is_some_and(|x| {
            let near = cell.holds(&x, 2.0) || apart(&x, &middle) < CROWDED;
            near && (self.is_known(&x, NEAR) || tangency.gap(&x) > self.limits.reach)
        });
        if !explained {
            self.undecided.push(*cell);
        }
    }

    /// Does something that was found pass through a small box, or by it?
    fn explains(&self, cell: &Cell) -> bool {
        let width = cell.width();
        width < SMALL && self.is_known(&cell.middle(), width.max(NEAR))
    }

    /// Is a place on a branch or contact that was found, or so near?
    fn is_known(&self, x: &Place, reach: f64) -> bool {
        self.touching.overlaps.iter().any(|cell| cell.reaches(x, reach))
            || self.touching.points.iter().any(|touch| touch.is_at(x, CROWDED))
            || self.touches.iter().any(|touch| touch.is_at(x, CROWDED))
            || self.arcs.iter().chain(&self.touching.curves).any(|arc| arc.passes(x, reach))
    }

    /// The point of the intersection near a place, if the pieces cross there.
    fn nearest(&self, x: &Place) -> Option<Knot> {
        let [a, b] = self.pair.jets::<false>(x);
        let along = cross(&a.normal()?, &b.normal()?);
        let along = unit(&along).filter(|_| dot(&along, &along) > 1e-12)?;
        let from = std::array::from_fn(|k| f64::midpoint(a.p[k], b.p[k]));
        let y = self.pair.in_plane(x, &from, &along)?;
        let y = clamped(&y).filter(|y| apart(y, x) < 0.01)?;
        self.pair.knot(&y, 1.0)
    }

    fn point(&self, x: Place) -> Touch {
        let [a, b] = self.pair.jets::<false>(&x);
        let p = std::array::from_fn(|k| f64::midpoint(a.p[k], b.p[k]));
        let gap = dot(&plus(&a.p, -1.0, &b.p), &plus(&a.p, -1.0, &b.p)).sqrt();
        Touch { x, p, gap, halves: Vec::new(), known: true, crossing: true, poles: [None; 2] }
    }

    /// Is every mark passed once, and every arc followed to its end?
    fn is_consistent(&self) -> bool {
        self.marks.iter().all(|(_, passed)| *passed == 1)
            && self.arcs.iter().all(|arc| !arc.ends.contains(&End::Lost))
    }

    /// Boxes around marks that no arc passes, or several.
    fn doubts(&self) -> Vec<Cell> {
        let doubtful = self.marks.iter().filter(|(_, passed)| *passed != 1);
        doubtful.map(|(mark, _)| Cell::around(&mark.x, CROWDED)).collect()
    }
}

fn on_border(level: Level) -> bool {
    level.value == 0.0 || level.value == 1.0
}

/// Does the branch go into the window from here, or along its border?
fn enters(knot: &Knot) -> bool {
    let size = knot.dx.iter().fold(0.0_f64, |most, d| most.max(d.abs()));
    let bend = knot.ddx.iter().fold(0.0_f64, |most, d| most.max(d.abs()));
    is_inside(&knot.x)
        && (0..4).all(|k| {
            let inward = if knot.x[k] < 1e-9 {
                1.0
            } else if knot.x[k] > 1.0 - 1e-9 {
                -1.0
            } else {
                return true;
            };
            let (first, second) = (inward * knot.dx[k], inward * knot.ddx[k]);
            if first.abs() > 1e-7 * size { first > 0.0 } else { second > -1e-6 * bend.max(size) }
        })
}
