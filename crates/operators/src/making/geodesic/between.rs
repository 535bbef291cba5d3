//! Straight lines from one point of a surface to another.

use pforms_kernel::{Error, Result};

use super::atlas::{Atlas, ROUNDING};
use super::metric::Metric;
use super::search::Search;
use super::step::State;
use super::trace::Chart;
use super::{Geodesic, GeodesicOptions, Heading, begun, checked};
use crate::Spline;
use crate::measuring::vector::{norm, plus};

/// What is known of a line between two points being the shortest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Minimality {
    /// It is straight in space: nothing is shorter.
    Proved,
    /// No conjugate point lies on it: it is shorter than all lines near it.
    Local,
    /// Its end is conjugate to its start, as on opposite sides of a sphere: there may be many as short.
    Family,
    /// A conjugate point lies on it: there are shorter lines near it.
    Not,
}

/// A geodesic from one point to another.
#[derive(Clone, Debug, PartialEq)]
pub struct Connection {
    /// The line.
    pub geodesic: Geodesic,
    /// How far it ends from the point it was to reach.
    pub gap: f64,
    /// Is it the shortest?
    pub minimality: Minimality,
}

/// The geodesics found between two points of a surface, the shortest first.
///
/// Both are parameters. Directions all around the start are tried, and lines up to `longest`; unless it is given, up
/// to one and a half times the length of the segment between the parameters. That every line was found is not
/// proved. The error of each is kept below `accuracy`, in sizes of the surface, and so is the gap at its end; lines that
/// rounding keeps from that are left out if there are others. Points that are one and the same have no line between
/// them: the list is empty.
///
/// Errors: as [`geodesic`](super::geodesic); `Degenerate` for a start at an apex, and when no line within the window
/// is found.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{GeodesicOptions, Minimality, geodesic_between};
/// let flat: Form = Form::from_points(&[2, 2], 2, &[0., 0., 0., 3., 4., 0., 4., 3.], None)?;
/// let lines = geodesic_between(flat, [0.0, 0.0], [1.0, 1.0], None, &GeodesicOptions::default())?;
/// assert!((lines[0].geodesic.length - 5.0).abs() < 1e-9);
/// assert_eq!(lines[0].minimality, Minimality::Proved);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn geodesic_between(
    surface: impl Into<Spline>,
    from: [f64; 2],
    to: [f64; 2],
    longest: Option<f64>,
    options: &GeodesicOptions,
) -> Result<Vec<Connection>> {
    connections(&surface.into(), [from, to], longest, options, true)
}

/// The shortest of the geodesics found between two points of a surface: as [`geodesic_between`], sooner; none between
/// points that are one and the same.
///
/// Errors: as [`geodesic_between`].
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{GeodesicOptions, shortest_geodesic};
/// let flat: Form = Form::from_points(&[2, 2], 2, &[0., 0., 0., 3., 4., 0., 4., 3.], None)?;
/// let line = shortest_geodesic(flat, [0.0, 0.0], [1.0, 1.0], None, &GeodesicOptions::default())?;
/// assert!(line.is_some_and(|line| (line.geodesic.length - 5.0).abs() < 1e-9));
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn shortest_geodesic(
    surface: impl Into<Spline>,
    from: [f64; 2],
    to: [f64; 2],
    longest: Option<f64>,
    options: &GeodesicOptions,
) -> Result<Option<Connection>> {
    let lines = connections(&surface.into(), [from, to], longest, options, false)?;
    Ok(lines.into_iter().next())
}

fn connections(
    surface: &Spline,
    [from, to]: [[f64; 2]; 2],
    longest: Option<f64>,
    options: &GeodesicOptions,
    all: bool,
) -> Result<Vec<Connection>> {
    let accuracy = checked(surface, from, longest.unwrap_or(1.0), options)?;
    checked(surface, to, 1.0, options)?;
    let atlas = Atlas::new(surface, options.seams)?;
    let point = |at: [f64; 2]| {
        let (net, place) = atlas.locate(at);
        atlas.nets[net].point(place)
    };
    let (start, target) = (point(from), point(to));
    if norm(&plus(&target, -1.0, &start)) <= ROUNDING {
        return Ok(Vec::new());
    }
    let longest = match longest {
        Some(length) => atlas.in_units(length),
        None => 1.5 * segment_length(from, to, point) + 1e-6,
    };
    let (chart, state) = anywhere(&atlas, from)?;
    let frame = frame(&atlas, chart, state);
    let search =
        Search { atlas: &atlas, chart, state, frame, start, target, longest, accuracy, all };
    let mut lines = search.lines()?;
    lines.sort_by(|a, b| a.geodesic.length.total_cmp(&b.geodesic.length));
    Ok(lines)
}

/// A start in whichever direction there is.
fn anywhere(atlas: &Atlas, from: [f64; 2]) -> Result<(Chart, State<f64>)> {
    let (net, place) = atlas.locate(from);
    if atlas.at_apex(net, place) {
        return Err(Error::degenerate(
            "from",
            "the apex of a cone or the like, which has no tangent plane",
            "a regular point: the line may end at an apex, but not begin there",
        ));
    }
    let headings = [[1.0, 0.3], [0.3, 1.0]].map(Heading::Parameters);
    let spatial = (0..atlas.ambient).map(|k| {
        let mut axis = vec![0.1; atlas.ambient];
        axis[k] = 1.0;
        Heading::Vector(axis)
    });
    let mut failure = None;
    for heading in spatial.chain(headings) {
        match begun(atlas, from, &heading) {
            Ok((chart, state))
                if frame(atlas, chart, state).iter().flatten().all(|x| x.is_finite()) =>
            {
                return Ok((chart, state));
            }
            Ok(_) => {}
            Err(error) => failure = Some(error),
        }
    }
    let none = || Error::degenerate("from", "a point without a tangent plane", "a regular point");
    Err(failure.unwrap_or_else(none))
}

/// Two directions of unit speed at right angles.
fn frame(atlas: &Atlas, chart: Chart, state: State<f64>) -> [[f64; 2]; 2] {
    let metric: Metric<f64> = match chart {
        Chart::Piece(net) => atlas.nets[net].metric(state.place),
        Chart::Cap(axis, side) => {
            let seen = atlas.cap(axis, side).map(|cap| cap.look(state.place, state.velocity).0);
            seen.unwrap_or_else(Metric::nowhere)
        }
    };
    let [e, f, g] = metric.first;
    let first = [1.0 / e.sqrt(), 0.0];
    let across = (g - f * f / e).sqrt();
    [first, [-f / e / across, 1.0 / across]]
}

/// The length of the image of the segment between two parameters, about.
fn segment_length(from: [f64; 2], to: [f64; 2], point: impl Fn([f64; 2]) -> Vec<f64>) -> f64 {
    let at = |k: usize| {
        let share = k as f64 / 128.0;
        point([0, 1].map(|i| (1.0 - share) * from[i] + share * to[i]))
    };
    let points: Vec<Vec<f64>> = (0..=128).map(at).collect();
    points.windows(2).map(|pair| norm(&plus(&pair[1], -1.0, &pair[0]))).sum()
}
