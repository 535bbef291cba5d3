//! Follows one geodesic over the pieces of a surface, step by step.

use pforms_kernel::{Error, Result};

use super::atlas::{Atlas, Beyond, Edge};
use super::cross::{crossed, exit};
use super::growth::{Curvatures, Growth};
use super::metric::Metric;
use super::step::{Path, State, Step, along, step};
use super::{Ending, cap::Cap};
use crate::measuring::vector::{norm, plus};

/// Where the two numbers of a state belong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Chart {
    /// The parameters of a piece, 0 to 1.
    Piece(usize),
    /// The tangent plane at a collapsed side: its axis and side.
    Cap(usize, usize),
}

/// What is asked of a course; lengths in units.
#[derive(Clone, Copy, Debug)]
pub(super) struct Request {
    pub length: f64,
    /// Error of a step for each unit of its length.
    pub tolerance: f64,
    /// How far the polynomial between the ends of a step may be off, and how far beyond a side counts as on it.
    pub slack: f64,
    /// Are the polynomials wanted?
    pub dense: bool,
    /// Stop where another piece begins?
    pub pause: bool,
}

impl Request {
    /// The step to try first.
    pub(super) fn first(&self) -> f64 {
        FIRST.min(self.length)
    }

    /// How much more an error of a step is than what is allowed: never 0.
    pub(super) fn excess(&self, error: f64, by: f64) -> f64 {
        (error / (self.tolerance * by).max(FLOOR)).max(1e-12)
    }
}

/// A step that was taken.
#[derive(Clone, Copy, Debug)]
pub(super) struct Leg {
    pub chart: Chart,
    pub from: f64,
    pub by: f64,
    pub path: Path,
}

/// A geodesic as far as it goes.
pub(super) struct Course {
    pub legs: Vec<Leg>,
    pub chart: Chart,
    pub state: State<f64>,
    pub length: f64,
    pub ending: Ending,
    pub growth: Growth,
    /// How far a polynomial is off between the ends of its step, at most.
    pub between: f64,
    /// The largest angle between the two sides of a knot or seam that was crossed.
    pub crease: f64,
    pub steps: usize,
}

/// Steps of a course at most.
const MOST: usize = 1 << 17;

/// Sides crossed without a step between: more happen only where pieces meet in a point.
const IDLE: usize = 8;

/// What a course feels at a state.
#[derive(Clone, Copy)]
struct Look {
    metric: Metric<f64>,
    acceleration: [f64; 2],
    curvature: f64,
}

struct Tracer<'a> {
    atlas: &'a Atlas,
    request: &'a Request,
    course: Course,
    /// The step to try next.
    by: f64,
    /// Sides crossed since the last step.
    idle: usize,
}

/// What became of a step.
enum Moved {
    On,
    /// It ended on a side, and the course is on the other.
    Over,
    /// It did not arrive on the side it was to end on.
    Not,
    Ended(Ending),
}

/// Follows the geodesic from a state, at unit speed.
///
/// Errors: `Accuracy` when it takes too many steps; `Degenerate` when the surface has no tangent plane at its
/// beginning.
pub(super) fn trace(
    atlas: &Atlas,
    chart: Chart,
    state: State<f64>,
    request: &Request,
) -> Result<Course> {
    resumed(atlas, Course::new(chart, state), request)
}

impl Course {
    pub(super) fn new(chart: Chart, state: State<f64>) -> Self {
        Self {
            legs: Vec::new(),
            chart,
            state,
            length: 0.0,
            ending: Ending::Length,
            growth: Growth::new(),
            between: 0.0,
            crease: 0.0,
            steps: 0,
        }
    }
}

/// Follows a geodesic on from where it is.
///
/// Errors: as [`trace`].
pub(super) fn resumed(atlas: &Atlas, course: Course, request: &Request) -> Result<Course> {
    let mut tracer = Tracer { atlas, request, course, by: request.first(), idle: 0 };
    tracer.recharted();
    if let Some(ending) = tracer.run()? {
        tracer.course.ending = ending;
    }
    Ok(tracer.course)
}

/// The step tried first.
const FIRST: f64 = 0.05;

/// A step this short no longer moves.
const SHORTEST: f64 = 1e-15;

/// Errors of a step below this are rounding.
const FLOOR: f64 = 4.0 * f64::EPSILON;

/// Parameters beyond a side by more than this are outside, whatever the slack.
const MARGIN: f64 = 1e-6;

/// The same for the parameter along a collapsed side, which a small distance turns by much.
const MOST_TURN: f64 = 1e-2;

/// Share of the way to a collapsed side that a step may go.
const APPROACH: f64 = 0.7;

