//! Arcs of all pairs of pieces, put end to end to whole branches.

use pforms_kernel::{Form, Result};

use super::hermite::poles;
use super::pair::Knot;
use super::space::{V3, apart, dot, plus, times};
use super::trace::{Arc, End};
use crate::Spline;
use crate::measuring::intersect::answer::Branch;

/// Where numbers of the pieces lie in space.
#[derive(Clone, Copy)]
pub(super) struct Units {
    pub centre: V3,
    pub scale: f64,
}

/// Ends nearer than this are one, in common units.
const SAME: f64 = 1e-8;

/// All branches that the arcs, in the parameters of the surfaces, make.
pub(super) fn branches(mut arcs: Vec<Arc>, units: Units) -> Result<Vec<Branch>> {
    drop_repeated(&mut arcs);
    let partners = partners(&arcs);
    let mut taken = vec![false; arcs.len()];
    let mut found = Vec::new();
    // Open branches from one of their ends, then what is left: loops of arcs.
    let open = |arc: usize| (0..2).find(|end| partners[arc][*end].is_none());
    let starts = (0..arcs.len()).filter_map(|arc| open(arc).map(|end| (arc, end)));
    let starts: Vec<(usize, usize)> = starts.chain((0..arcs.len()).map(|arc| (arc, 0))).collect();
    for (arc, end) in starts {
        if taken[arc] {
            continue;
        }
        let mut chain = Vec::new();
        let mut next = Some((arc, end));
        while let Some((arc, end)) = next.filter(|(arc, _)| !taken[*arc]) {
            taken[arc] = true;
            let run = arcs[arc].clone();
            chain.push(if end == 0 { run } else { run.reversed() });
            next = partners[arc][1 - end];
        }
        found.push(branch(&chain, units)?);
    }
    Ok(found)
}

/// Drops arcs that run where another does: along a border that two pieces share, or a little way
/// where the curve touches a border and rounding lets it cross.
fn drop_repeated(arcs: &mut Vec<Arc>) {
    arcs.sort_by(|a, b| b.length().total_cmp(&a.length()));
    let mut kept: Vec<Arc> = Vec::with_capacity(arcs.len());
    for arc in arcs.drain(..) {
        let suspect = arc.length() < SHORT || arc.runs_along_border();
        if !(suspect && kept.iter().any(|other| other.runs_over(&arc))) {
            kept.push(arc);
        }
    }
    *arcs = kept;
}

/// An arc shorter than this may be rounding alone, in common units.
const SHORT: f64 = 1e-5;

/// For both ends of every arc the end of an arc that goes on from there.
fn partners(arcs: &[Arc]) -> Vec<[Option<(usize, usize)>; 2]> {
    let mut partners = vec![[None; 2]; arcs.len()];
    let mut ends = Vec::new();
    for (number, arc) in arcs.iter().enumerate() {
        if arc.ends[1] != End::Closed {
            ends.extend([(number, 0, arc.outward(0)), (number, 1, arc.outward(1))]);
        }
    }
    let mut meetings = Vec::new();
    for (at, (arc, end, knot)) in ends.iter().enumerate() {
        for (other, other_end, next) in &ends[at + 1..] {
            if apart(&knot.p, &next.p) < SAME && arcs[*arc].tangent == arcs[*other].tangent {
                meetings.push((dot(&knot.dp, &next.dp), (*arc, *end), (*other, *other_end)));
            }
        }
    }
    meetings.sort_by(|a, b| a.0.total_cmp(&b.0));
    let crowded = |(arc, end): (usize, usize)| {
        meetings.iter().filter(|(_, a, b)| *a == (arc, end) || *b == (arc, end)).count() > 1
    };
    for (turn, a, b) in &meetings {
        let straight = *turn < -0.99;
        if partners[a.0][a.1].is_none()
            && partners[b.0][b.1].is_none()
            && (straight || !(crowded(*a) || crowded(*b)))
        {
            partners[a.0][a.1] = Some(*b);
            partners[b.0][b.1] = Some(*a);
        }
    }
    partners
}

impl Arc {
    /// The knot at an end, directed away from the arc.
    fn outward(&self, end: usize) -> Knot {
        if end == 0 { self.knots[0].reversed() } else { self.knots[self.knots.len() - 1] }
    }

    fn runs_along_border(&self) -> bool {
        (0..4).any(|k| {
            let first = self.knots[0].x[k];
            self.knots.iter().all(|knot| (knot.x[k] - first).abs() < 1e-8)
        })
    }

