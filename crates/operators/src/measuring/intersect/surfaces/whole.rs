//! Whole surfaces: their pieces, pair by pair, and what the answers make together.

use pforms_kernel::{Error, Result};

use super::contact::Touch;
use super::join::{Units, branches, global, in_space, in_windows};
use super::meet::meet;
use super::pair::Place;
use super::pairs::Cell;
use super::patch::Patch;
use super::pierce::Work;
use super::positive::Positive;
use super::space::{V3, apart, minus, norm};
use super::trace::{Arc, Limits};
use super::tree::Tree;
use crate::measuring::intersect::answer::{
    Contact, ContactKind, Intersections, Overlap, Undecided,
};
use crate::measuring::project::weight::{Weights, positive_weights};
use crate::{Poles, Shape};

/// Branches are never nearer to the surfaces than this, in sizes of the smaller.
const FINEST: f64 = 1e-10;

/// Surfaces that come as near as this have a point in common, in sizes of the smaller.
const TOUCHING: f64 = 1e-12;

/// The longest step along a branch, in sizes of the smaller surface.
const LONGEST: f64 = 0.15;

/// Pairs of parts looked at in all before what is left is undecided: some seconds.
const WORK: usize = 4_000_000;

/// Of these, for one pair of pieces.
const SHARE: usize = 400_000;

/// A piece of a surface: a part of its window.
struct Piece {
    patch: Patch,
    tree: Tree,
    lower: [f64; 2],
    upper: [f64; 2],
}

/// The intersection of two surfaces of space: all its branches, contacts and common parts.
///
/// A branch is three curves over one parameter, arc length as nearly as quintics have it: one in the
/// parameters of each surface, and one in space. Its `error` is the distance of that curve from both
/// surfaces, and of the points at its parameters, measured in the middle of every step; at most
/// `accuracy` times the size of the smaller surface, but no less than 1e-10 of it.
///
/// `complete` says that it is proved that no branch is missing. It is not said where surfaces touch,
/// cross in a node or at a collapsed border, where they coincide, or where the border of one lies in
/// the other: these are found by looking, not by proof.
///
/// Errors: `Shape` unless both are surfaces in space; `Degenerate` for an axis with one pole, along
/// which there is no surface; `Domain` for a weight that vanishes or changes sign.
pub(in crate::measuring::intersect) fn surface_surface(
    a: &Shape,
    b: &Shape,
    accuracy: f64,
) -> Result<Intersections> {
    let (first, second) = (Hull::of(a, "first")?, Hull::of(b, "second")?);
    let mut answer = Intersections { complete: true, ..Intersections::default() };
    let Some((units, size)) = first.units_with(&second) else { return Ok(answer) };
    let limits = Limits {
        error: accuracy.max(FINEST) * size,
        longest: LONGEST * size,
        reach: accuracy.clamp(TOUCHING, 1e-6) * size,
    };
    let (mut ones, mut others) = (first.pieces(units), second.pieces(units));
    let mut all = Gathered::default();
    let mut work = Work(WORK);
    for one in &mut ones {
        for other in &mut others {
            if one.tree.parts[0].may_meet(&other.tree.parts[0]) {
                let mut share = Work(work.0.min(SHARE));
                work.0 -= share.0;
                all.add(one, other, limits, &mut share);
                work.0 += share.0;
            }
        }
    }
    all.settle(units, &mut answer)?;
    Ok(answer)
}

/// Parts of a surface with positive weights, and the box they lie in.
struct Hull {
    parts: Vec<Positive>,
    low: V3,
    high: V3,
}

