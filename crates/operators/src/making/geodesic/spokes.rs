//! Where places over the tangent plane of a collapsed edge are on the surface.

use super::atlas::Atlas;
use super::cap::Cap;
use super::metric::Net;
use crate::measuring::vector::{dot, norm};

/// One piece of the surface at the edge: `u` along the edge, `v` away from it.
pub(super) struct Member {
    pub net: usize,
    /// `Y`, with `f = P + v·Y`.
    pub offsets: Net,
    /// Its projection on the tangent plane.
    shadow: Net,
    /// Directions of `Y(u, 0)` in the tangent plane, of length 1, at places evenly spread.
    pub table: Vec<[f64; 2]>,
    /// The angle they turn through.
    pub turn: f64,
}

/// Where a place over the tangent plane is on the surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Polar {
    pub member: usize,
    pub u: f64,
    pub v: f64,
    /// Is it known to be there?
    pub found: bool,
}

/// Places of a table.
pub(super) const PLACES: usize = 32;

/// A last step of Newton's, before which all digits are right.
const SMALL: f64 = 1e-10;

impl Cap {
    /// Where the surface is over a place; `u` leaves the window only beyond the sides of an open one.
    pub(super) fn find(&self, place: [f64; 2], heading: [f64; 2]) -> Polar {
        let distance = norm(&place);
        let direction = if distance > 0.0 { place } else { heading };
        let (mut member, mut u) = self.nearest_spoke(direction);
        let mut v = distance / norm(&self.members[member].shadow_at(u, 0.0)[0]);
        for _ in 0..40 {
            let [y, yu, yv] = self.members[member].shadow_at(u, v);
            let (du, dv) = if distance > 0.0 {
                // v·Y = place: Newton's step for u and v.
                let miss = [v * y[0] - place[0], v * y[1] - place[1]];
                let step = solved([yu, [y[0] + v * yv[0], y[1] + v * yv[1]]], miss);
                (-step[0] / v, -step[1])
            } else {
                (-turned(y, heading) / turned(yu, heading), 0.0)
            };
            if !(du.is_finite() && dv.is_finite()) {
                break;
            }
            u += du.clamp(-0.25, 0.25);
            v = (v + dv).max(0.5 * v);
            (member, u) = self.rehomed(member, u);
            // The next step would be the square of this one.
            if du.abs() <= SMALL && dv.abs() <= SMALL * v {
                break;
            }
        }
        let [y, ..] = self.members[member].shadow_at(u, v);
        let found = dot(&y, &direction) > (1.0 - 1e-9) * norm(&y) * norm(&direction);
        Polar { member, u, v, found }
    }

    /// A place beyond the sides of a piece, as its neighbour counts it, if there is one.
    fn rehomed(&self, member: usize, u: f64) -> (usize, f64) {
        let last = self.members.len() - 1;
        if u < 0.0 && (member > 0 || self.closed) {
            let to = if member > 0 { member - 1 } else { last };
            return (to, 1.0 + u * self.pace(member, to));
        }
        if u > 1.0 && (member < last || self.closed) {
            let to = if member < last { member + 1 } else { 0 };
            return (to, (u - 1.0) * self.pace(member, to));
        }
        (member, u)
    }

    /// How much faster the angle turns in one piece than in another, about.
    fn pace(&self, from: usize, to: usize) -> f64 {
        let ratio = self.members[from].turn / self.members[to].turn;
        if ratio.is_finite() { ratio.clamp(0.01, 100.0) } else { 1.0 }
    }

    /// The spoke of the tables nearest to a direction.
    fn nearest_spoke(&self, direction: [f64; 2]) -> (usize, f64) {
        let mut best = (0, 0, f64::NEG_INFINITY);
        for (member, one) in self.members.iter().enumerate() {
            for (k, spoke) in one.table.iter().enumerate() {
                let along = spoke[0] * direction[0] + spoke[1] * direction[1];
                if along > best.2 {
                    best = (member, k, along);
                }
            }
        }
        (best.0, best.1 as f64 / PLACES as f64)
    }

    /// Is a place on the surface, and not beyond the sides of an open one by more than `slack` in `u`?
    pub(super) fn holds(&self, at: Polar, slack: f64) -> bool {
        self.closed || at.found && (-slack..=1.0 + slack).contains(&at.u)
    }
}

impl Member {
    pub(super) fn new(atlas: &Atlas, net: usize, axis: usize, side: usize, apex: &[f64]) -> Self {
        let from = &atlas.nets[net];
        let (along, away) = (from.orders[1 - axis], from.orders[axis]);
        let pole = |plane: usize, a: usize, b: usize| {
            let b = if side == 0 { b } else { away - 1 - b };
            if axis == 0 { from.pole(plane, b, a) } else { from.pole(plane, a, b) }
        };
        let mut poles = Vec::with_capacity((from.ambient + 1) * along * away);
        for (plane, origin) in apex.iter().enumerate() {
            for a in 0..along {
                // Those of the edge itself vanish.
                let offset = |b: usize| {
                    if b == 0 { 0.0 } else { pole(plane, a, b) - origin * pole(from.ambient, a, b) }
                };
                // Divided by v, and raised to the degree of the weights.
                poles.extend((0..away).map(|b| {
                    let rest = (away - 1 - b) as f64 / (b + 1) as f64;
                    offset(b) + if b + 1 < away { rest * offset(b + 1) } else { 0.0 }
                }));
            }
        }
        for a in 0..along {
            poles.extend((0..away).map(|b| pole(from.ambient, a, b)));
        }
        let offsets = Net { orders: [along, away], poles, ..*from };
        let shadow = Net { orders: [along, away], poles: Vec::new(), ..*from };
        Self { net, offsets, shadow, table: Vec::new(), turn: 0.0 }
    }

    /// Projects it on a plane, and makes the table from the spokes there.
    pub(super) fn cast(&mut self, basis: &[Vec<f64>; 2], spokes: &[Vec<f64>]) {
        let Net { orders, ambient, rational, ref poles } = self.offsets;
        let size = orders[0] * orders[1];
        let mut cast = vec![0.0; 3 * size];
        for (plane, poles) in poles.chunks_exact(size).enumerate() {
            for (k, x) in poles.iter().enumerate() {
                if plane == ambient {
                    cast[2 * size + k] = *x;
                } else {
                    cast[k] += basis[0][plane] * x;
                    cast[size + k] += basis[1][plane] * x;
                }
            }
        }
        self.shadow = Net { orders, ambient: 2, rational, poles: cast };
        let direction = |y: &Vec<f64>| {
            let flat = [dot(y, &basis[0]), dot(y, &basis[1])];
            flat.map(|x| x / norm(&flat))
        };
        self.table = spokes.iter().map(direction).collect();
    }

    /// `Y(u, 0)`.
    pub(super) fn offset(&self, u: f64) -> Vec<f64> {
        let [y, ..] = self.offsets.jet([u, 0.0]);
        y
    }

    /// `Y`, `Y_u`, `Y_v`, projected.
    pub(super) fn shadow_at(&self, u: f64, v: f64) -> [[f64; 2]; 3] {
        let mut at = [[0.0; 2]; 3];
        let mut k = 0;
        self.shadow.each([u, v], &mut |one| {
            for (row, x) in at.iter_mut().zip(one) {
                row[k] = x;
            }
            k += 1;
        });
        at
    }
}

pub(super) fn turned(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// The solution of a system with these columns.
pub(super) fn solved([a, b]: [[f64; 2]; 2], x: [f64; 2]) -> [f64; 2] {
    [turned(x, b) / turned(a, b), turned(a, x) / turned(a, b)]
}
