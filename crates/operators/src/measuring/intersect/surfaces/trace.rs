//! Following a curve from knot to knot, with steps as long as a quintic follows it.

use super::contact::Touch;
use super::hermite::Piece;
use super::pair::{Knot, Place};
use super::space::{V3, apart, dot, minus, norm, plus};
use super::track::Track;

/// A part of the intersection, from end to end.
#[derive(Clone)]
pub(super) struct Arc {
    pub knots: Vec<Knot>,
    /// Of the pieces between them.
    pub lengths: Vec<f64>,
    /// Largest distance found between a piece and the surfaces, or the curve.
    pub error: f64,
    /// How it begins and ends.
    pub ends: [End; 2],
    /// Do the surfaces touch along it?
    pub tangent: bool,
}

/// How an arc ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum End {
    /// On the border of a piece.
    Border,
    /// Where several branches cross.
    Node,
    /// Where it began.
    Closed,
    /// Where it could not be followed.
    Lost,
}

/// What steps are allowed.
#[derive(Clone, Copy)]
pub(super) struct Limits {
    /// Largest distance of a piece from the curve.
    pub error: f64,
    /// Longest step.
    pub longest: f64,
    /// Distance up to which surfaces that touch have a point in common.
    pub reach: f64,
}

/// Places outside the window by less are on its border.
pub(super) const BORDER: f64 = 1e-9;

/// Knots of one arc at most.
const MOST: usize = 20_000;

/// Steps shorter than this lead nowhere.
const SHORTEST: f64 = 1e-9;

/// Neighbouring tangents differ by less than the angle of this cosine.
const ALIGNED: f64 = 0.9;

/// Follows the curve from a knot in its direction, until it leaves the window, comes to one of the
/// nodes or back to its start.
pub(super) fn trace(track: &impl Track, start: Knot, limits: Limits, nodes: &[Touch]) -> Arc {
    let mut arc = Arc {
        knots: vec![start],
        lengths: Vec::new(),
        error: 0.0,
        ends: [End::Lost; 2],
        tangent: false,
    };
    let bend = norm(&start.ddp);
    let mut h = limits.longest.min(0.2 / bend.max(1e-9));
    let mut now = start;
    while h > SHORTEST && arc.knots.len() < MOST {
        match arc.arrival(track, &now, &mut h, limits, nodes) {
            Arrival::Here => return arc.ended(End::Node),
            Arrival::Ahead => continue,
            Arrival::None => {}
        }
        let Some((next, piece, error)) = step(track, &now, h, limits.error) else {
            h *= 0.4;
            continue;
        };
        if let Some(last) = arc.closing(track, &now, &piece, limits.error) {
            arc.push(start, last);
            return arc.ended(End::Closed);
        }
        if !is_inside(&next.x) {
            match leaving(track, &now, &piece, limits.error) {
                Some(Leaving::Now) => return arc.ended(End::Border),
                Some(Leaving::At(last, length, error)) => {
                    arc.push(last, (length, error));
                    return arc.ended(End::Border);
                }
                None => {
                    h *= 0.4;
                    continue;
                }
            }
        }
        arc.push(next, (piece.length, error));
        now = next;
        let growth = libm::pow(0.25 * limits.error / error.max(1e-300), 1.0 / 6.0);
        h = (h * growth.clamp(0.3, 2.0)).min(limits.longest);
    }
    arc
}

/// Is a place in the window of both pieces?
pub(super) fn is_inside(x: &Place) -> bool {
    x.iter().all(|t| (-BORDER..=1.0 + BORDER).contains(t))
}

/// The knot a step ahead with the piece that leads there and its error, if that is small enough.
fn step(track: &impl Track, now: &Knot, h: f64, allowed: f64) -> Option<(Knot, Piece, f64)> {
    let ahead = plus(&plus(&now.p, h, &now.dp), 0.5 * h * h, &now.ddp);
    let guess = plus(&plus(&now.x, h, &now.dx), 0.5 * h * h, &now.ddx);
    let x = track.in_plane(&guess, &ahead, &now.dp)?;
    let next = track.knot(&x, &now.dp)?;
    let (piece, error) = checked(track, now, &next, allowed)?;
    Some((next, piece, error))
}

/// The piece between two knots, if it is as near to the curve as is allowed.
fn checked(track: &impl Track, now: &Knot, next: &Knot, allowed: f64) -> Option<(Piece, f64)> {
    let chord = minus(&next.p, &now.p);
    let length = norm(&chord);
    let bent = dot(&now.dp, &next.dp) < ALIGNED
        || dot(&chord, &now.dp) < ALIGNED * length
        || dot(&chord, &next.dp) < ALIGNED * length;
    if bent {
        return None;
    }
    let piece = Piece::between(now, next);
    let (p, slope, guess) = piece.at(0.5);
    let along = super::space::unit(&slope)?;
    let [a, b] = track.points(&guess);
    let near = norm(&minus(&a, &p)).max(norm(&minus(&b, &p)));
    if near > allowed {
        return None;
    }
    let x = track.in_plane(&guess, &p, &along)?;
    let [a, b] = track.points(&x);
    let middle: V3 = std::array::from_fn(|k| f64::midpoint(a[k], b[k]));
    let error = near.max(norm(&minus(&middle, &p)));
    (error <= allowed).then_some((piece, error))
}

/// How a step leaves the window.
enum Leaving {
    /// It never was inside.
    Now,
    /// At this knot, by a piece of this length and error.
    At(Knot, f64, f64),
}

