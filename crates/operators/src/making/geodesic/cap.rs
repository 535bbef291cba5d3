//! Across a collapsed edge, such as the pole of a sphere.
//!
//! There `f_u` vanishes and the parameters say nothing, but the surface may be smooth. With `P` the point the
//! edge collapses to, `f = P + v·Y(u, v)`, `Y` rational of one degree less, without cancellation; `Y_u` and
//! `f_v = Y + v·Y_v` span the tangent plane also where `v = 0`. Places are given by their projection on the
//! tangent plane at `P`, in which a course through the pole is as smooth as any other.

use super::atlas::Atlas;
use super::local::Local;
use super::metric::Metric;
use super::spokes::{Member, PLACES, Polar, solved, turned};
use crate::measuring::vector::{dot, norm, plus, unit};

/// The surface around a collapsed edge, over its tangent plane there.
pub(super) struct Cap {
    pub basis: [Vec<f64>; 2],
    pub members: Vec<Member>,
    /// Does the surface go all the way round?
    pub closed: bool,
    /// The axis that ends here, and on which side.
    pub axis: usize,
    pub side: usize,
    /// How far into the pieces, of their windows, the projection is used.
    pub reach: f64,
}

/// Widest share of a piece that the projection is used for.
const WIDEST: f64 = 0.25;

/// Cosine of the angle with the tangent plane at the apex up to which a projection is good.
const STEEPEST: f64 = 0.6;

/// Below this distance from the apex directions are rounding: bending is taken from here.
const CLOSE: f64 = 1e-6;

impl Cap {
    /// None when the surface has no tangent plane there, or covers it more than once.
    pub(super) fn new(
        atlas: &Atlas,
        axis: usize,
        side: usize,
        apex: &[f64],
        closed: bool,
    ) -> Option<Self> {
        let nets = atlas.along_side(axis, side);
        if nets.iter().any(|net| atlas.nets[*net].orders[axis] < 2) {
            return None;
        }
        let mut members: Vec<Member> =
            nets.iter().map(|net| Member::new(atlas, *net, axis, side, apex)).collect();
        let spokes: Vec<Vec<f64>> = members
            .iter()
            .flat_map(|member| (0..=PLACES).map(|k| member.offset(k as f64 / PLACES as f64)))
            .collect();
        let basis = plane_of(&spokes)?;
        for (member, spokes) in members.iter_mut().zip(spokes.chunks_exact(PLACES + 1)) {
            member.cast(&basis, spokes);
        }
        let mut turns = 0.0;
        for member in &mut members {
            member.turn = turning(&member.table)?;
            if member.turn * turns < 0.0 {
                return None;
            }
            turns += member.turn;
        }
        let round = (turns.abs() - std::f64::consts::TAU).abs() < 1e-9;
        if turns.abs() > std::f64::consts::TAU + 1e-9 {
            return None;
        }
        let mut cap = Self { basis, members, closed: closed && round, axis, side, reach: WIDEST };
        for _ in 0..12 {
            if cap.is_flat() {
                return Some(cap);
            }
            cap.reach /= 2.0;
        }
        None
    }

    /// Is the surface nowhere steep over the tangent plane, as far as `reach`?
    fn is_flat(&self) -> bool {
        let mut sign = 0.0;
        for member in 0..self.members.len() {
            for k in 0..=PLACES {
                for part in 0..=4 {
                    let v = 1.2 * self.reach * f64::from(part) / 4.0;
                    let u = k as f64 / PLACES as f64;
                    let local = self.local(Polar { member, u, v, found: true });
                    let [[a, c], [b, d]] = local.projected;
                    let flat = a * d - b * c;
                    let area = local.area().sqrt();
                    if sign == 0.0 {
                        sign = flat.signum();
                    }
                    // Written so that NaN counts as steep.
                    let gentle = flat * sign >= STEEPEST * area && area > 0.0;
                    if !gentle {
                        return false;
                    }
                }
            }
        }
        true
    }

    fn local(&self, at: Polar) -> Local {
        Local::new(&self.members[at.member].offsets, &self.basis, at)
    }

    /// A place and a velocity on a piece, over the tangent plane.
    pub(super) fn over(
        &self,
        net: usize,
        place: [f64; 2],
        velocity: [f64; 2],
    ) -> Option<([f64; 2], [f64; 2])> {
        let member = self.members.iter().position(|member| member.net == net)?;
        let (u, v) = self.sorted(place);
        let at = Polar { member, u, v, found: true };
        let y = self.members[member].shadow_at(u, v)[0];
        let local = self.local(at);
        let speed = if self.side == 0 { velocity[self.axis] } else { -velocity[self.axis] };
        let w = v * velocity[1 - self.axis];
        let [a, b] = local.projected;
        Some(([v * y[0], v * y[1]], [a[0] * w + b[0] * speed, a[1] * w + b[1] * speed]))
    }

