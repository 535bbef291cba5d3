//! Straight lines on surfaces (book, sections 0232 and 36).
//!
//! A geodesic is a curve on a surface whose second derivative has no part in the tangent plane: a string pulled
//! tight, a ball that rolls freely. In parameters it is a differential equation of the second order, whose terms
//! are products of exact derivatives of the surface (`metric`). It is integrated by the method of order 8 of
//! Dormand and Prince with steps that suit the errors of its lower orders (`step`, `attempt`, `trace`), piece after
//! piece (`sides`, `cross`), over the tangent plane near a collapsed edge, where parameters say nothing (`cap`, `spokes`,
//! `local`). How far the end may be off is what the errors of the steps become as neighbouring geodesics part or meet
//! (`growth`). Lines between two points are sought (`search`) among those that leave the first.

mod atlas;
mod attempt;
mod between;
mod bulk;
mod cap;
mod cross;
mod curve;
mod growth;
mod lanes;
mod local;
mod metric;
mod number;
mod planks;
mod search;
mod sides;
mod spokes;
mod step;
mod tableau;
mod trace;

use pforms_kernel::{Error, Result};

use crate::Spline;
use crate::measuring::vector::{dot, norm, plus};
use atlas::{Atlas, Edge};
pub use between::{Connection, Minimality, geodesic_between, shortest_geodesic};
pub use bulk::{Arrivals, geodesics};
pub use planks::{Mark, Plank, PlankOptions, plank_lines, planks};
use step::State;
use trace::{Chart, Course, Request, trace};

/// Why a geodesic ends where it does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// It has the length asked for.
    Length,
    /// It left the window over a side.
    Border,
    /// It ran into a collapsed side beyond which the surface does not go on: the apex of a cone, the pole of an
    /// eighth of a sphere.
    Collapsed,
    /// The surface has no tangent plane there, or its parameters stand still.
    Singular,
    /// The pieces of the surface do not meet there.
    Torn,
}

/// A direction on a surface.
#[derive(Clone, Debug, PartialEq)]
pub enum Heading {
    /// `(u′, v′)`, of any size.
    Parameters([f64; 2]),
    /// A vector in space, of which the part in the tangent plane counts.
    Vector(Vec<f64>),
    /// `u′ = cos A`, `v′ = sin A·|f_u|/|f_v|`, in radians: the angle with `f_u` where the parameter lines are at
    /// right angles (book, section 36).
    Angle(f64),
}

impl Heading {
    fn told(&self) -> String {
        match self {
            Self::Parameters([u, v]) => format!("({u}, {v})"),
            Self::Vector(vector) => format!("the vector {vector:?}"),
            Self::Angle(angle) => format!("the angle {angle}"),
        }
    }
}

/// How a geodesic is to be followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GeodesicOptions {
    /// Error of the places of the result, in sizes of the surface.
    pub accuracy: f64,
    /// Go on over sides of the window that are one and the same line, such as those of a whole torus?
    pub seams: bool,
}

impl Default for GeodesicOptions {
    /// An accuracy of 10⁻¹⁰, over seams.
    fn default() -> Self {
        Self { accuracy: 1e-10, seams: true }
    }
}

/// A geodesic by its length.
#[derive(Clone, Debug, PartialEq)]
pub struct Geodesic {
    /// In the parameters of the surface. Where it crosses a seam it has a gap.
    pub parameters: Spline,
    /// In space.
    pub spline: Spline,
    /// How long it is.
    pub length: f64,
    /// No place is farther than this from that of the true geodesic of the same length, the rounding of coordinates
    /// far from the origin included.
    pub error: f64,
    /// Why it ends.
    pub ending: Ending,
    /// The parameters where it ends.
    pub end: [f64; 2],
    /// The point where it ends.
    pub point: Vec<f64>,
    /// Its unit direction there.
    pub direction: Vec<f64>,
    /// The length at which geodesics that begin with it meet it again, first order: beyond, there are shorter
    /// ways.
    pub conjugate: Option<f64>,
    /// The largest angle between the two sides of a knot or seam that it crosses: 0 on a smooth surface.
    pub crease: f64,
    /// Steps of the integration.
    pub steps: usize,
}