fn leaving(track: &impl Track, now: &Knot, piece: &Piece, allowed: f64) -> Option<Leaving> {
    let out = |axis: usize| -> Option<(f64, usize, f64)> {
        let t = piece.places[5][axis];
        let value = if t < -BORDER {
            0.0
        } else if t > 1.0 + BORDER {
            1.0
        } else {
            return None;
        };
        // What begins on the border, and goes out, leaves at once.
        Some((piece.reaches(axis, value).unwrap_or(0.0), axis, value))
    };
    let exits = (0..4).filter_map(out);
    let (share, axis, value) = exits.min_by(|a, b| a.0.total_cmp(&b.0))?;
    let (_, _, mut guess) = piece.at(share);
    guess[axis] = value;
    let x = track.on_line(&guess, axis)?;
    if apart(&x, &now.x) < 10.0 * BORDER {
        return Some(Leaving::Now);
    }
    if apart(&x, &guess) > 0.1 || !x.iter().all(|t| (-1e-7..=1.0 + 1e-7).contains(t)) {
        return None;
    }
    let last = track.knot(&x, &now.dp)?;
    let (piece, error) = checked(track, now, &last, allowed)?;
    Some(Leaving::At(last, piece.length, error))
}

/// Whether a node is near.
enum Arrival {
    None,
    /// The step was shortened.
    Ahead,
    /// The arc ends there.
    Here,
}

impl Touch {
    /// The knot at a collapsed border, by going straight on from a knot near it.
    fn pole_after(&self, now: &Knot, far: f64) -> Option<Knot> {
        if !self.is_pole() {
            return None;
        }
        let dp = super::space::unit(&plus(&now.dp, far, &now.ddp))?;
        let dx = plus(&now.dx, far, &now.ddx);
        let mut x = self.x;
        for (axis, value) in self.poles.into_iter().flatten() {
            let along = axis ^ 1;
            x[along] = now.x[along] + far * (now.dx[along] + 0.5 * far * now.ddx[along]);
            x[axis] = value;
        }
        Some(Knot { x, dx, ddx: now.ddx, p: self.p, dp, ddp: now.ddp, sine: now.sine })
    }
}

impl Arc {
    fn push(&mut self, knot: Knot, (length, error): (f64, f64)) {
        self.knots.push(knot);
        self.lengths.push(length);
        self.error = self.error.max(error);
    }

    /// The arc with this said of its start.
    pub(super) fn begun(mut self, end: End) -> Self {
        self.ends[0] = end;
        self
    }

    fn ended(mut self, end: End) -> Self {
        self.ends[1] = end;
        self
    }

    /// Ends the arc in a node when it leads there, or shortens the step towards it.
    fn arrival(
        &mut self,
        track: &impl Track,
        now: &Knot,
        h: &mut f64,
        limits: Limits,
        nodes: &[Touch],
    ) -> Arrival {
        for node in nodes {
            let way = minus(&node.p, &now.p);
            let far = norm(&way);
            if far > 2.0 * *h || far < SHORTEST || dot(&way, &now.dp) < 0.7 * far {
                continue;
            }
            if let Some(last) = node.pole_after(now, far)
                && let Some((piece, error)) = checked(track, now, &last, limits.error)
            {
                self.push(last, (piece.length, error));
                return Arrival::Here;
            }
            for half in &node.halves {
                let last = half.reversed();
                if let Some((piece, error)) = checked(track, now, &last, limits.error) {
                    self.push(last, (piece.length, error));
                    return Arrival::Here;
                }
            }
            if *h > 0.5 * far {
                *h = 0.5 * far;
                return Arrival::Ahead;
            }
        }
        Arrival::None
    }

    /// The length and error of the last piece, when a step passes the start.
    fn closing(
        &self,
        track: &impl Track,
        now: &Knot,
        piece: &Piece,
        allowed: f64,
    ) -> Option<(f64, f64)> {
        let start = &self.knots[0];
        if self.knots.len() < 3 || norm(&minus(&start.p, &now.p)) > 1.5 * piece.length {
            return None;
        }
        if !piece.passes(&start.x, 1e-6) {
            return None;
        }
        let (piece, error) = checked(track, now, start, allowed)?;
        Some((piece.length, error))
    }

    /// The pieces between the knots.
    pub(super) fn pieces(&self) -> impl Iterator<Item = Piece> {
        let ends = self.knots.windows(2).zip(&self.lengths);
        ends.map(|(pair, length)| Piece::over(&pair[0], &pair[1], *length))
    }

    /// Does it pass a place?
    pub(super) fn passes(&self, x: &Place, reach: f64) -> bool {
        self.pieces().any(|piece| piece.passes(x, reach))
    }

    /// Does it come so near to a point of space?
    pub(super) fn comes_to(&self, p: &V3, reach: f64) -> bool {
        self.pieces().any(|piece| piece.comes_to(p, reach))
    }

    /// The same arc, run the other way.
    pub(super) fn reversed(mut self) -> Self {
        self.knots = self.knots.into_iter().rev().map(Knot::reversed).collect();
        self.lengths.reverse();
        self.ends.reverse();
        self
    }

    /// This arc and one that begins where it ends.
    pub(super) fn then(mut self, next: &Self) -> Self {
        self.knots.extend(&next.knots[1..]);
        self.lengths.extend(&next.lengths);
        self.error = self.error.max(next.error);
        self.ends[1] = next.ends[1];
        self
    }
}