    /// Are the ends and all knots of another arc on this one, in space?
    fn runs_over(&self, other: &Self) -> bool {
        other.knots.iter().all(|knot| self.comes_to(&knot.p, 100.0 * SAME))
    }

    fn length(&self) -> f64 {
        self.lengths.iter().sum()
    }
}

/// The curves of a chain of arcs.
fn branch(chain: &[Arc], units: Units) -> Result<Branch> {
    let mut breaks = vec![0.0];
    let (mut space, mut first, mut second) = (Path::new(3), Path::new(2), Path::new(2));
    for arc in chain {
        for (pair, length) in arc.knots.windows(2).zip(&arc.lengths) {
            let (from, to) = (&pair[0], &pair[1]);
            let curve = poles(*length, [&from.p, &from.dp, &from.ddp], [&to.p, &to.dp, &to.ddp]);
            let out = curve.map(|p| plus(&units.centre, units.scale, &p));
            let places = poles(*length, [&from.x, &from.dx, &from.ddx], [&to.x, &to.dx, &to.ddx]);
            space.add(&out.map(|p| p.to_vec()), false);
            first.add(&places.map(|x| x[..2].to_vec()), true);
            second.add(&places.map(|x| x[2..].to_vec()), true);
            breaks.push(breaks[breaks.len() - 1] + length * units.scale);
        }
    }
    let [begin, end] = [chain.first(), chain.last()].map(|arc| arc.map_or(0, |a| a.knots.len()));
    let closed = begin > 0
        && end > 0
        && apart(&chain[0].knots[0].p, &chain[chain.len() - 1].knots[end - 1].p) < SAME
        && breaks.len() > 2;
    let error = chain.iter().fold(0.0_f64, |most, arc| most.max(arc.error));
    Ok(Branch {
        first: first.spline(&breaks)?,
        second: second.spline(&breaks)?,
        curve: space.spline(&breaks)?,
        error: 2.0 * error.max(f64::EPSILON) * units.scale,
        closed,
        tangent: chain.iter().any(|arc| arc.tangent),
    })
}

/// Quintic pieces end to end.
struct Path {
    ambient: usize,
    points: Vec<f64>,
    /// For every break before the last, is there a jump?
    jumps: Vec<bool>,
}

impl Path {
    fn new(ambient: usize) -> Self {
        Self { ambient, points: Vec::new(), jumps: Vec::new() }
    }

    /// Adds a piece; `may_jump` keeps both ends where it does not begin where the last one ended.
    fn add(&mut self, piece: &[Vec<f64>; 6], may_jump: bool) {
        let last = self.points.len().checked_sub(self.ambient).map(|at| &self.points[at..]);
        let off = |last: &[f64]| last.iter().zip(&piece[0]).any(|(a, b)| (a - b).abs() > 1e-7);
        let jump = last.is_none_or(|last| may_jump && off(last));
        self.jumps.push(jump);
        let kept = usize::from(!jump);
        self.points.extend(piece[kept..].iter().flatten());
    }

    fn spline(&self, breaks: &[f64]) -> Result<Spline> {
        let mut knots = Vec::with_capacity(6 * breaks.len());
        for (t, jump) in breaks.iter().zip(self.jumps.iter().chain([&true])) {
            knots.extend(vec![*t; if *jump { 6 } else { 5 }]);
        }
        let order = self.points.len() / self.ambient;
        let net = Form::from_points(&[order], self.ambient, &self.points, None)?;
        Spline::new(net, &[5], vec![knots])
    }
}

/// A knot in the parameters of the surfaces, whose pieces have these windows.
pub(super) fn in_windows(knot: &Knot, lower: &[f64; 4], upper: &[f64; 4]) -> Knot {
    let size: [f64; 4] = std::array::from_fn(|k| upper[k] - lower[k]);
    let scaled = |d: &[f64; 4]| std::array::from_fn(|k| d[k] * size[k]);
    let x = std::array::from_fn(|k| global(knot.x[k], lower[k], upper[k]));
    Knot { x, dx: scaled(&knot.dx), ddx: scaled(&knot.ddx), ..*knot }
}

/// A parameter of a piece as one of the surface; the ends are met exactly.
pub(super) fn global(t: f64, lower: f64, upper: f64) -> f64 {
    if t <= 1e-9 {
        lower
    } else if t >= 1.0 - 1e-9 {
        upper
    } else {
        lower + t * (upper - lower)
    }
}

/// A point of the pieces in space.
pub(super) fn in_space(p: &V3, units: Units) -> Vec<f64> {
    plus(&units.centre, 1.0, &times(p, units.scale)).to_vec()
}