impl Hull {
    fn of(shape: &Shape, argument: &str) -> Result<Self> {
        let net = shape.net();
        if net.axes() != 2 || net.ambient() != 3 {
            let received = format!("a {} in dimension {}", net.kind(), net.ambient());
            return Err(Error::shape(argument, received, "a surface in dimension 3"));
        }
        let (degrees, breaks) = match shape {
            Shape::Form(form) => (form.degrees(), vec![vec![0.0, 1.0]; 2]),
            Shape::Spline(spline) => (spline.degrees(), spline.breaks()),
        };
        if degrees.contains(&0) {
            let received = format!("degrees {degrees:?}");
            return Err(Error::degenerate(argument, received, "a surface, of degree 1 at least"));
        }
        let (low, high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        let mut hull = Self { parts: Vec::new(), low, high };
        let columns = breaks[1].len() - 1;
        for (number, form) in shape.pieces()?.into_iter().enumerate() {
            let Weights { sign, largest, lower, upper, .. } = positive_weights(&form)?;
            for k in 0..3 {
                hull.low[k] = hull.low[k].min(lower[k]);
                hull.high[k] = hull.high[k].max(upper[k]);
            }
            let (i, j) = (number / columns, number % columns);
            let lower = [breaks[0][i], breaks[1][j]];
            let upper = [breaks[0][i + 1], breaks[1][j + 1]];
            let part = Positive { form, weight: sign * largest, lower, upper };
            hull.parts.extend(part.split()?);
        }
        if hull.parts.iter().all(Positive::is_collapsed) {
            let received = "a surface collapsed to a curve or a point";
            return Err(Error::degenerate(argument, received, "a surface with normals"));
        }
        Ok(hull)
    }

    /// The units for both surfaces, and the size of the smaller in these; none when their boxes are
    /// apart.
    fn units_with(&self, other: &Self) -> Option<(Units, f64)> {
        let low: V3 = std::array::from_fn(|k| self.low[k].max(other.low[k]));
        let high: V3 = std::array::from_fn(|k| self.high[k].min(other.high[k]));
        let centre: V3 = std::array::from_fn(|k| f64::midpoint(low[k], high[k]));
        let ends = [&self.low, &self.high, &other.low, &other.high];
        let scale = ends
            .iter()
            .flat_map(|end| minus(end, &centre))
            .fold(0.0_f64, |most, x| most.max(x.abs()));
        let room = 1e-13 * scale;
        if scale == 0.0 || (0..3).any(|k| low[k] > high[k] + room) {
            return None;
        }
        // A power of two, so that nothing is rounded.
        let scale = libm::ldexp(1.0, libm::ilogb(scale).clamp(-1000, 1000));
        let sizes = [self, other]
            .map(|hull| norm(&std::array::from_fn(|k| hull.high[k] / scale - hull.low[k] / scale)));
        Some((Units { centre, scale }, sizes[0].min(sizes[1])))
    }

    fn pieces(&self, units: Units) -> Vec<Piece> {
        let piece = |part: &Positive| {
            let patch = Patch::new(&part.form, &units.centre, units.scale, part.weight);
            let tree = Tree::new(&patch);
            Piece { patch, tree, lower: part.lower, upper: part.upper }
        };
        self.parts.iter().map(piece).collect()
    }
}

/// The answers of all pairs of pieces, in the parameters of the surfaces.
#[derive(Default)]
struct Gathered {
    arcs: Vec<Arc>,
    touches: Vec<Touch>,
    overlaps: Vec<Cell>,
    undecided: Vec<Cell>,
    /// Does something rest on what was seen, not on what was proved?
    seen: bool,
}

impl Gathered {
    fn add(&mut self, one: &mut Piece, other: &mut Piece, limits: Limits, work: &mut Work) {
        let join = |p: [f64; 2], q: [f64; 2]| [p[0], p[1], q[0], q[1]];
        let (lower, upper) = (join(one.lower, other.lower), join(one.upper, other.upper));
        let place = |x: &Place| std::array::from_fn(|k| global(x[k], lower[k], upper[k]));
        let cell = |cell: Cell| Cell {
            lower: place(&cell.lower.map(|t| t.max(0.0))),
            upper: place(&cell.upper.map(|t| t.min(1.0))),
        };
        let mut trees = [&mut one.tree, &mut other.tree];
        let met = meet([&one.patch, &other.patch], &mut trees, limits, work);
        self.seen |= !met.proved;
        self.arcs.extend(met.arcs.into_iter().map(|mut arc| {
            arc.knots.iter_mut().for_each(|knot| *knot = in_windows(knot, &lower, &upper));
            arc
        }));
        let touches = met.touches.into_iter().map(|touch| Touch { x: place(&touch.x), ..touch });
        self.touches.extend(touches);
        self.overlaps.extend(met.overlaps.into_iter().map(cell));
        self.undecided.extend(met.undecided.into_iter().map(cell));
    }

    fn settle(self, units: Units, answer: &mut Intersections) -> Result<()> {
        let mut kept: Vec<Touch> = Vec::new();
        for touch in self.touches {
            let known = kept.iter().any(|other| apart(&other.p, &touch.p) < 1e-8);
            let passed = touch.crossing && self.arcs.iter().any(|arc| arc.comes_to(&touch.p, 1e-7));
            if !known && !passed {
                kept.push(touch);
            }
        }
        answer.branches = branches(self.arcs, units)?;
        answer.contacts = kept.iter().map(|touch| contact(touch, units)).collect();
        answer.overlaps = merged(&self.overlaps).iter().map(overlap).collect();
        answer.undecided = merged(&self.undecided).iter().map(undecided).collect();
        answer.complete = answer.undecided.is_empty() && !self.seen;
        Ok(())
    }
}

fn contact(touch: &Touch, units: Units) -> Contact {
    Contact {
        first: touch.x[..2].to_vec(),
        second: touch.x[2..].to_vec(),
        point: in_space(&touch.p, units),
        kind: match (touch.crossing, touch.is_pole()) {
            (true, false) => ContactKind::Crossing,
            (true, true) => ContactKind::Touch,
            _ => ContactKind::Tangent,
        },
        order: match (touch.known, touch.crossing) {
            (true, true) => 1,
            (true, false) => 2,
            _ => 0,
        },
        gap: touch.gap * units.scale,
        error: 1e-7,
        proved: false,
    }
}

/// Boxes joined where they touch.
fn merged(cells: &[Cell]) -> Vec<Cell> {
    let mut all: Vec<Cell> = Vec::new();
    for cell in cells {
        let mut cell = *cell;
        while let Some(at) = all.iter().position(|other| cell.touches(other)) {
            cell = cell.with(&all.swap_remove(at));
        }
        all.push(cell);
    }
    all
}

impl Cell {
    fn touches(&self, other: &Self) -> bool {
        (0..4).all(|k| {
            self.lower[k] <= other.upper[k] + 1e-9 && other.lower[k] <= self.upper[k] + 1e-9
        })
    }

    fn with(&self, other: &Self) -> Self {
        Self {
            lower: std::array::from_fn(|k| self.lower[k].min(other.lower[k])),
            upper: std::array::from_fn(|k| self.upper[k].max(other.upper[k])),
        }
    }

    fn halves(&self) -> [[Vec<f64>; 2]; 2] {
        let side = |from: usize| [self.lower, self.upper].map(|x| x[from..from + 2].to_vec());
        [side(0), side(2)]
    }
}

fn overlap(cell: &Cell) -> Overlap {
    let [first, second] = cell.halves();
    Overlap { first, second, gap: 0.0, proved: false }
}

fn undecided(cell: &Cell) -> Undecided {
    let [first, second] = cell.halves();
    Undecided { first, second }
}
