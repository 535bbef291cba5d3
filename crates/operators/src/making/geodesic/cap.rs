//! Across a collapsed edge, such as the pole of a sphere.
//!
//! There `f_u` vanishes and the parameters say nothing, but the surface may be smooth. With `P` the point the
//! edge collapses to, `f = P + v·Y(u, v)`, `Y` rational of one degree less, without cancellation; `Y_u` and
//! `f_v = Y + v·Y_v` span the tangent plane also where `v = 0`. Places are given by their projection on the
//! tangent plane at `P`, in which a course through the pole is as smooth as any other.

use super::atlas::Atlas;
use super::metric::{Metric, Net, quotient};
use crate::measuring::vector::{dot, norm, plus, scaled, unit};

/// The surface around a collapsed edge, over its tangent plane there.
pub(super) struct Cap {
    basis: [Vec<f64>; 2],
    members: Vec<Member>,
    /// Does the surface go all the way round?
    closed: bool,
    /// The axis that ends here, and on which side.
    pub axis: usize,
    pub side: usize,
    /// How far into the pieces, of their windows, the projection is used.
    pub reach: f64,
}

/// One piece of the surface at the edge: `u` along the edge, `v` away from it.
struct Member {
    net: usize,
    offsets: Net,
    weights: Net,
    /// Directions of `Y(u, 0)` in the tangent plane, at places evenly spread.
    table: Vec<[f64; 2]>,
    /// The angle they turn through.
    turn: f64,
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

/// What the surface is like over a place.
struct Local {
    /// `Y_u` and `f_v`.
    tangents: [Vec<f64>; 2],
    /// Their projections, as columns.
    projected: [[f64; 2]; 2],
    /// Second derivatives without their tangential parts, for `u′ = w/v`: `Y_uu/v`, `Y_uv`, `f_vv`.
    bends: [Vec<f64>; 3],
}

/// Places of a table.
const PLACES: usize = 32;

/// Widest share of a piece that the projection is used for.
const WIDEST: f64 = 0.25;

/// Cosine of the angle with the tangent plane at the apex up to which a projection is good.
const STEEPEST: f64 = 0.6;

/// A last step of Newton's, before which all digits are right.
const SMALL: f64 = 1e-9;

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
            member.table = spokes.iter().map(|y| [dot(y, &basis[0]), dot(y, &basis[1])]).collect();
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

    pub(super) fn is_closed(&self) -> bool {
        self.closed
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
                    let [t, s] = &local.tangents;
                    let area = (dot(t, t) * dot(s, s) - dot(t, s) * dot(t, s)).sqrt();
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
        let [y, yu, yv, yuu, yuv, yvv] = self.members[at.member].jet(at.u, at.v);
        let fv = plus(&y, at.v, &yv);
        let mut bends = [scaled(&yuu, 1.0 / at.v), yuv, plus(&scaled(&yv, 2.0), at.v, &yvv)];
        if at.v == 0.0 {
            bends[0].iter_mut().for_each(|x| *x = 0.0);
        }
        let first = unit(&fv);
        let second = unit(&plus(&yu, -dot(&yu, &first), &first));
        for bend in &mut bends {
            for e in [&first, &second] {
                *bend = plus(bend, -dot(bend, e), e);
            }
        }
        let project = |x: &[f64]| [dot(x, &self.basis[0]), dot(x, &self.basis[1])];
        let projected = [project(&yu), project(&fv)];
        Local { tangents: [yu, fv], projected, bends }
    }

