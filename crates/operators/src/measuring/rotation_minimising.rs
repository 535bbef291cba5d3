//! Frames that turn about the tangent as little as possible, so they do not flip.
//!
//! Two reflections carry a normal from one point to the next (Wang, Jüttler, Zheng and Liu,
//! *Computation of rotation minimizing frames*, ACM TOG 27, 2008): an error of fourth order over
//! the whole curve. Steps are halved until two answers agree.

use pforms_kernel::{Error, Form, Result};

use super::curve_frame::{CurveFrame, Station};
use super::vector::{any_normal, dot, norm, plus, unit};
use crate::{Located, Spline};

/// Steps that a unit of parameter is cut into at first.
const FIRST_STEPS: f64 = 16.0;

/// Steps after which an accuracy is out of reach: rounding has taken over. Those that the parameters
/// themselves ask for are not counted.
const MOST_STEPS: usize = 1 << 16;

/// How far from 0 a frame is carried: as far as the first steps can go.
const REACH: f64 = MOST_STEPS as f64 / FIRST_STEPS;

/// One frame for each parameter, the normals within `accuracy` radians.
pub(crate) fn rotation_minimising(
    curve: &Form,
    parameters: &[f64],
    accuracy: f64,
) -> Result<Vec<CurveFrame>> {
    let stops: Vec<Stop> = parameters.iter().map(|&t| Stop { piece: 0, t }).collect();
    along_chain(std::slice::from_ref(curve), &stops, accuracy)
}

/// The same for a spline, carried from the beginning of its window.
pub(crate) fn along_pieces(
    spline: &Spline,
    parameters: &[f64],
    accuracy: f64,
) -> Result<Vec<CurveFrame>> {
    let places = parameters.iter().map(|&t| spline.locate(&[t])).collect::<Result<Vec<_>>>()?;
    let stop = |place: &Located| Stop { piece: place.index[0], t: place.parameters[0] };
    let stops: Vec<Stop> = places.iter().map(stop).collect();
    let frames = along_chain(&spline.pieces()?, &stops, accuracy)?.into_iter();
    let known = frames.zip(parameters).zip(&places);
    Ok(known
        .map(|((frame, &t), place)| CurveFrame { parameter: t, ..frame.slowed(place.lengths[0]) })
        .collect())
}

/// A parameter of one of the curves that make a chain.
#[derive(Clone, Copy)]
struct Stop {
    piece: usize,
    t: f64,
}

fn along_chain(chain: &[Form], stops: &[Stop], accuracy: f64) -> Result<Vec<CurveFrame>> {
    if accuracy.is_nan() || accuracy <= 0.0 {
        return Err(Error::domain("accuracy", accuracy, "a positive angle"));
    }
    if let Some(far) = stops.iter().find(|stop| stop.t.abs() > REACH) {
        let expected = format!("parameters between {} and {REACH}, carried from 0", -REACH);
        return Err(Error::domain("parameters", far.t, expected));
    }
    let stations: Vec<Station> =
        stops.iter().map(|stop| Station::new(&chain[stop.piece], stop.t)).collect::<Result<_>>()?;
    let walk = Walk::new(chain, stops)?;
    let mut normals = walk.normals(1)?;
    let mut cuts = 1;
    loop {
        cuts *= 2;
        let finer = walk.normals(cuts)?;
        let pairs = normals.iter().zip(&finer);
        let change = pairs.map(|(a, b)| norm(&plus(a, -1.0, b))).fold(0.0, f64::max);
        normals = finer;
        // Halving divides the error by 16, so what is left is 1/15 of the change.
        if change <= 8.0 * accuracy {
            break;
        }
        if walk.steps(cuts) > MOST_STEPS + walk.steps(1) {
            return Err(Error::accuracy("accuracy", accuracy, format!("about {change:e}")));
        }
    }
    Ok(stations.iter().zip(normals).map(|(station, normal)| station.frame_with(normal)).collect())
}

/// The way from the beginning through all stops, upwards and downwards.
struct Walk<'a> {
    chain: &'a [Form],
    count: usize,
    start: Vec<f64>,
    /// First steps in a unit of parameter: no longer than the longest leg.
    pace: f64,
    sides: [Vec<Leg>; 2],
}

/// A part of the way on one curve.
struct Leg {
    piece: usize,
    from: f64,
    to: f64,
    /// The number of the stop at its end, if there is one.
    stop: Option<usize>,
}

