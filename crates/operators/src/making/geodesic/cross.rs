//! Over the side of a piece into the next.

use super::atlas::Atlas;
use super::step::{Path, State};
use crate::measuring::roots::sign_changes;
use crate::measuring::vector::{dot, norm, plus, unit};

/// Where a step leaves its piece: axis, side and share of the step; none while it stays within `slack`.
///
/// A course along a side is on it as long as it keeps within the slack; one that goes on beyond has left where
/// it last was on the side.
pub(super) fn exit(path: &Path, slack: [f64; 2]) -> Option<(usize, usize, f64)> {
    let mut first: Option<(usize, usize, f64, f64)> = None;
    for (axis, (poles, slack)) in path.iter().zip(slack).enumerate() {
        for side in 0..2 {
            let inside = poles.map(|x| if side == 0 { x } else { 1.0 - x });
            // Beyond at the end, and about to be so by more: gone as well.
            let leaving = inside[7] < 0.0 && 7.0 * (inside[6] - inside[7]) > slack;
            if !leaving && inside.iter().all(|x| *x >= -slack) {
                continue;
            }
            let lowered = inside.map(|x| x + slack);
            let gone = match sign_changes(&lowered).first() {
                _ if lowered[0] < 0.0 => 0.0,
                Some(t) => *t,
                None if leaving || lowered[7] < 0.0 => 1.0,
                None => continue,
            };
            let on = sign_changes(&inside).into_iter().rfind(|t| *t <= gone);
            let on = on.unwrap_or(if inside[0] > 0.0 { gone } else { 0.0 });
            if first.is_none_or(|(.., least)| gone < least) {
                first = Some((axis, side, on, gone));
            }
        }
    }
    first.map(|(axis, side, on, _)| (axis, side, on))
}

/// A state on the other side of a knot or a seam.
pub(super) struct Crossed {
    pub state: State<f64>,
    /// Distance between the two sides.
    pub gap: f64,
    /// The angle between them.
    pub crease: f64,
}

/// Goes straight over: the angle with the common line is kept, so that the two sides laid flat have one straight
/// line on them. None where that line has no direction.
pub(super) fn crossed(
    atlas: &Atlas,
    [from, to]: [usize; 2],
    axis: usize,
    side: usize,
    turned: bool,
    state: &State<f64>,
) -> Option<Crossed> {
    let other = 1 - axis;
    let mut place = state.place;
    place[axis] = 1.0 - side as f64;
    if turned {
        place[other] = 1.0 - place[other];
    }
    let sign = if turned { -1.0 } else { 1.0 };
    let here = Side::new(atlas, from, state.place, axis)?;
    let there = Side::new(atlas, to, place, axis)?;
    let velocity: Vec<f64> = plus(
        &here.across.iter().map(|x| x * state.velocity[axis]).collect::<Vec<_>>(),
        state.velocity[other],
        &here.line,
    );
    let along = dot(&velocity, &unit(&here.line));
    let outward = if side == 1 { 1.0 } else { -1.0 };
    let normal = unit(&here.normal);
    let through = (dot(&velocity, &normal) * outward).max(0.0);
    let mut next = [0.0; 2];
    next[axis] = outward * through / norm(&there.normal);
    let direction = unit(&there.line);
    next[other] = (sign * along - next[axis] * dot(&there.across, &direction)) / norm(&there.line);
    let cosine = dot(&normal, &unit(&there.normal));
    let sine = norm(&plus(&unit(&there.normal), -cosine, &normal));
    Some(Crossed {
        state: State { place, velocity: next },
        gap: norm(&plus(&here.point, -1.0, &there.point)),
        crease: libm::atan2(sine, cosine),
    })
}

/// A side of a piece at a point: its line, the derivative across it, and the part of that at right angles.
struct Side {
    point: Vec<f64>,
    line: Vec<f64>,
    across: Vec<f64>,
    normal: Vec<f64>,
}

impl Side {
    fn new(atlas: &Atlas, net: usize, place: [f64; 2], axis: usize) -> Option<Self> {
        let [point, u, v, ..] = atlas.nets[net].jet(place);
        let (across, line) = if axis == 0 { (u, v) } else { (v, u) };
        let direction = unit(&line);
        let normal = plus(&across, -dot(&across, &direction), &direction);
        let regular = norm(&line) > 0.0 && norm(&normal) > 0.0 && norm(&normal).is_finite();
        regular.then_some(Self { point, line, across, normal })
    }
}
