//! Steps of many geodesics over one piece, side by side.

#![allow(
    clippy::inline_always,
    clippy::needless_range_loop,
    reason = "only what is inlined is compiled for the wider sets; lanes are counted, not iterated"
)]

use pforms_kernel::vectors::{Job, Lanes, MOST, Simd};

use super::atlas::{Atlas, Edge};
use super::bulk::Task;
use super::growth::unclear;
use super::metric::Net;
use super::number::Number;
use super::step::{State, step};

/// All tasks of one piece.
pub(super) struct Together<'a, 'b> {
    pub atlas: &'a Atlas,
    pub net: usize,
    pub tasks: &'a mut [&'b mut Task],
}

/// What the lanes hold, number after number.
#[derive(Clone, Copy, Default)]
struct Hold {
    numbers: [[f64; MOST]; 8],
}

impl Job for Together<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self, simd: S) {
        let lanes = Lanes::<S>::COUNT;
        let net = &self.atlas.nets[self.net];
        let bounds = Bounds::new(self.atlas, self.net);
        let mut waiting = 0..self.tasks.len();
        let mut held: [Option<usize>; MOST] = [None; MOST];
        // Place, velocity, acceleration, curvature, step.
        let mut hold = Hold::default();
        for lane in 0..lanes {
            held[lane] = waiting.next();
        }
        let Some(first) = held[0] else {
            return;
        };
        for lane in 0..lanes {
            prepared(net, self.tasks[held[lane].unwrap_or(first)], lane, &mut hold);
        }
        while held.iter().any(Option::is_some) {
            let moved = stepped(simd, net, &hold);
            for lane in 0..lanes {
                let Some(index) = held[lane] else {
                    continue;
                };
                let task = &mut *self.tasks[index];
                if !taken(task, lane, &mut hold, &moved, &bounds) {
                    held[lane] = waiting.next();
                    if let Some(next) = held[lane] {
                        prepared(net, self.tasks[next], lane, &mut hold);
                    }
                }
            }
        }
    }
}

/// Puts a task into a lane.
fn prepared(net: &Net, task: &Task, lane: usize, hold: &mut Hold) {
    let State { place, velocity } = task.course.state;
    let metric = net.metric(place);
    let [a, b] = metric.acceleration(velocity);
    let curvature = if net.ambient == 2 { 0.0 } else { metric.curvature() };
    let numbers =
        [place[0], place[1], velocity[0], velocity[1], a, b, curvature, task.by.min(task.rest())];
    for (row, x) in hold.numbers.iter_mut().zip(numbers) {
        row[lane] = x;
    }
}

/// Ends of steps: place, velocity, acceleration, curvature, speed; squares of the errors of place and turn, of
/// orders 5 and 3; curvatures at the quarters.
struct Ends {
    numbers: [[f64; MOST]; 15],
}

#[inline(always)]
fn stepped<S: Simd>(simd: S, net: &Net, hold: &Hold) -> Ends {
    let at = |k: usize| Lanes::load(simd, &hold.numbers[k]);
    let from = State { place: [at(0), at(1)], velocity: [at(2), at(3)] };
    let field =
        |place: [Lanes<S>; 2], velocity: [Lanes<S>; 2]| net.metric(place).acceleration(velocity);
    let step = step(&from, [at(4), at(5)], at(7), &field);
    let metric = net.metric(step.end.place);
    let velocity = step.end.velocity;
    let [a, b] = metric.acceleration(velocity);
    let squares = step.errors.map(|[a, b, c, d]| {
        let place = [a, b];
        let shift = metric.connection(velocity, place);
        let turn = [c + shift[0], d + shift[1]];
        [metric.product(place, place).abs(), metric.product(turn, turn).abs()]
    });
    let place = step.end.place;
    let speed = metric.product(velocity, velocity).sqrt();
    let [fifth, third] = squares;
    // A rim may lie within the step: its curvature counts. Places of the cubic will do.
    let quarters = [0.25, 0.5, 0.75].map(|share| {
        let (s, t) = (1.0 - share, share);
        let weights = [s * s * (1.0 + 2.0 * t), t * t * (1.0 + 2.0 * s), s * s * t, -t * t * s];
        let [a, b, c, d] = weights.map(|weight| at(7).like(weight));
        let along = |k: usize| {
            a * from.place[k] + b * place[k] + at(7) * (c * from.velocity[k] + d * velocity[k])
        };
        net.metric([along(0), along(1)]).curvature()
    });
    let all = [
        place[0],
        place[1],
        velocity[0],
        velocity[1],
        a,
        b,
        metric.curvature(),
        speed,
        fifth[0],
        third[0],
        fifth[1],
        third[1],
        quarters[0],
        quarters[1],
        quarters[2],
    ];
    let mut ends = Ends { numbers: [[0.0; MOST]; 15] };
    for (row, x) in ends.numbers.iter_mut().zip(all) {
        x.store(row);
    }
    ends
}