    fn sorted(&self, place: [f64; 2]) -> (f64, f64) {
        let v = place[self.axis];
        (place[1 - self.axis], if self.side == 0 { v } else { 1.0 - v })
    }

    /// The piece, place and velocity under a place of the tangent plane.
    pub(super) fn under(&self, place: [f64; 2], velocity: [f64; 2]) -> (usize, [f64; 2], [f64; 2]) {
        let at = self.find(place, velocity);
        let local = self.local(at);
        let [w, speed] = solved(local.projected, velocity);
        let mut result = ([0.0; 2], [0.0; 2]);
        result.0[1 - self.axis] = at.u;
        result.0[self.axis] = if self.side == 0 { at.v } else { 1.0 - at.v };
        result.1[1 - self.axis] = w / at.v;
        result.1[self.axis] = if self.side == 0 { speed } else { -speed };
        (self.members[at.member].net, result.0, result.1)
    }

    /// The piece and place under a place of the tangent plane.
    pub(super) fn place_under(&self, place: [f64; 2], heading: [f64; 2]) -> (usize, [f64; 2]) {
        let at = self.find(place, heading);
        let mut found = [0.0; 2];
        found[1 - self.axis] = at.u;
        found[self.axis] = if self.side == 0 { at.v } else { 1.0 - at.v };
        (self.members[at.member].net, found)
    }

    /// The direction in space of a velocity over the tangent plane.
    pub(super) fn direction(&self, place: [f64; 2], velocity: [f64; 2]) -> Vec<f64> {
        let local = self.local(self.find(place, velocity));
        let [w, speed] = solved(local.projected, velocity);
        local.direction(w, speed)
    }

    /// A vector at the apex over the tangent plane.
    pub(super) fn projected(&self, vector: &[f64]) -> [f64; 2] {
        [dot(vector, &self.basis[0]), dot(vector, &self.basis[1])]
    }

    /// What a course feels at a place: products of the tangents over the plane, its acceleration, and the Gauss
    /// curvature.
    pub(super) fn look(&self, place: [f64; 2], velocity: [f64; 2]) -> (Metric<f64>, [f64; 2], f64) {
        let distance = norm(&place);
        let place = if distance >= CLOSE {
            place
        } else {
            let heading = if distance > 0.0 { place } else { velocity };
            let factor = CLOSE / norm(&heading);
            [heading[0] * factor, heading[1] * factor]
        };
        let local = self.local(self.find(place, velocity));
        let [w, speed] = solved(local.projected, velocity);
        let acceleration = local.bend(&self.basis, w, speed);
        let over = [[1.0, 0.0], [0.0, 1.0]].map(|side| solved(local.projected, side));
        let [x, y] = over;
        let first = [local.product(x, x), local.product(x, y), local.product(y, y)];
        let metric = Metric { first, bends: [[0.0; 2]; 3], twist: 0.0 };
        (metric, acceleration, local.curvature())
    }
}

/// The plane that all vectors lie in, if there is one.
fn plane_of(vectors: &[Vec<f64>]) -> Option<[Vec<f64>; 2]> {
    if vectors.iter().any(|x| !(norm(x) > 0.0 && norm(x).is_finite())) {
        return None;
    }
    let first = unit(vectors.first()?);
    let rest = |x: &Vec<f64>| plus(x, -dot(x, &first), &first);
    let lean = |x: &Vec<f64>| norm(&rest(x)) / norm(x);
    let widest = vectors.iter().max_by(|a, b| lean(a).total_cmp(&lean(b)))?;
    if lean(widest) < 1e-3 {
        return None;
    }
    let second = unit(&rest(widest));
    let outside = |x: &Vec<f64>| {
        let rest = rest(x);
        norm(&plus(&rest, -dot(&rest, &second), &second)) > 1e-10 * norm(x)
    };
    if vectors.iter().any(outside) {
        return None;
    }
    Some([first, second])
}

/// The angle that spokes turn through; none when they turn back.
fn turning(spokes: &[[f64; 2]]) -> Option<f64> {
    let mut total = 0.0;
    for pair in spokes.windows(2) {
        let turn = libm::atan2(turned(pair[0], pair[1]), dot(&pair[0], &pair[1]));
        if turn == 0.0 || turn * total < 0.0 {
            return None;
        }
        total += turn;
    }
    Some(total)
}