impl Tracer<'_> {
    fn run(&mut self) -> Result<Option<Ending>> {
        let mut look = self.prepared()?;
        while self.course.length < self.request.length {
            self.count()?;
            let rest = self.request.length - self.course.length;
            let by = self.by.min(rest).min(self.approach());
            if self.is_nothing(by) {
                return Ok(Some(Ending::Singular));
            }
            let Some(tried) = self.tried(&look, by) else {
                self.by = by / 4.0;
                continue;
            };
            let next = by * 0.9 * tried.excess.powf(-1.0 / 7.0);
            if tried.excess > 1.0 {
                self.by = next.clamp(0.1 * by, 0.9 * by);
                continue;
            }
            self.by = next.clamp(0.5 * by, 5.0 * by);
            match self.moved(&look, &tried) {
                Moved::On if by == rest => self.course.length = self.request.length,
                Moved::On => {}
                Moved::Over => {
                    look = self.prepared()?;
                    if self.request.pause && matches!(self.course.chart, Chart::Piece(_)) {
                        return Ok(None);
                    }
                    continue;
                }
                Moved::Not => {
                    self.by = by / 4.0;
                    continue;
                }
                Moved::Ended(ending) => return Ok(Some(ending)),
            }
            if let Some(ending) = self.at_apex() {
                return Ok(Some(ending));
            }
            if self.recharted() {
                look = self.prepared()?;
                if self.request.pause && matches!(self.course.chart, Chart::Piece(_)) {
                    return Ok(None);
                }
            } else {
                look = tried.look;
            }
        }
        Ok(None)
    }

    fn count(&mut self) -> Result<()> {
        self.course.steps += 1;
        if self.course.steps <= MOST {
            return Ok(());
        }
        let reached = self.atlas.length(self.course.length);
        Err(Error::accuracy(
            "length",
            self.atlas.length(self.request.length),
            format!("a length that {MOST} steps reach: here {reached:e}"),
        ))
    }

    fn is_nothing(&self, by: f64) -> bool {
        by < SHORTEST * (1.0 + self.course.length)
    }

    /// Takes a step, or what of it stays on the piece.
    fn moved(&mut self, look: &Look, tried: &Tried) -> Moved {
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

    /// The look at a state, made one of unit speed.
    fn prepared(&mut self) -> Result<Look> {
        let state = &mut self.course.state;
        let look = look(self.atlas, self.course.chart, state.place, state.velocity);
        let speed = look.metric.product(state.velocity, state.velocity).sqrt();
        let usable = speed > 0.0
            && speed.is_finite()
            && finite(look.acceleration)
            && look.metric.area() > 0.0;
        if !usable {
            return Err(Error::degenerate(
                "start",
                "a point where the surface has no tangent plane, or a direction that is none there",
                "a start where the surface is regular",
            ));
        }
        Ok(unit_speed(state, look, speed))
    }

    /// Near a collapsed side steps are shorter than the way to it.
    fn approach(&self) -> f64 {
        let Chart::Piece(net) = self.course.chart else {
            return f64::INFINITY;
        };
        let mut most = f64::INFINITY;
        for (axis, side) in self.atlas.points_of(net) {
            let (place, speed) = (self.course.state.place[axis], self.course.state.velocity[axis]);
            let (way, speed) = if side == 0 { (place, -speed) } else { (1.0 - place, speed) };
            if speed > 0.0 && way > 0.0 && matches!(self.atlas.caps[axis][side], Edge::Cap(_)) {
                most = most.min(APPROACH * way / speed);
            }
        }
        most
    }

    /// A step and what it is worth; none where the surface ends or goes to infinity.
    fn tried(&self, look: &Look, by: f64) -> Option<Tried> {
        let (atlas, chart, state) = (self.atlas, self.course.chart, &self.course.state);
        let field = |place: [f64; 2], velocity: [f64; 2]| field(atlas, chart, place, velocity);
        let mut step = step(state, look.acceleration, by, &field);
        let end = self::look(atlas, chart, step.end.place, step.end.velocity);
        let speed = end.metric.product(step.end.velocity, step.end.velocity).sqrt();
        if !(speed > 0.5 && speed < 2.0 && finite(end.acceleration) && finite(step.end.place)) {
            return None;
        }
        let [place, turn] = errors(&step, &end.metric);
        let mut excess = self.request.excess(place.max(turn), by);
        let path = step.path(state, end.acceleration, by, &field);
        let mut curvatures =
            [look.curvature, 0.0, f64::midpoint(look.curvature, end.curvature), 0.0, end.curvature];
        let mut between = 0.0_f64;
        if excess <= 1.0 && self.request.dense {
            for (k, curvature) in curvatures.iter_mut().enumerate().take(4).skip(1) {
                let [u, v] = path.map(|poles| along(&poles, k as f64 / 4.0, by));
                let here = self::look(atlas, chart, [u[0], v[0]], [u[1], v[1]]);
                let rest = [u[2] - here.acceleration[0], v[2] - here.acceleration[1]];
                between = between.max(here.metric.product(rest, rest).sqrt() * by * by / 8.0);
                *curvature = here.curvature;
            }
            // Order 8 as well: the second derivative of a polynomial of degree 7, times the step squared.
            excess = excess.max(between / (0.25 * self.request.slack).max(FLOOR));
        } else {
            curvatures[1] = f64::midpoint(curvatures[0], curvatures[2]);
            curvatures[3] = f64::midpoint(curvatures[2], curvatures[4]);
        }
        if !excess.is_finite() {
            return None;
        }
        let rounding = self.rounding(by);
        let errors = [place + rounding[0], turn + rounding[1]];
        let mut state = step.end;
        let look = unit_speed(&mut state, end, speed);
        Some(Tried { by, path, state, look, curvatures, errors, between, excess })
    }

    /// What rounding adds to the place and the direction of a step: derivatives are differences of poles, which
    /// matters where the parameters run fast.
    fn rounding(&self, by: f64) -> [f64; 2] {
        let pace = match self.course.chart {
            Chart::Piece(net) => {
                let [m, n] = self.atlas.nets[net].orders;
                let [u, v] = self.course.state.velocity;
                u.abs() * (m - 1) as f64 + v.abs() * (n - 1) as f64
            }
            Chart::Cap(..) => 4.0,
        };
        let share = by * pace;
        [f64::EPSILON * (1.0 + share), f64::EPSILON * (1.0 + pace * share)]
    }

    fn accept(&mut self, tried: &Tried) {
        let course = &mut self.course;
        let [place, turn] = tried.errors;
        course.growth.step(course.length, tried.by, &tried.curvatures, place, turn);
        if self.request.dense {
            let (from, by, path) = (course.length, tried.by, tried.path);
            course.legs.push(Leg { chart: course.chart, from, by, path });
            course.between = course.between.max(tried.between);
        }
        course.length += tried.by;
        course.state = tried.state;
        self.idle = 0;
    }

    /// How far beyond each side, in parameters, still counts as on it.
    fn margins(&self, look: &Look) -> [f64; 2] {
        let [e, _, g] = look.metric.first;
        [e, g].map(|square| (self.request.slack / square.sqrt()).min(MARGIN))
    }

    /// A step that ends on a side of the piece.
    fn landed(&self, look: &Look, axis: usize, side: usize, by: f64) -> Option<Tried> {
        let mut by = by;
        for _ in 0..4 {
            let tried = self.tried(look, by)?;
            let miss = tried.state.place[axis] - side as f64;
            let next = by - miss / tried.state.velocity[axis];
            if !(next > 0.0 && (next - by).abs() > 1e-16) {
                break;
            }
            by = next;
        }
        let mut tried = self.tried(look, by)?;
        tried.path[axis][7] = side as f64;
        Some(tried)
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
    fn recharted(&mut self) -> bool {
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
    fn at_apex(&mut self) -> Option<Ending> {
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
        if cap.is_closed() {
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

/// A step with all that is known of it.
struct Tried {
    by: f64,
    path: Path,
    state: State<f64>,
    look: Look,
    curvatures: Curvatures,
    /// Of the place and of the direction.
    errors: [f64; 2],
    between: f64,
    /// How much more its error is than what is allowed.
    excess: f64,
}

fn look(atlas: &Atlas, chart: Chart, place: [f64; 2], velocity: [f64; 2]) -> Look {
    match chart {
        Chart::Piece(net) => {
            let metric = atlas.nets[net].metric(place);
            // A surface in the plane is flat.
            let curvature = if atlas.ambient == 2 { 0.0 } else { metric.curvature() };
            Look { metric, acceleration: metric.acceleration(velocity), curvature }
        }
        Chart::Cap(axis, side) => {
            let seen = atlas.cap(axis, side).map(|cap| cap.look(place, velocity));
            let (metric, acceleration, curvature) =
                seen.unwrap_or((Metric::nowhere(), [f64::NAN; 2], 0.0));
            Look { metric, acceleration, curvature }
        }
    }
}

fn field(atlas: &Atlas, chart: Chart, place: [f64; 2], velocity: [f64; 2]) -> [f64; 2] {
    match chart {
        Chart::Piece(net) => atlas.nets[net].metric(place).acceleration(velocity),
        Chart::Cap(..) => look(atlas, chart, place, velocity).acceleration,
    }
}

/// Errors of a step in place and direction, as lengths on the surface: from the two lower orders, as Hairer,
/// Nørsett and Wanner combine them.
fn errors(step: &Step<f64>, metric: &Metric<f64>) -> [f64; 2] {
    let velocity = step.end.velocity;
    let sizes = step.errors.map(|[a, b, c, d]| {
        let place = [a, b];
        let shift = metric.connection(velocity, place);
        let turn = [c + shift[0], d + shift[1]];
        [metric.product(place, place).abs(), metric.product(turn, turn).abs()]
    });
    [0, 1].map(|k| {
        let [fifth, third] = [sizes[0][k], sizes[1][k]];
        let sum = fifth + 0.01 * third;
        if sum > 0.0 { fifth / sum.sqrt() } else { 0.0 }
    })
}

/// Makes the speed 1: the course is the same, only faster or slower by a rounding.
fn unit_speed(state: &mut State<f64>, look: Look, speed: f64) -> Look {
    state.velocity = state.velocity.map(|x| x / speed);
    Look { acceleration: look.acceleration.map(|x| x / (speed * speed)), ..look }
}

fn finite(pair: [f64; 2]) -> bool {
    pair[0].is_finite() && pair[1].is_finite()
}
