//! Many geodesics at once: as many lanes as the machine has, each on its own way.
//!
//! Lanes step together over one piece of the surface. One that comes to a side, a collapsed edge or anything else
//! out of the ordinary is followed alone until it is on the next piece, and joins the others there.

use pforms_kernel::vectors::in_lanes;
use pforms_kernel::{Error, Result, threads};

use super::atlas::Atlas;
use super::lanes::Together;
use super::step::State;
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
        arrivals.errors.push(atlas.length(CAUTION * course.growth.error()) + atlas.grain());
        arrivals.endings.push(course.ending);
        arrivals.steps += course.steps;
    }
    Ok(arrivals)
}

/// Steps in lanes are longer, and not compared with the equation between their ends: their errors count twice.
const CAUTION: f64 = 2.0;

/// Operations of one geodesic, about.
const COST: usize = 1 << 17;

/// One geodesic on its way.
pub(super) struct Task {
    begin: (Chart, State<f64>),
    pub request: Request,
    accuracy: f64,
    pub course: Course,
    /// The step to try next.
    pub by: f64,
    pub done: bool,
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

    pub(super) fn rest(&self) -> f64 {
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
        pforms_kernel::stopping::check()?;
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
        if CAUTION * task.course.growth.error() > task.accuracy && task.request.length > 0.0 {
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

impl Request {
    /// What one of many is asked for: its end.
    fn quick(length: f64, accuracy: f64) -> Self {
        Self {
            length,
            tolerance: AIM * accuracy / length.max(1.0),
            slack: super::DRAWN * accuracy,
            dense: false,
            sure: true,
            pause: true,
        }
    }
}
