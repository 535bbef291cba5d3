//! Many geodesics at once: as many lanes as the machine has, each on its own way.
//!
//! Lanes step together over one piece of the surface. One that comes to a side, a collapsed edge or anything else
//! out of the ordinary is followed alone until it is on the next piece, and joins the others there.

#![allow(
    clippy::inline_always,
    clippy::needless_range_loop,
    reason = "only what is inlined is compiled for the wider sets; lanes are counted, not iterated"
)]

use pforms_kernel::vectors::{Job, Lanes, MOST, Simd, in_lanes};
use pforms_kernel::{Error, Result, threads};

use super::atlas::{Atlas, Edge};
use super::growth::Curvatures;
use super::metric::Net;
use super::step::{State, step};
use super::trace::{Chart, Course, Request, resumed};
use super::{AIM, Ending, GeodesicOptions, Heading, arrived, begun, checked, settled};
use crate::Spline;

/// Where geodesics end, one after another.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Arrivals {
    /// Two parameters for each.
    pub parameters: Vec<f64>,
    /// Points: as many numbers for each as the surface has coordinates.
    pub points: Vec<f64>,
    /// Unit directions, likewise.
    pub directions: Vec<f64>,
    /// How long they are.
    pub lengths: Vec<f64>,
    /// How far the points may be from the true ones.
    pub errors: Vec<f64>,
    /// Why they end.
    pub endings: Vec<Ending>,
    /// Steps of all of them together.
    pub steps: usize,
}

/// The ends of many geodesics of one surface: as [`geodesic`](super::geodesic), without drawing them.
///
/// There must be as many headings and lengths as starts, or one of them. A geodesic of length 0 and one that leaves the
/// window at once end where they start.
///
/// Errors: as for one; `Shape` for lists of other lengths.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{GeodesicOptions, Heading, geodesics};
/// let flat: Form = Form::from_points(&[2, 2], 2, &[0., 0., 0., 1., 1., 0., 1., 1.], None)?;
/// let headings = [Heading::Angle(0.0), Heading::Parameters([3.0, 4.0])];
/// let ends = geodesics(flat, &[[0.0, 0.0], [0.1, 0.1]], &headings, &[0.5], &GeodesicOptions::default())?;
/// assert!((ends.points[2] - 0.4).abs() < 1e-12 && (ends.points[3] - 0.5).abs() < 1e-12);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn geodesics(
    surface: impl Into<Spline>,
    starts: &[[f64; 2]],
    headings: &[Heading],
    lengths: &[f64],
    options: &GeodesicOptions,
) -> Result<Arrivals> {
    let surface = surface.into();
    let count = starts.len();
    for (name, given) in [("directions", headings.len()), ("lengths", lengths.len())] {
        if given != 1 && given != count {
            return Err(Error::shape(name, given, format!("1 or {count}, as many as starts")));
        }
    }
    let atlas = Atlas::new(&surface, options.seams)?;
    let mut tasks = Vec::with_capacity(count);
    for (k, start) in starts.iter().enumerate() {
        let length = lengths[k % lengths.len()];
        let accuracy = checked(&surface, *start, length.max(f64::MIN_POSITIVE), options)?;
        let (chart, state) = begun(&atlas, *start, &headings[k % headings.len()])?;
        tasks.push(Task::new(chart, state, atlas.in_units(length.max(0.0)), accuracy));
    }
    // One thread's share is a block of tasks that keeps its lanes full.
    threads::fill_parts(&mut tasks, 1, COST, |_, part| followed(&atlas, part))?;
    let mut arrivals = Arrivals::default();
    for task in tasks {
        let course = task.course;
        let (end, point, direction) = arrived(&atlas, &course);
        arrivals.parameters.extend(end);
        arrivals.points.extend(point);
        arrivals.directions.extend(direction);
        arrivals.lengths.push(atlas.length(course.length));
        arrivals.errors.push(atlas.length(course.growth.error()));
        arrivals.endings.push(course.ending);
        arrivals.steps += course.steps;
    }
    Ok(arrivals)
}

