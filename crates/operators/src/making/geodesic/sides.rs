//! Over the sides of pieces, and from one chart to another.

use super::Ending;
use super::atlas::{Beyond, Edge};
use super::attempt::{Look, Tried};
use super::cap::Cap;
use super::cross::{crossed, exit};
use super::step::{State, along};
use super::trace::{Chart, SHORTEST, Tracer};
use crate::measuring::vector::{norm, plus};

/// What became of a step.
pub(super) enum Moved {
    On,
    /// It ended on a side, and the course is on the other.
    Over,
    /// It did not arrive on the side it was to end on.
    Not,
    Ended(Ending),
}

/// Sides crossed without a step between: more happen only where pieces meet in a point.
const IDLE: usize = 8;

/// Parameters beyond a side by more than this are outside, whatever the slack.
const MARGIN: f64 = 1e-6;

/// The same for the parameter along a collapsed side, which a small distance turns by much.
const MOST_TURN: f64 = 1e-2;

impl Tracer<'_> {
    /// Takes a step, or what of it stays on the piece.
    pub(super) fn moved(&mut self, look: &Look, tried: &Tried) -> Moved {
        match self.course.chart {
            Chart::Piece(_) => {
                if let Some((axis, side, share)) = exit(&tried.path, self.margins(look)) {
                    return self.onto_side(look, axis, side, share * tried.by);
                }
            }
            Chart::Cap(axis, side) => {
                let cap = self.atlas.cap(axis, side);
                if let Some(share) = cap.and_then(|cap| self.beyond_cap(cap, tried)) {
                    let ending = self.leave_cap(look, axis, side, share * tried.by);
                    return ending.map_or(Moved::Over, Moved::Ended);
                }
            }
        }
        self.accept(tried);
        Moved::On
    }

    /// To a side of the piece, and over it.
    fn onto_side(&mut self, look: &Look, axis: usize, side: usize, by: f64) -> Moved {
        if !self.is_nothing(by) {
            let Some(tried) = self.landed(look, axis, side, by) else {
                return Moved::Not;
            };
            self.accept(&tried);
        }
        self.course.state.place[axis] = side as f64;
        self.idle += 1;
        if self.idle > IDLE {
            return Moved::Ended(Ending::Singular);
        }
        self.cross(axis, side).map_or(Moved::Over, Moved::Ended)
    }

    /// How far beyond each side, in parameters, still counts as on it.
    fn margins(&self, look: &Look) -> [f64; 2] {
        let [e, _, g] = look.metric.first;
        [e, g].map(|square| (self.request.slack / square.sqrt()).min(MARGIN))
    }

    /// Over a side of a piece; the ending if there is nothing beyond.
    fn cross(&mut self, axis: usize, side: usize) -> Option<Ending> {
        let Chart::Piece(net) = self.course.chart else {
            return None;
        };
        match self.atlas.beyond(net, axis, side) {
            Beyond::Border => Some(Ending::Border),
            Beyond::Point => self.over_point(net, axis, side),
            Beyond::Piece { net: next, turned } => {
                let state = &self.course.state;
                let Some(other) = crossed(self.atlas, [net, next], axis, side, turned, state)
                else {
                    return Some(Ending::Singular);
                };
                if other.gap > self.request.slack.max(1e-12) {
                    return Some(Ending::Torn);
                }
                self.course.crease = self.course.crease.max(other.crease);
                self.course.chart = Chart::Piece(next);
                self.course.state = other.state;
                None
            }
        }
    }

    /// At a collapsed side: across it, if the surface goes on there.
    fn over_point(&mut self, net: usize, axis: usize, side: usize) -> Option<Ending> {
        let Edge::Cap(cap) = &self.atlas.caps[axis][side] else {
            return Some(Ending::Collapsed);
        };
        let state = &self.course.state;
        let (_, velocity) = cap.over(net, state.place, state.velocity)?;
        if !cap.holds(cap.find([0.0; 2], velocity), self.request.slack) {
            return Some(Ending::Collapsed);
        }
        self.course.state = State { place: [0.0; 2], velocity };
        self.course.chart = Chart::Cap(axis, side);
        None
    }

    /// Changes to the chart that suits the place; true if it did.
    pub(super) fn recharted(&mut self) -> bool {
        let state = self.course.state;
        match self.course.chart {
            Chart::Piece(net) => {
                for (axis, side) in self.atlas.points_of(net) {
                    let Edge::Cap(cap) = &self.atlas.caps[axis][side] else {
                        continue;
                    };
                    let way = if side == 0 { state.place[axis] } else { 1.0 - state.place[axis] };
                    if way < 0.8 * cap.reach
                        && let Some((place, velocity)) = cap.over(net, state.place, state.velocity)
                    {
                        self.course.chart = Chart::Cap(axis, side);
                        self.course.state = State { place, velocity };
                        return true;
                    }
                }
                false
            }
            Chart::Cap(axis, side) => {
                let Some(cap) = self.atlas.cap(axis, side) else {
                    return false;
                };
                if cap.find(state.place, state.velocity).v <= cap.reach {
                    return false;
                }
                let (net, place, velocity) = cap.under(state.place, state.velocity);
                self.course.chart = Chart::Piece(net);
                self.course.state = State { place, velocity };
                true
            }
        }
    }

    /// Has a course that cannot be told from one through an apex come to it?
    pub(super) fn at_apex(&mut self) -> Option<Ending> {
        let Chart::Piece(net) = self.course.chart else {
            return None;
        };
        for (axis, side) in self.atlas.points_of(net) {
            let Edge::Apex(apex) = &self.atlas.caps[axis][side] else {
                continue;
            };
            let point = &self.atlas.nets[net].jet(self.course.state.place)[0];
            let distance = norm(&plus(point, -1.0, apex));
            if distance <= 8.0 * self.course.growth.error() {
                self.course.growth.add(distance, 0.0);
                return Some(Ending::Collapsed);
            }
        }
        None
    }

    /// The share of a step at which it leaves an open cap over one of its sides.
    fn beyond_cap(&self, cap: &Cap, tried: &Tried) -> Option<f64> {
        if cap.closed {
            return None;
        }
        let held = |share: f64| {
            let [u, v] = tried.path.map(|poles| along(&poles, share, tried.by));
            let place = [u[0], v[0]];
            let slack = self.request.slack / norm(&place).max(self.request.slack / MOST_TURN);
            cap.holds(cap.find(place, [u[1], v[1]]), slack)
        };
        if held(1.0) {
            return None;
        }
        let (mut inside, mut outside) = (0.0, 1.0);
        for _ in 0..50 {
            let middle = f64::midpoint(inside, outside);
            if held(middle) { inside = middle } else { outside = middle }
        }
        Some(inside)
    }

    /// Goes to the side of an open cap, and over it.
    fn leave_cap(&mut self, look: &Look, axis: usize, side: usize, by: f64) -> Option<Ending> {
        if by > SHORTEST {
            let Some(tried) = self.tried(look, by) else {
                return Some(Ending::Singular);
            };
            self.accept(&tried);
        }
        let cap = self.atlas.cap(axis, side)?;
        let state = self.course.state;
        if norm(&state.place) <= (8.0 * self.course.growth.error()).max(self.request.slack) {
            return Some(Ending::Collapsed);
        }
        let (net, mut place, velocity) = cap.under(state.place, state.velocity);
        let along = 1 - axis;
        let over = usize::from(place[along] > 0.5);
        place[along] = over as f64;
        self.course.chart = Chart::Piece(net);
        self.course.state = State { place, velocity };
        self.cross(along, over)
    }
}
