//! One step of a course, and what it is worth.

use super::atlas::Atlas;
use super::growth::{Curvatures, unclear};
use super::metric::Metric;
use super::step::{Path, State, Step, along, step};
use super::trace::{Chart, FLOOR, Tracer};

/// What a course feels at a state.
#[derive(Clone, Copy)]
pub(super) struct Look {
    pub metric: Metric<f64>,
    pub acceleration: [f64; 2],
    pub curvature: f64,
}

/// A step with all that is known of it.
pub(super) struct Tried {
    pub by: f64,
    pub path: Path,
    pub state: State<f64>,
    pub look: Look,
    pub curvatures: Curvatures,
    /// Of the place and of the direction.
    pub errors: [f64; 2],
    pub between: f64,
    /// How much more its error is than what is allowed.
    pub excess: f64,
}

impl Tracer<'_> {
    /// A step and what it is worth; none where the surface ends or goes to infinity.
    pub(super) fn tried(&self, look: &Look, by: f64) -> Option<Tried> {
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
        let middle = f64::midpoint(look.curvature, end.curvature);
        let mut curvatures = [
            look.curvature,
            f64::midpoint(look.curvature, middle),
            middle,
            f64::midpoint(middle, end.curvature),
            end.curvature,
        ];
        let mut between = 0.0_f64;
        if self.request.sure && (excess <= 1.0 || self.refused.is_some()) {
            for (k, curvature) in curvatures.iter_mut().enumerate().take(4).skip(1) {
                let [u, v] = path.map(|poles| along(&poles, k as f64 / 4.0, by));
                let here = self::look(atlas, chart, [u[0], v[0]], [u[1], v[1]]);
                let rest = [u[2] - here.acceleration[0], v[2] - here.acceleration[1]];
                between = between.max(here.metric.product(rest, rest).sqrt() * by * by / 8.0);
                *curvature = here.curvature;
            }
            excess = excess.max(unclear(by, &curvatures));
            if self.request.dense {
                // Order 8 as well: the second derivative of a polynomial of degree 7, times the step squared.
                excess = excess.max(between / (0.25 * self.request.slack).max(FLOOR));
            }
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

    /// A step that ends on a side of the piece.
    pub(super) fn landed(&self, look: &Look, axis: usize, side: usize, by: f64) -> Option<Tried> {
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
}

pub(super) fn look(atlas: &Atlas, chart: Chart, place: [f64; 2], velocity: [f64; 2]) -> Look {
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
pub(super) fn unit_speed(state: &mut State<f64>, look: Look, speed: f64) -> Look {
    state.velocity = state.velocity.map(|x| x / speed);
    Look { acceleration: look.acceleration.map(|x| x / (speed * speed)), ..look }
}

pub(super) fn finite(pair: [f64; 2]) -> bool {
    pair[0].is_finite() && pair[1].is_finite()
}
