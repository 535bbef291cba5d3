//! Follows one geodesic over the pieces of a surface, step by step.

use pforms_kernel::{Error, Result};

use super::Ending;
use super::atlas::{Atlas, Edge};
use super::attempt::{Look, Tried, finite, look, unit_speed};
use super::growth::Growth;
use super::sides::Moved;
use super::step::{Path, State};

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
    /// Is the bound of the error wanted? Then curvatures are looked at within steps as well.
    pub sure: bool,
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

pub(super) struct Tracer<'a> {
    pub atlas: &'a Atlas,
    pub request: &'a Request,
    pub course: Course,
    /// The step to try next.
    by: f64,
    /// The step that was refused here last, and its excess.
    pub refused: Option<(f64, f64)>,
    /// Sides crossed since the last step.
    pub idle: usize,
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
    let mut tracer = Tracer { atlas, request, course, by: request.first(), refused: None, idle: 0 };
    tracer.recharted();
    if let Some(ending) = tracer.run()? {
        tracer.course.ending = ending;
    }
    Ok(tracer.course)
}

/// The step tried first.
const FIRST: f64 = 0.05;

/// A step this short no longer moves.
pub(super) const SHORTEST: f64 = 1e-15;

/// Errors of a step below this are rounding.
pub(super) const FLOOR: f64 = 4.0 * f64::EPSILON;

/// Errors of a step above this are not rounding.
const NOISE: f64 = 1e-8;

/// Share of the way to a collapsed side that a step may go.
const APPROACH: f64 = 0.7;

impl Tracer<'_> {
    fn run(&mut self) -> Result<Option<Ending>> {
        let mut look = self.prepared()?;
        while self.course.length < self.request.length {
            pforms_kernel::stopping::check()?;
            self.count()?;
            let rest = self.request.length - self.course.length;
            let by = self.by.min(rest).min(self.approach());
            if by < rest && self.is_nothing(by) {
                return Ok(Some(Ending::Singular));
            }
            let Some(tried) = self.tried(&look, by) else {
                (self.by, self.refused) = (by / 4.0, None);
                continue;
            };
            if !self.allows(&tried) {
                continue;
            }
            match self.moved(&look, &tried) {
                Moved::On if by == rest => self.course.length = self.request.length,
                Moved::On => {}
                Moved::Over => {
                    let Ok(beyond) = self.prepared() else {
                        return Ok(Some(Ending::Singular));
                    };
                    look = beyond;
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
                let Ok(beyond) = self.prepared() else {
                    return Ok(Some(Ending::Singular));
                };
                look = beyond;
                if self.request.pause && matches!(self.course.chart, Chart::Piece(_)) {
                    return Ok(None);
                }
            } else {
                look = tried.look;
            }
        }
        Ok(None)
    }

    /// Is a step good enough? Sets the next in either case.
    ///
    /// A shorter one whose error did not fall as errors of a method do has the error of rounding: it is taken for what
    /// it is, and the bound of the course tells.
    fn allows(&mut self, tried: &Tried) -> bool {
        let by = tried.by;
        let next = by * 0.9 * libm::pow(tried.excess, -1.0 / 7.0);
        let refused = self.refused.take();
        if tried.excess <= 1.0 {
            self.by = next.clamp(0.5 * by, 5.0 * by);
            return true;
        }
        if let Some((longer, excess)) = refused {
            let small = tried.errors[0].max(tried.errors[1]).max(tried.between) < NOISE;
            if small && tried.excess > 0.5 * excess {
                self.by = longer;
                return true;
            }
        }
        self.refused = Some((by, tried.excess));
        self.by = next.clamp(0.1 * by, 0.9 * by);
        false
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

    pub(super) fn is_nothing(&self, by: f64) -> bool {
        by < SHORTEST * (1.0 + self.course.length)
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

    pub(super) fn accept(&mut self, tried: &Tried) {
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
}
