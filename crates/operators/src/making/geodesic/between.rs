//! Straight lines from one point of a surface to another.
//!
//! Directions all around the start are tried, coarsely; where one passes near the end, Newton's steps on the angle
//! and the length bring it there. Every line found is followed again with a bound of its error.

use std::f64::consts::TAU;

use pforms_kernel::{Error, Result};

use super::atlas::Atlas;
use super::step::{State, along};
use super::trace::{Chart, Course, Request, trace};
use super::{DRAWN, Geodesic, GeodesicOptions, arrived, begun, checked, finished, settled};
use super::{Heading, metric::Metric};
use crate::Spline;
use crate::measuring::vector::{dot, norm, plus};

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
/// proved. The error of each is kept below `accuracy`, in sizes of the surface, and so is the gap at its end. Points that
/// are one and the same have no line between them: the list is empty.
///
/// Errors: as [`geodesic`](super::geodesic); `Degenerate` when no line within the window is found.
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
    let surface = surface.into();
    let accuracy = checked(&surface, from, longest.unwrap_or(1.0), options)?;
    checked(&surface, to, 1.0, options)?;
    let atlas = Atlas::new(&surface, options.seams)?;
    let point = |at: [f64; 2]| {
        let (net, place) = atlas.locate(at);
        let [point, ..] = atlas.nets[net].jet(place);
        point
    };
    let (start, target) = (point(from), point(to));
    if norm(&plus(&target, -1.0, &start)) <= super::atlas::ROUNDING {
        return Ok(Vec::new());
    }
    let longest = match longest {
        Some(length) => atlas.in_units(length),
        None => 1.5 * segment_length(from, to, point) + 1e-6,
    };
    let (chart, state) = anywhere(&atlas, from)?;
    let search = Search {
        atlas: &atlas,
        chart,
        state,
        frame: frame(&atlas, chart, state),
        target,
        longest,
        accuracy,
    };
    let mut lines: Vec<Connection> = Vec::new();
    for (angle, length) in search.all() {
        let line = search.line(angle, length)?;
        let line = Connection {
            minimality: minimality(&line, norm(&plus(&search.target, -1.0, &start)), &atlas),
            ..line
        };
        lines.push(line);
    }
    if lines.is_empty() {
        return Err(Error::degenerate(
            "to",
            format!("no geodesic within the window in {FINE} directions"),
            "points that one joins, or a longer `longest`",
        ));
    }
    lines.sort_by(|a, b| a.geodesic.length.total_cmp(&b.geodesic.length));
    Ok(lines)
}

/// Directions tried, first and when those find nothing.
const COARSE: usize = 72;
const FINE: usize = 360;

/// Newton's steps of one line at most.
const STEPS: usize = 40;

/// The angle by which a direction is varied to see where its end goes.
const VARIED: f64 = 1e-6;

struct Search<'a> {
    atlas: &'a Atlas,
    chart: Chart,
    state: State<f64>,
    /// Two directions of unit speed at right angles.
    frame: [[f64; 2]; 2],
    target: Vec<f64>,
    longest: f64,
    accuracy: f64,
}