/// The geodesic of a surface that starts at parameters in a direction, as long as asked or as far as it goes.
///
/// The error is kept below `accuracy`, in sizes of the surface: it is found from the errors of all steps and from
/// how neighbouring geodesics part, to first order, and the integration is repeated with shorter steps until it
/// is small enough. On forms and splines in any dimension from 2; over smooth knots, knots with a kink (straight
/// when both sides are laid flat), closed seams, and collapsed edges where the surface is smooth.
///
/// Errors: `Shape` unless it is a surface in dimension 2 or more; `Domain` for a start outside the window, a
/// length that is not above 0, or an accuracy that is not; `Degenerate` where the surface has no tangent plane at
/// the start, for a direction without a part in it, or when the geodesic leaves the window at once; `Accuracy`
/// when rounding or the number of steps does not allow the one asked for.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{GeodesicOptions, Heading, geodesic};
/// // A saddle z = x·y: its rulings are straight.
/// let saddle: Form = Form::from_points(&[2, 2], 3, &[0., 0., 0., 0., 1., 0., 1., 0., 0., 1., 1., 1.], None)?;
/// let heading = Heading::Parameters([1.0, 0.0]);
/// let line = geodesic(saddle, [0.0, 0.5], &heading, 1.0, &GeodesicOptions::default())?;
/// assert!((line.point[2] - 1.0 / 5_f64.sqrt()).abs() < 1e-12 && (line.end[1] - 0.5).abs() < 1e-12);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn geodesic(
    surface: impl Into<Spline>,
    start: [f64; 2],
    heading: &Heading,
    length: f64,
    options: &GeodesicOptions,
) -> Result<Geodesic> {
    let surface = surface.into();
    let accuracy = checked(&surface, start, length, options)?;
    let atlas = Atlas::new(&surface, options.seams)?;
    let (chart, state) = begun(&atlas, start, heading)?;
    let course = settled(&atlas, chart, state, atlas.in_units(length), accuracy, true)?;
    finished(&atlas, &course, accuracy)
}

/// Integrations of one geodesic, each with shorter steps.
const PASSES: usize = 8;

/// Shares of the error allowed: for what is drawn, and aimed at.
const DRAWN: f64 = 0.1;
const AIM: f64 = 0.3;

/// The course within an accuracy, in units.
fn settled(
    atlas: &Atlas,
    chart: Chart,
    state: State<f64>,
    length: f64,
    accuracy: f64,
    dense: bool,
) -> Result<Course> {
    let mut tolerance = 0.1 * accuracy / length.max(1.0);
    let mut reached = f64::INFINITY;
    for _ in 0..PASSES {
        let request =
            Request { length, tolerance, slack: DRAWN * accuracy, dense, sure: true, pause: false };
        let course = trace(atlas, chart, state, &request)?;
        let error = course.growth.error() + course.between;
        if error <= (1.0 - 2.0 * DRAWN) * accuracy {
            return Ok(course);
        }
        // Shorter steps that do not help are rounding.
        if error > 0.9 * reached || tolerance < 1e-18 {
            break;
        }
        reached = reached.min(error);
        tolerance *= (AIM * accuracy / error).clamp(1e-6, 0.5);
    }
    Err(Error::accuracy(
        "accuracy",
        accuracy,
        format!("one that rounding and the parting of neighbours allow, here about {reached:.0e}"),
    ))
}

fn checked(
    surface: &Spline,
    start: [f64; 2],
    length: f64,
    options: &GeodesicOptions,
) -> Result<f64> {
    surface.net().require_per_axis("start", &start)?;
    for (axis, t) in start.iter().enumerate() {
        let (from, to) = surface.window(axis)?;
        if !(from..=to).contains(t) {
            return Err(Error::domain("start", t, format!("a parameter from {from} to {to}")));
        }
    }
    if !(length > 0.0 && length.is_finite()) {
        return Err(Error::domain("length", length, "a number above 0"));
    }
    if !(options.accuracy > 0.0 && options.accuracy < 1.0) {
        return Err(Error::domain("accuracy", options.accuracy, "a number between 0 and 1"));
    }
    Ok(options.accuracy)
}

