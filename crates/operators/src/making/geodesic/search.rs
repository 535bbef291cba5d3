//! Looks for the straight lines that join two points.
//!
//! The direction of the chord is tried first, then, coarsely, directions all around the start; where a line passes near
//! the end, Newton's steps on the angle and the length bring it there. Every line found is followed again with a bound
//! of its error.

use std::f64::consts::{PI, TAU};

use pforms_kernel::{Error, Result};

use super::atlas::Atlas;
use super::between::{Connection, Minimality};
use super::step::{State, along};
use super::trace::{Chart, Course, Leg, Request, trace};
use super::{DRAWN, finished, seen, settled};
use crate::measuring::vector::{dot, norm, plus};

/// Directions tried, first and when those find nothing.
const COARSE: usize = 72;
const FINE: usize = 360;

/// Lines followed up at most, and found.
const GUESSES: usize = 2000;
const LINES: usize = 64;

/// How much nearer than its neighbours a line must come to be followed up.
const CLOSE: f64 = 4.0;

/// Angles and lengths that differ by less are the same line.
const SAME: f64 = 1e-6;

pub(super) struct Search<'a> {
    pub atlas: &'a Atlas,
    pub chart: Chart,
    pub state: State<f64>,
    /// Two directions of unit speed at right angles.
    pub frame: [[f64; 2]; 2],
    /// In units, as the target.
    pub start: Vec<f64>,
    pub target: Vec<f64>,
    pub longest: f64,
    pub accuracy: f64,
    /// Are all lines wanted, or the shortest?
    pub all: bool,
}

/// A line that comes near the target after a length.
#[derive(Clone, Copy)]
struct Guess {
    angle: f64,
    length: f64,
    /// How far aside it passes.
    aside: f64,
}

/// A line that ends in the target.
struct Found {
    angle: f64,
    length: f64,
    /// How far its neighbours part, for an angle.
    parting: f64,
    connection: Connection,
}