/// Where a lane may go: the window, less the neighbourhoods of collapsed sides.
struct Bounds {
    low: [f64; 2],
    high: [f64; 2],
    degrees: [f64; 2],
    flat: bool,
}

impl Bounds {
    fn new(atlas: &Atlas, net: usize) -> Self {
        let (mut low, mut high) = ([0.0; 2], [1.0; 2]);
        for (axis, side) in atlas.points_of(net) {
            let reach = match &atlas.caps[axis][side] {
                Edge::Cap(cap) => cap.reach,
                Edge::Line | Edge::Apex(_) => APEX,
            };
            *(if side == 0 { &mut low[axis] } else { &mut high[axis] }) =
                if side == 0 { reach } else { 1.0 - reach };
        }
        let degrees = atlas.nets[net].orders.map(|order| (order - 1) as f64);
        Self { low, high, degrees, flat: atlas.ambient == 2 }
    }

    /// Errors of place and turn with those of rounding.
    fn rounded(&self, [place, turn]: [f64; 2], velocity: [f64; 2], by: f64) -> [f64; 2] {
        let pace = velocity[0].abs() * self.degrees[0] + velocity[1].abs() * self.degrees[1];
        let share = by * pace;
        [place + f64::EPSILON * (1.0 + share), turn + f64::EPSILON * (1.0 + pace * share)]
    }

    /// Does a step keep within, as far as the cubic of its ends tells?
    fn hold(&self, from: &State<f64>, to: &State<f64>, by: f64) -> bool {
        (0..2).all(|k| {
            let inner = [
                from.place[k] + by / 3.0 * from.velocity[k],
                to.place[k] - by / 3.0 * to.velocity[k],
            ];
            let within = |x: f64| self.low[k] <= x && x <= self.high[k];
            inner.into_iter().chain([to.place[k]]).all(within)
        })
    }
}

/// The error of a step from the squares of those of orders 5 and 3.
fn combined(fifth: f64, third: f64) -> f64 {
    let sum = fifth + 0.01 * third;
    if sum > 0.0 { fifth / sum.sqrt() } else { 0.0 }
}

/// How near to an apex lanes go, of a piece.
const APEX: f64 = 0.05;

/// Takes the step of a lane or tries a shorter one; false when the lane is free.
fn taken(task: &mut Task, lane: usize, hold: &mut Hold, ends: &Ends, bounds: &Bounds) -> bool {
    let end = |k: usize| ends.numbers[k][lane];
    let by = hold.numbers[7][lane];
    task.course.steps += 1;
    let speed = end(7);
    let errors = [combined(end(8), end(9)), combined(end(10), end(11))];
    let excess = task.request.excess(errors[0].max(errors[1]), by);
    let finite = excess.is_finite() && end(4).is_finite() && end(5).is_finite();
    if !(finite && speed > 0.5 && speed < 2.0) {
        return false;
    }
    let next = by * 0.9 * libm::pow(excess, -1.0 / 7.0);
    if excess > 1.0 {
        task.by = next.clamp(0.1 * by, 0.9 * by);
        hold.numbers[7][lane] = task.by;
        return task.by > SHORT;
    }
    let velocity = [end(2) / speed, end(3) / speed];
    let to = State { place: [end(0), end(1)], velocity };
    if !bounds.hold(&task.course.state, &to, by) {
        return false;
    }
    let curvatures = match bounds.flat {
        true => [0.0; 5],
        false => [hold.numbers[6][lane], end(12), end(13), end(14), end(6)],
    };
    if unclear(by, &curvatures) > 1.0 {
        task.by = 0.5 * by;
        hold.numbers[7][lane] = task.by;
        return task.by > SHORT;
    }
    let course = &mut task.course;
    let [place, turn] = bounds.rounded(errors, velocity, by);
    course.growth.step(course.length, by, &curvatures, place, turn);
    course.state = to;
    let last = by >= task.request.length - course.length;
    course.length = if last { task.request.length } else { course.length + by };
    if last {
        task.done = true;
        return false;
    }
    task.by = next.clamp(0.5 * by, 5.0 * by);
    let square = speed * speed;
    let numbers = [
        to.place[0],
        to.place[1],
        velocity[0],
        velocity[1],
        end(4) / square,
        end(5) / square,
        end(6),
        task.by.min(task.rest()),
    ];
    for (row, x) in hold.numbers.iter_mut().zip(numbers) {
        row[lane] = x;
    }
    true
}

/// Steps shorter than this are left to one that goes alone.
const SHORT: f64 = 1e-12;