impl Search<'_> {
    /// Angles and lengths of all lines that are found.
    fn all(&self) -> Vec<(f64, f64)> {
        let mut found: Vec<(f64, f64)> = Vec::new();
        for count in [COARSE, FINE] {
            for (angle, length) in self.candidates(count) {
                let Some((angle, length)) = self.brought_there(angle, length) else {
                    continue;
                };
                let near = |a: f64, b: f64| {
                    let turn = (a - b).rem_euclid(TAU);
                    turn.min(TAU - turn) < SAME
                };
                let family = self.is_family(angle, length);
                let known = found.iter().any(|&(a, l)| {
                    (l - length).abs() < SAME * (1.0 + length) && (family || near(a, angle))
                });
                if !known && length <= self.longest {
                    found.push((angle, length));
                }
            }
            if !found.is_empty() {
                break;
            }
        }
        found
    }

    fn velocity(&self, angle: f64) -> [f64; 2] {
        let (c, s) = (libm::cos(angle), libm::sin(angle));
        [0, 1].map(|k| c * self.frame[0][k] + s * self.frame[1][k])
    }

    fn course(&self, angle: f64, length: f64, accuracy: f64, dense: bool) -> Option<Course> {
        let state = State { velocity: self.velocity(angle), ..self.state };
        let tolerance = accuracy / length.max(1.0);
        let request = Request { length, tolerance, slack: accuracy, dense, pause: false };
        trace(self.atlas, self.chart, state, &request).ok()
    }

    /// Where lines in `count` directions come nearest to the target, each time they do.
    fn candidates(&self, count: usize) -> Vec<(f64, f64)> {
        let mut all = Vec::new();
        for k in 0..count {
            let angle = TAU * k as f64 / count as f64;
            let Some(course) = self.course(angle, self.longest, 1e-5, true) else {
                continue;
            };
            let mut places = Vec::new();
            for leg in &course.legs {
                for part in 0..4 {
                    let share = f64::from(part) / 4.0;
                    places.push((
                        leg.from + share * leg.by,
                        self.distance_on(leg.chart, leg.path, share, leg.by),
                    ));
                }
            }
            let end = norm(&plus(&self.end(&course).0, -1.0, &self.target));
            places.push((course.length, end));
            for i in 0..places.len() {
                let (length, distance) = places[i];
                let lower = |j: usize| places.get(j).is_none_or(|place| distance <= place.1);
                // Nearer than neighbours in angle are apart, or so.
                let close = distance <= CLOSE * TAU / count as f64 * length.max(0.1);
                if length > 0.0 && close && lower(i.wrapping_sub(1)) && lower(i + 1) {
                    all.push((angle, length, distance));
                }
            }
        }
        // The nearest first: they find the lines that others then only repeat.
        all.sort_by(|a, b| (a.1 + 4.0 * a.2).total_cmp(&(b.1 + 4.0 * b.2)));
        all.into_iter().map(|(angle, length, _)| (angle, length)).collect()
    }

    fn distance_on(&self, chart: Chart, path: super::step::Path, share: f64, by: f64) -> f64 {
        let [u, v] = path.map(|poles| along(&poles, share, by));
        let (net, place) = match chart {
            Chart::Piece(net) => (net, [u[0], v[0]]),
            Chart::Cap(axis, side) => match self.atlas.cap(axis, side) {
                Some(cap) => cap.place_under([u[0], v[0]], [u[1], v[1]]),
                None => return f64::INFINITY,
            },
        };
        let [point, ..] = self.atlas.nets[net].jet(place);
        norm(&plus(&point, -1.0, &self.target))
    }

    /// The point and the direction where a course ends, in units.
    fn end(&self, course: &Course) -> (Vec<f64>, Vec<f64>) {
        let (_, point, direction) = arrived(self.atlas, course);
        (self.atlas.unplaced(&point), direction)
    }

    /// Newton's steps from a guess to a line that ends in the target.
    fn brought_there(&self, angle: f64, length: f64) -> Option<(f64, f64)> {
        let wanted = 0.1 * self.accuracy;
        let (mut angle, mut length) = (angle, length);
        let mut last = f64::INFINITY;
        let mut damping = 1.0_f64;
        let mut step = [0.0; 2];
        for _ in 0..STEPS {
            let fine = (1e-3 * last).clamp(0.05 * wanted, 1e-6);
            let course = self.course(angle, length, fine, false)?;
            length = course.length;
            let (point, direction) = self.end(&course);
            let miss = plus(&self.target, -1.0, &point);
            let distance = norm(&miss);
            if distance <= wanted {
                return Some((angle, length));
            }
            if distance >= last {
                damping *= 0.5;
                if damping < 1e-3 {
                    return None;
                }
                angle -= step[0] * damping;
                length -= step[1] * damping;
                step = step.map(|x| x * (1.0 - damping));
                continue;
            }
            (last, damping) = (distance, 1.0);
            let beside = self.course(angle + VARIED, length, fine.min(1e-9), false)?;
            let course = self.course(angle, beside.length, fine.min(1e-9), false)?;
            let turned = plus(&self.end(&beside).0, -1.0, &self.end(&course).0);
            let slope: Vec<f64> = turned.iter().map(|x| x / VARIED).collect();
            // Least squares for the two, with a little to hold the angle where it does not matter.
            let (a, b, c) =
                (dot(&slope, &slope) + 1e-14, dot(&slope, &direction), dot(&direction, &direction));
            let (p, q) = (dot(&slope, &miss), dot(&direction, &miss));
            let area = a * c - b * b;
            step = [(c * p - b * q) / area, (a * q - b * p) / area];
            step[0] = step[0].clamp(-0.3, 0.3);
            step[1] = step[1].clamp(-0.5 * length, 0.5 * length);
            if !(step[0].is_finite() && step[1].is_finite()) {
                return None;
            }
            angle += step[0];
            length += step[1];
            if !(length > 0.0 && length < 4.0 * self.longest) {
                return None;
            }
        }
        None
    }

    /// Do neighbouring directions end in the same point?
    fn is_family(&self, angle: f64, length: f64) -> bool {
        let end =
            |angle: f64| self.course(angle, length, 1e-9, false).map(|course| self.end(&course).0);
        match (end(angle), end(angle + 1e-3)) {
            (Some(a), Some(b)) => norm(&plus(&a, -1.0, &b)) < 1e-6,
            _ => false,
        }
    }

    fn line(&self, angle: f64, length: f64) -> Result<Connection> {
        let state = State { velocity: self.velocity(angle), ..self.state };
        let accuracy = (1.0 - DRAWN) * self.accuracy;
        let course = settled(self.atlas, self.chart, state, length, accuracy, true)?;
        let (point, _) = self.end(&course);
        let gap = self.atlas.length(norm(&plus(&point, -1.0, &self.target)));
        let geodesic = finished(self.atlas, &course, accuracy)?;
        let family = self.is_family(angle, length);
        let minimality = if family { Minimality::Family } else { Minimality::Local };
        Ok(Connection { geodesic, gap, minimality })
    }
}

/// How much nearer than its neighbours a line must come to be followed up.
const CLOSE: f64 = 4.0;

/// Angles and lengths that differ by less are the same line.
const SAME: f64 = 1e-6;

fn minimality(line: &Connection, chord: f64, atlas: &Atlas) -> Minimality {
    let Geodesic { length, error, conjugate, .. } = &line.geodesic;
    if *length <= atlas.length(chord) + error + line.gap {
        return Minimality::Proved;
    }
    if line.minimality == Minimality::Family {
        return Minimality::Family;
    }
    match conjugate {
        Some(at) if *at < length * (1.0 - 1e-3) => Minimality::Not,
        Some(_) => Minimality::Family,
        None => Minimality::Local,
    }
}

/// A start in whichever direction there is.
fn anywhere(atlas: &Atlas, from: [f64; 2]) -> Result<(Chart, State<f64>)> {
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
    (0..128).map(|k| norm(&plus(&at(k + 1), -1.0, &at(k)))).sum()
}