/// Where a geodesic begins, and its direction.
fn begun(atlas: &Atlas, start: [f64; 2], heading: &Heading) -> Result<(Chart, State<f64>)> {
    let (net, place) = atlas.locate(start);
    let [_, u, v, ..] = atlas.nets[net].jet(place);
    if !matches!(heading, Heading::Parameters(_)) && atlas.at_apex(net, place) {
        return Err(Error::degenerate(
            "start",
            "the apex of a cone or the like, which has no tangent plane",
            "a regular start, or a direction in parameters",
        ));
    }
    let velocity = match heading {
        Heading::Parameters(velocity) => [0, 1].map(|axis| velocity[axis] / atlas.span(net, axis)),
        Heading::Angle(angle) => {
            let [along, across] = [0, 1].map(|axis| atlas.span(net, axis));
            let ratio = (norm(&u) / along) / (norm(&v) / across);
            [libm::cos(*angle) / along, libm::sin(*angle) * ratio / across]
        }
        Heading::Vector(vector) => {
            if vector.len() != atlas.ambient {
                let received = format!("{} numbers", vector.len());
                return Err(Error::shape("direction", received, format!("{}", atlas.ambient)));
            }
            let size = vector.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
            let vector: Vec<f64> = vector.iter().map(|x| x / size).collect();
            if let Some((chart, velocity)) = at_pole(atlas, net, place, &vector) {
                return Ok((chart, State { place: [0.0; 2], velocity }));
            }
            tangential(&u, &v, &vector)
        }
    };
    let size = velocity[0].abs().max(velocity[1].abs());
    if !(size > 0.0 && size.is_finite()) {
        return Err(Error::degenerate(
            "direction",
            heading.told(),
            "a direction with a part in the tangent plane of the surface",
        ));
    }
    Ok((Chart::Piece(net), State { place, velocity: velocity.map(|x| x / size) }))
}

/// A start on a collapsed side where the surface is smooth: any direction will do.
fn at_pole(
    atlas: &Atlas,
    net: usize,
    place: [f64; 2],
    vector: &[f64],
) -> Option<(Chart, [f64; 2])> {
    for (axis, side) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        let ends = atlas.index(net)[axis] == if side == 0 { 0 } else { atlas.counts[axis] - 1 };
        if ends
            && place[axis] == side as f64
            && let Edge::Cap(cap) = &atlas.caps[axis][side]
        {
            return Some((Chart::Cap(axis, side), cap.projected(vector)));
        }
    }
    None
}

/// The velocity whose image is nearest to a vector; NaN where there is no tangent plane, 0 for a normal.
fn tangential(u: &[f64], v: &[f64], vector: &[f64]) -> [f64; 2] {
    let first = crate::measuring::vector::unit(u);
    let across = plus(v, -dot(v, &first), &first);
    let second = crate::measuring::vector::unit(&across);
    let (a, b) = (dot(vector, &first), dot(vector, &second));
    if a.abs().max(b.abs()) <= 1e-12 * norm(vector) {
        return [0.0; 2];
    }
    let speed = b / norm(&across);
    [(a - speed * dot(v, &first)) / norm(u), speed]
}

fn finished(atlas: &Atlas, course: &Course, accuracy: f64) -> Result<Geodesic> {
    if course.legs.is_empty() {
        return Err(Error::degenerate(
            "direction",
            format!("a geodesic that ends where it starts ({:?})", course.ending),
            "a direction into the surface",
        ));
    }
    let drawn = curve::drawn(atlas, course, DRAWN * accuracy)?;
    let (end, point, direction) = arrived(atlas, course);
    Ok(Geodesic {
        parameters: drawn.parameters,
        spline: drawn.space,
        length: atlas.length(course.length),
        error: atlas.length(course.growth.error() + course.between + drawn.error) + atlas.grain(),
        ending: course.ending,
        end,
        point,
        direction,
        conjugate: course.growth.conjugate.map(|length| atlas.length(length)),
        crease: course.crease,
        steps: course.steps,
    })
}

/// Parameters, point and unit direction of the end of a course.
fn arrived(atlas: &Atlas, course: &Course) -> ([f64; 2], Vec<f64>, Vec<f64>) {
    let (parameters, point, direction) = seen(atlas, course.chart, course.state);
    (parameters, atlas.point(&point), direction)
}

/// Parameters, point in units and direction in space of a state.
fn seen(atlas: &Atlas, chart: Chart, state: State<f64>) -> ([f64; 2], Vec<f64>, Vec<f64>) {
    let State { place, velocity } = state;
    let (net, found, direction) = match chart {
        Chart::Piece(net) => {
            let [_, u, v, ..] = atlas.nets[net].jet(place);
            let direction = u.iter().zip(&v).map(|(u, v)| u * velocity[0] + v * velocity[1]);
            (net, place, direction.collect())
        }
        Chart::Cap(axis, side) => {
            let Some(cap) = atlas.cap(axis, side) else {
                return ([f64::NAN; 2], Vec::new(), Vec::new());
            };
            let (net, found) = cap.place_under(place, velocity);
            (net, found, cap.direction(place, velocity))
        }
    };
    let inside = found.map(|t| t.clamp(0.0, 1.0));
    (atlas.parameters(net, inside), atlas.nets[net].point(found), direction)
}