impl Search<'_> {
    pub(super) fn lines(&self) -> Result<Vec<Connection>> {
        let mut found = Vec::new();
        let mut failure = None;
        let mut try_one =
            |guess: Guess, found: &mut Vec<Found>| match self.followed(guess, found).transpose() {
                Some(Ok(line)) => found.push(line),
                Some(Err(error)) => failure = Some(error),
                None => {}
            };
        if let Some(guess) = self.direct() {
            try_one(guess, &mut found);
        }
        for count in [COARSE, FINE] {
            if !self.all && found.iter().any(Found::is_straight) {
                break;
            }
            for guess in self.guesses(count, self.limit(&found)) {
                let hopeless = guess.length - 2.0 * guess.aside > self.limit(&found);
                if hopeless || found.len() >= LINES || found.iter().any(|one| one.tells(guess)) {
                    continue;
                }
                try_one(guess, &mut found);
            }
            if !found.is_empty() {
                break;
            }
        }
        if found.is_empty() {
            let none = || {
                Error::degenerate(
                    "to",
                    format!("no geodesic within the window in {FINE} directions"),
                    "points that one joins, or a longer `longest`; the shortest way may run along the border",
                )
            };
            return Err(failure.unwrap_or_else(none));
        }
        Ok(found.into_iter().map(|line| line.connection).collect())
    }

    /// How long lines may be that are still of interest.
    fn limit(&self, found: &[Found]) -> f64 {
        let shortest = found.iter().fold(self.longest, |most, line| most.min(line.length));
        if self.all { self.longest } else { shortest }
    }

    /// The line that sets out along the chord.
    fn direct(&self) -> Option<Guess> {
        let chord = plus(&self.target, -1.0, &self.start);
        let [a, b] = self.frame.map(|velocity| {
            let (.., direction) = seen(self.atlas, self.chart, State { velocity, ..self.state });
            dot(&chord, &direction)
        });
        let length = norm(&chord);
        let lies = a.hypot(b) > 1e-3 * length && length <= self.longest;
        lies.then(|| Guess { angle: libm::atan2(b, a), length, aside: 0.0 })
    }

    fn velocity(&self, angle: f64) -> [f64; 2] {
        let (c, s) = (libm::cos(angle), libm::sin(angle));
        [0, 1].map(|k| c * self.frame[0][k] + s * self.frame[1][k])
    }

    fn course(&self, angle: f64, length: f64, accuracy: f64, dense: bool) -> Option<Course> {
        let state = State { velocity: self.velocity(angle), ..self.state };
        let tolerance = accuracy / length.max(1.0);
        let request =
            Request { length, tolerance, slack: accuracy, dense, sure: false, pause: false };
        trace(self.atlas, self.chart, state, &request).ok()
    }

    /// Where lines in `count` directions come near the target, the shortest first.
    fn guesses(&self, count: usize, longest: f64) -> Vec<Guess> {
        let mut guesses = Vec::new();
        for k in 0..count {
            let angle = TAU * k as f64 / count as f64;
            let Some(course) = self.course(angle, longest, 1e-5, true) else {
                continue;
            };
            let mut places: Vec<(f64, f64, f64)> = Vec::with_capacity(4 * course.legs.len() + 1);
            for leg in &course.legs {
                places.extend((0..4).map(|part| self.sighted(leg, f64::from(part) / 4.0)));
            }
            places.extend(course.legs.last().map(|leg| self.sighted(leg, 1.0)));
            for i in 0..places.len() {
                let (length, distance, ahead) = places[i];
                let lower = |j: usize| places.get(j).is_none_or(|place| distance <= place.1);
                if !(lower(i.wrapping_sub(1)) && lower(i + 1)) {
                    continue;
                }
                let aside = (distance * distance - ahead * ahead).max(0.0).sqrt();
                let length = length + ahead.clamp(-0.5 * distance, 0.5 * distance);
                // Nearer than neighbours in angle are apart, or so.
                if length > 0.0 && distance <= CLOSE * TAU / count as f64 * length.max(0.1) {
                    guesses.push(Guess { angle, length, aside });
                }
            }
        }
        // Those first that find the lines which others then only repeat.
        let rank = |guess: &Guess| guess.length + 4.0 * guess.aside;
        guesses.sort_by(|a, b| rank(a).total_cmp(&rank(b)));
        guesses.truncate(GUESSES);
        guesses
    }

    /// Length, distance of the target, and how much of that lies ahead.
    fn sighted(&self, leg: &Leg, share: f64) -> (f64, f64, f64) {
        let [u, v] = leg.path.map(|poles| along(&poles, share, leg.by));
        let state = State { place: [u[0], v[0]], velocity: [u[1], v[1]] };
        let (_, point, direction) = seen(self.atlas, leg.chart, state);
        let way = plus(&self.target, -1.0, &point);
        (leg.from + share * leg.by, norm(&way), dot(&way, &direction))
    }

    /// The point and the direction where a course ends, in units.
    fn end(&self, course: &Course) -> (Vec<f64>, Vec<f64>) {
        let (_, point, direction) = seen(self.atlas, course.chart, course.state);
        (point, direction)
    }

    /// The line that a guess leads to, unless it is known or too long.
    fn followed(&self, guess: Guess, found: &[Found]) -> Result<Option<Found>> {
        let Some((angle, length)) = self.brought_there(guess) else {
            return Ok(None);
        };
        let same = |line: &Found| {
            (line.length - length).abs() < SAME * (1.0 + length)
                && (line.is_family() || apart(line.angle, angle) < SAME)
        };
        if length > self.limit(found) + self.accuracy || found.iter().any(same) {
            return Ok(None);
        }
        self.line(angle, length).map(Some)
    }

    fn line(&self, angle: f64, length: f64) -> Result<Found> {
        let state = State { velocity: self.velocity(angle), ..self.state };
        let accuracy = (1.0 - DRAWN) * self.accuracy;
        let course = settled(self.atlas, self.chart, state, length, accuracy, true)?;
        let (point, _) = self.end(&course);
        let gap = norm(&plus(&point, -1.0, &self.target));
        if gap > self.accuracy {
            let allowed = format!("one that rounding allows: a line ends {gap:.0e} away");
            return Err(Error::accuracy("accuracy", self.accuracy, allowed));
        }
        let chord = norm(&plus(&self.target, -1.0, &self.start));
        let parting = course.growth.field[0];
        let minimality = if course.length <= chord + course.growth.error() + gap {
            Minimality::Proved
        } else {
            self.minimality(angle, &course)
        };
        let geodesic = finished(self.atlas, &course, accuracy)?;
        let gap = self.atlas.length(gap) + self.atlas.grain();
        let connection = Connection { geodesic, gap, minimality };
        Ok(Found { angle, length, parting, connection })
    }

    /// What conjugate points say.
    fn minimality(&self, angle: f64, course: &Course) -> Minimality {
        let growth = &course.growth;
        let unclear = UNCLEAR * (1.0 + course.length);
        match growth.conjugate {
            Some(at) if at < course.length * (1.0 - VARIED) - unclear => Minimality::Not,
            _ if growth.field[0].abs() < VARIED && self.is_family(angle, course.length) => {
                Minimality::Family
            }
            Some(at) if at < course.length - unclear => Minimality::Not,
            None if growth.field[0].abs() > unclear => Minimality::Local,
            _ => Minimality::Family,
        }
    }

    /// Do directions beside it end in the same point?
    fn is_family(&self, angle: f64, length: f64) -> bool {
        let fine = 0.1 * self.accuracy;
        let end = |angle| self.course(angle, length, fine, false).map(|one| self.end(&one).0);
        match (end(angle), end(angle + VARIED)) {
            (Some(a), Some(b)) => norm(&plus(&a, -1.0, &b)) <= self.accuracy,
            _ => false,
        }
    }

    /// Newton's steps from a guess to a line that ends in the target.
    fn brought_there(&self, guess: Guess) -> Option<(f64, f64)> {
        let wanted = 0.1 * self.accuracy;
        let Guess { mut angle, mut length, .. } = guess;
        let mut last = f64::INFINITY;
        let mut damping = 1.0_f64;
        let mut step = [0.0; 2];
        let mut slope: Option<Vec<f64>> = None;
        let mut finest = false;
        for _ in 0..STEPS {
            let finer = if finest { 0.0 } else { 1e-3 * last };
            let fine = finer.clamp(0.05 * wanted, 1e-6);
            let course = self.course(angle, length, fine, false)?;
            length = course.length;
            let (point, direction) = self.end(&course);
            let miss = plus(&self.target, -1.0, &point);
            let distance = norm(&miss);
            if distance <= wanted {
                // Only a line that is followed finely counts.
                if fine <= wanted {
                    return Some((angle, length));
                }
                (finest, last) = (true, f64::INFINITY);
                continue;
            }
            if distance >= last {
                damping *= 0.5;
                if damping < 1e-3 {
                    return None;
                }
                angle -= step[0] * damping;
                length -= step[1] * damping;
                step = step.map(|x| x * (1.0 - damping));
                slope = None;
                continue;
            }
            // A slope that serves well is kept.
            let known = slope.take().filter(|_| distance <= 0.1 * last);
            let across = match known {
                Some(known) => known,
                None => self.slope(angle, &course, fine, &point, &direction)?,
            };
            (last, damping) = (distance, 1.0);
            step = newton(&across, &direction, &miss)?;
            slope = Some(across);
            step[0] = step[0].clamp(-0.3, 0.3);
            step[1] = step[1].clamp(-0.5 * length, 0.5 * length.max(distance));
            angle += step[0];
            length += step[1];
            if !(length > 0.0 && length < 4.0 * self.longest) {
                return None;
            }
        }
        None
    }

    /// Where the end of a course goes with its angle.
    fn slope(
        &self,
        angle: f64,
        course: &Course,
        fine: f64,
        point: &[f64],
        direction: &[f64],
    ) -> Option<Vec<f64>> {
        let by = (100.0 * fine).clamp(1e-6, 1e-4);
        let beside = self.course(angle + by, course.length, fine, false)?;
        // One of them may have come to a side sooner.
        let moved = plus(&self.end(&beside).0, -1.0, point);
        let moved = plus(&moved, course.length - beside.length, direction);
        Some(moved.into_iter().map(|x| x / by).collect())
    }
}