    /// Where the surface is over a place; `u` leaves the window only beyond the sides of an open one.
    pub(super) fn find(&self, place: [f64; 2], heading: [f64; 2]) -> Polar {
        let distance = norm(&place);
        let direction = if distance > 0.0 { place } else { heading };
        let (mut member, mut u) = self.nearest_spoke(direction);
        let mut v = distance / norm(&self.members[member].spoke(u, 0.0).0);
        for _ in 0..40 {
            let (y, yu, yv) = self.members[member].spoke_in(&self.basis, u, v);
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
        let (y, _, _) = self.members[member].spoke_in(&self.basis, u, v);
        let found = dot(&y, &direction) > (1.0 - 1e-9) * norm(&y) * norm(&direction);
        Polar { member, u, v, found }
    }

    /// A place beyond the sides of a piece, as its neighbour counts it, if there is one.
    fn rehomed(&self, member: usize, u: f64) -> (usize, f64) {
        let last = self.members.len() - 1;
        let next = |a: usize, b: usize, u: f64| (b, u * self.pace(a, b));
        if u < 0.0 && (member > 0 || self.closed) {
            let to = if member > 0 { member - 1 } else { last };
            let (to, u) = next(member, to, u);
            return (to, 1.0 + u);
        }
        if u > 1.0 && (member < last || self.closed) {
            let to = if member < last { member + 1 } else { 0 };
            let (to, u) = next(member, to, u - 1.0);
            return (to, u);
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
        let mut best = (0, 0.5, f64::NEG_INFINITY);
        for (member, one) in self.members.iter().enumerate() {
            for (k, spoke) in one.table.iter().enumerate() {
                let along = dot(spoke, &direction) / norm(spoke);
                if along > best.2 {
                    best = (member, k as f64 / PLACES as f64, along);
                }
            }
        }
        (best.0, best.1)
    }

    /// Is a place on the surface, and not beyond the sides of an open one by more than `slack` in `u`?
    pub(super) fn holds(&self, at: Polar, slack: f64) -> bool {
        self.closed || at.found && (-slack..=1.0 + slack).contains(&at.u)
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
        let (y, _, _) = self.members[member].spoke_in(&self.basis, u, v);
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
        plus(&scaled(&local.tangents[0], w), speed, &local.tangents[1])
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
        let mut bend = scaled(&local.bends[0], w * w);
        bend = plus(&bend, 2.0 * w * speed, &local.bends[1]);
        bend = plus(&bend, speed * speed, &local.bends[2]);
        let [t, s] = &local.tangents;
        let over = [solved(local.projected, [1.0, 0.0]), solved(local.projected, [0.0, 1.0])];
        let [x, y] = over.map(|[a, b]| plus(&scaled(t, a), b, s));
        let metric = Metric {
            first: [dot(&x, &x), dot(&x, &y), dot(&y, &y)],
            bends: [[0.0; 2]; 3],
            twist: 0.0,
        };
        let area = dot(t, t) * dot(s, s) - dot(t, s) * dot(t, s);
        let [uu, uv, vv] = &local.bends;
        let curvature = (dot(uu, vv) - dot(uv, uv)) / area;
        (metric, self.projected(&bend), curvature)
    }
}

impl Member {
    fn new(atlas: &Atlas, net: usize, axis: usize, side: usize, apex: &[f64]) -> Self {
        let from = &atlas.nets[net];
        let (along, away) = (from.orders[1 - axis], from.orders[axis]);
        let pole = |plane: usize, a: usize, b: usize| {
            let b = if side == 0 { b } else { away - 1 - b };
            if axis == 0 { from.pole(plane, b, a) } else { from.pole(plane, a, b) }
        };
        let mut offsets = Vec::with_capacity(from.ambient * along * away);
        for (plane, origin) in apex.iter().enumerate() {
            for a in 0..along {
                for b in 1..away {
                    let offset = pole(plane, a, b) - origin * pole(from.ambient, a, b);
                    offsets.push(offset * (away - 1) as f64 / b as f64);
                }
            }
        }
        let mut weights = Vec::with_capacity(along * away);
        for a in 0..along {
            weights.extend((0..away).map(|b| pole(from.ambient, a, b)));
        }
        let ambient = from.ambient;
        let offsets = Net { orders: [along, away - 1], ambient, rational: false, poles: offsets };
        let weights = Net { orders: [along, away], ambient: 1, rational: false, poles: weights };
        Self { net, offsets, weights, table: Vec::new(), turn: 0.0 }
    }

    /// `Y` and its derivatives along `u`, `v`, `uu`, `uv`, `vv`.
    fn jet(&self, u: f64, v: f64) -> [Vec<f64>; 6] {
        let offsets = self.offsets.jet([u, v]);
        let weight = self.weights.jet([u, v]).map(|row| row[0]);
        let mut jet: [Vec<f64>; 6] = Default::default();
        for coordinate in 0..self.offsets.ambient {
            let raw = offsets.each_ref().map(|row| row[coordinate]);
            for (row, x) in jet.iter_mut().zip(quotient(raw, &weight, 1.0 / weight[0])) {
                row.push(x);
            }
        }
        jet
    }

    fn offset(&self, u: f64) -> Vec<f64> {
        let [y, ..] = self.jet(u, 0.0);
        y
    }

    /// `Y`, `Y_u`, `Y_v`.
    fn spoke(&self, u: f64, v: f64) -> (Vec<f64>, Vec<f64>, Vec<f64>) {
        let [y, yu, yv, ..] = self.jet(u, v);
        (y, yu, yv)
    }

    /// The same, projected.
    fn spoke_in(&self, basis: &[Vec<f64>; 2], u: f64, v: f64) -> ([f64; 2], [f64; 2], [f64; 2]) {
        let (y, yu, yv) = self.spoke(u, v);
        let project = |x: &[f64]| [dot(x, &basis[0]), dot(x, &basis[1])];
        (project(&y), project(&yu), project(&yv))
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

fn turned(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// The solution of a system with these columns.
fn solved([a, b]: [[f64; 2]; 2], x: [f64; 2]) -> [f64; 2] {
    [turned(x, b) / turned(a, b), turned(a, x) / turned(a, b)]
}