/// Operations of one geodesic, about.
const COST: usize = 1 << 17;

/// One geodesic on its way.
struct Task {
    begin: (Chart, State<f64>),
    request: Request,
    accuracy: f64,
    course: Course,
    /// The step to try next.
    by: f64,
    done: bool,
}

impl Task {
    fn new(chart: Chart, state: State<f64>, length: f64, accuracy: f64) -> Self {
        let request = Request::quick(length, accuracy);
        let course = Course::new(chart, state);
        Self {
            begin: (chart, state),
            request,
            accuracy,
            course,
            by: request.first(),
            done: length == 0.0,
        }
    }

    fn rest(&self) -> f64 {
        self.request.length - self.course.length
    }
}

/// Follows all of them to their ends.
fn followed(atlas: &Atlas, tasks: &mut [Task]) -> Result<()> {
    // Directions are brought to unit speed, and charts to those that suit the starts.
    for task in tasks.iter_mut().filter(|task| !task.done) {
        alone(atlas, task, 0.0)?;
    }
    loop {
        let mut moved = false;
        for net in 0..atlas.nets.len() {
            let here = |task: &Task| !task.done && task.course.chart == Chart::Piece(net);
            let mut group: Vec<&mut Task> = tasks.iter_mut().filter(|task| here(task)).collect();
            if !group.is_empty() {
                in_lanes(Together { atlas, net, tasks: &mut group });
                moved = true;
            }
        }
        for task in tasks.iter_mut().filter(|task| !task.done) {
            alone(atlas, task, f64::INFINITY)?;
            moved = true;
        }
        if !moved {
            break;
        }
    }
    for task in tasks.iter_mut() {
        // Those whose errors grew too much go once more, each with steps of its own.
        if task.course.growth.error() > task.accuracy && task.request.length > 0.0 {
            let (chart, state) = task.begin;
            task.course = settled(atlas, chart, state, task.request.length, task.accuracy, false)?;
        }
    }
    Ok(())
}

/// Follows one by itself until it is on another piece, or for a while.
fn alone(atlas: &Atlas, task: &mut Task, at_most: f64) -> Result<()> {
    let request = Request { pause: true, length: task.request.length.min(at_most), ..task.request };
    let empty = Course::new(task.course.chart, task.course.state);
    let course = resumed(atlas, std::mem::replace(&mut task.course, empty), &request)?;
    task.done = course.ending != Ending::Length || course.length >= task.request.length;
    task.course = course;
    task.by = task.request.first().min(task.rest());
    Ok(())
}

/// All tasks of one piece.
struct Together<'a, 'b> {
    atlas: &'a Atlas,
    net: usize,
    tasks: &'a mut [&'b mut Task],
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
/// orders 5 and 3.
struct Ends {
    numbers: [[f64; MOST]; 12],
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
    ];
    let mut ends = Ends { numbers: [[0.0; MOST]; 12] };
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

    /// Gauss curvatures over a step from those of its ends.
    fn curvatures(&self, before: f64, after: f64) -> Curvatures {
        if self.flat {
            return [0.0; 5];
        }
        let middle = f64::midpoint(before, after);
        [before, f64::midpoint(before, middle), middle, f64::midpoint(middle, after), after]
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
    let next = by * 0.9 * excess.powf(-1.0 / 7.0);
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
    let course = &mut task.course;
    let curvatures = bounds.curvatures(hold.numbers[6][lane], end(6));
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

impl Request {
    /// What one of many is asked for: its end.
    fn quick(length: f64, accuracy: f64) -> Self {
        Self {
            length,
            tolerance: AIM * accuracy / length.max(1.0),
            slack: super::DRAWN * accuracy,
            dense: false,
            pause: true,
        }
    }
}