/// Newton's steps of one line at most.
const STEPS: usize = 40;

/// The angle by which a direction is varied to see whether there is a family.
const VARIED: f64 = 1e-3;

/// How well the place of a conjugate point is known.
const UNCLEAR: f64 = 2e-6;

impl Found {
    fn is_straight(&self) -> bool {
        self.connection.minimality == Minimality::Proved
    }

    fn is_family(&self) -> bool {
        self.connection.minimality == Minimality::Family
    }

    /// Would a guess only lead to this line again?
    fn tells(&self, guess: Guess) -> bool {
        let near = (guess.length - self.length).abs() <= 0.05 * self.length + guess.aside;
        let turn = apart(guess.angle, self.angle);
        let expected = self.parting.abs() * turn;
        let little = 1e-4 * self.length;
        near && if self.is_family() {
            guess.aside <= expected.max(little)
        } else {
            turn < 0.2 && (guess.aside - expected).abs() <= 0.2 * expected + little
        }
    }
}

/// The angle between two.
fn apart(a: f64, b: f64) -> f64 {
    let turn = (a - b).rem_euclid(TAU);
    if turn > PI { TAU - turn } else { turn }
}

/// Least squares for a turn and a length, with a little to hold the angle where it does not matter.
fn newton(slope: &[f64], direction: &[f64], miss: &[f64]) -> Option<[f64; 2]> {
    let (a, b) = (dot(slope, slope) + 1e-14, dot(slope, direction));
    let c = dot(direction, direction);
    let (p, q) = (dot(slope, miss), dot(direction, miss));
    let area = a * c - b * b;
    let step = [(c * p - b * q) / area, (a * q - b * p) / area];
    step.iter().all(|x| x.is_finite()).then_some(step)
}