impl<'a> Walk<'a> {
    fn new(chain: &'a [Form], stops: &[Stop]) -> Result<Self> {
        let origin = Station::new(&chain[0], 0.0)?;
        let start = origin.principal_normal().unwrap_or_else(|| any_normal(&origin.tangent));
        let downwards = |stop: &Stop| stop.piece == 0 && stop.t < 0.0;
        let side = |down: bool| {
            let mut order: Vec<usize> =
                (0..stops.len()).filter(|&i| downwards(&stops[i]) == down).collect();
            let reach = |i: usize| (stops[i].piece, stops[i].t.abs());
            order.sort_by(|&i, &j| {
                let ((a, s), (b, t)) = (reach(i), reach(j));
                a.cmp(&b).then(s.total_cmp(&t))
            });
            legs(&order, stops)
        };
        let sides = [side(false), side(true)];
        let legs = sides.iter().flatten();
        let longest = legs.map(|leg| (leg.to - leg.from).abs()).fold(0.0, f64::max);
        let pace = (1.0 / longest).clamp(FIRST_STEPS, MOST_STEPS as f64);
        Ok(Self { chain, count: stops.len(), start, pace, sides })
    }

    fn steps(&self, cuts: usize) -> usize {
        self.sides.iter().flatten().map(|leg| leg.steps(self.pace, cuts)).sum()
    }

    /// The normal at every stop, in steps `cuts` times shorter than the first.
    fn normals(&self, cuts: usize) -> Result<Vec<Vec<f64>>> {
        let mut normals = vec![Vec::new(); self.count];
        for side in &self.sides {
            let mut here = Place::new(&self.chain[0], 0.0)?;
            let (mut piece, mut normal) = (0, self.start.clone());
            for leg in side {
                let curve = &self.chain[leg.piece];
                if leg.piece != piece {
                    let next = Place::new(curve, leg.from)?;
                    normal = turned(&here, &next, &normal, &here.tangent);
                    (here, piece) = (next, leg.piece);
                }
                let steps = leg.steps(self.pace, cuts);
                for step in 1..=steps {
                    let t = leg.from + (leg.to - leg.from) * (step as f64 / steps as f64);
                    let next = Place::new(curve, if step == steps { leg.to } else { t })?;
                    let chord = plus(&next.point, -1.0, &here.point);
                    normal = turned(&here, &next, &normal, &chord);
                    here = next;
                }
                if let Some(stop) = leg.stop {
                    normals[stop].clone_from(&normal);
                }
            }
        }
        Ok(normals)
    }
}

/// The way through stops in this order, over every end of a curve on it.
fn legs(order: &[usize], stops: &[Stop]) -> Vec<Leg> {
    let mut legs = Vec::with_capacity(order.len());
    let mut here = Stop { piece: 0, t: 0.0 };
    for &i in order {
        while here.piece < stops[i].piece {
            legs.push(Leg { piece: here.piece, from: here.t, to: 1.0, stop: None });
            here = Stop { piece: here.piece + 1, t: 0.0 };
        }
        legs.push(Leg { piece: here.piece, from: here.t, to: stops[i].t, stop: Some(i) });
        here = stops[i];
    }
    legs
}

impl Leg {
    /// Steps when the first are cut so often. Those legs that a first step about covers set the
    /// error: their steps are exactly halved by twice the cuts, which is what the estimate asks.
    fn steps(&self, pace: f64, cuts: usize) -> usize {
        let first = (self.to - self.from).abs() * pace;
        if first >= 0.5 {
            return first.ceil() as usize * cuts;
        }
        (first * cuts as f64).ceil() as usize
    }
}

/// A point of the curve and its unit tangent.
struct Place {
    point: Vec<f64>,
    tangent: Vec<f64>,
}

impl Place {
    fn new(curve: &Form, t: f64) -> Result<Self> {
        let station = Station::new(curve, t)?;
        Ok(Self { point: station.point, tangent: station.tangent })
    }
}

/// The double reflection: across the plane between the points, then the one between the tangents.
///
/// Where the chain turns a corner there is no chord, and the tangent stands for it: the shortest
/// turn from tangent to tangent.
fn turned(here: &Place, next: &Place, normal: &[f64], chord: &[f64]) -> Vec<f64> {
    let normal = reflected(normal, chord);
    let tangent = reflected(&here.tangent, chord);
    let normal = reflected(&normal, &plus(&next.tangent, -1.0, &tangent));
    // Against the drift of rounding: across the tangent again, of length 1.
    unit(&plus(&normal, -dot(&normal, &next.tangent), &next.tangent))
}

/// The mirror image in the plane across `axis`; unchanged when there is no axis.
fn reflected(vector: &[f64], axis: &[f64]) -> Vec<f64> {
    let square = dot(axis, axis);
    if square == 0.0 {
        return vector.to_vec();
    }
    plus(vector, -2.0 * dot(axis, vector) / square, axis)
}
