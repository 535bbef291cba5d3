//! Frames that turn about the tangent as little as possible, so they do not flip.
//!
//! Two reflections carry a normal from one point to the next (Wang, Jüttler, Zheng and Liu,
//! *Computation of rotation minimizing frames*, ACM TOG 27, 2008): an error of fourth order over
//! the whole curve. Steps are halved until two answers agree.

use pforms_kernel::{Error, Form, Result};

use super::curve_frame::{CurveFrame, Station};
use super::vector::{dot, norm, plus, unit};

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
    if accuracy.is_nan() || accuracy <= 0.0 {
        return Err(Error::domain("accuracy", accuracy, "a positive angle"));
    }
    if let Some(far) = parameters.iter().find(|t| t.abs() > REACH) {
        let expected = format!("parameters between {} and {REACH}, carried from 0", -REACH);
        return Err(Error::domain("parameters", far, expected));
    }
    let stations: Vec<Station> =
        parameters.iter().map(|t| Station::new(curve, *t)).collect::<Result<_>>()?;
    let walk = Walk::new(curve, parameters)?;
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
        if walk.steps(cuts) > MOST_STEPS + parameters.len() {
            return Err(Error::accuracy("accuracy", accuracy, format!("about {change:e}")));
        }
    }
    Ok(stations.iter().zip(normals).map(|(station, normal)| station.frame_with(normal)).collect())
}

/// The way from `u = 0` through all parameters, upwards and downwards.
struct Walk<'a> {
    curve: &'a Form,
    parameters: &'a [f64],
    start: Vec<f64>,
    /// Positions in `parameters`, by increasing distance from 0, for either side.
    sides: [Vec<usize>; 2],
}

impl<'a> Walk<'a> {
    fn new(curve: &'a Form, parameters: &'a [f64]) -> Result<Self> {
        let origin = Station::new(curve, 0.0)?;
        let start = origin.principal_normal().unwrap_or_else(|| any_normal(&origin.tangent));
        let side = |sign: f64| {
            let mut order: Vec<usize> =
                (0..parameters.len()).filter(|&i| parameters[i] * sign >= 0.0).collect();
            order.sort_by(|&i, &j| parameters[i].abs().total_cmp(&parameters[j].abs()));
            order
        };
        Ok(Self { curve, parameters, start, sides: [side(1.0), side(-1.0)] })
    }

    fn steps(&self, cuts: usize) -> usize {
        let gaps = |side: &Vec<usize>| {
            let mut here = 0.0;
            let steps = side.iter().map(|&i| {
                let there = self.parameters[i];
                let steps = steps_between(here, there, cuts);
                here = there;
                steps
            });
            steps.sum::<usize>()
        };
        self.sides.iter().map(gaps).sum()
    }

    /// The normal at every parameter, in steps `cuts` times shorter than the first.
    fn normals(&self, cuts: usize) -> Result<Vec<Vec<f64>>> {
        let mut normals = vec![Vec::new(); self.parameters.len()];
        for side in &self.sides {
            let mut here = Place::new(self.curve, 0.0)?;
            let (mut from, mut normal) = (0.0, self.start.clone());
            for &i in side {
                let to = self.parameters[i];
                let steps = steps_between(from, to, cuts);
                for step in 1..=steps {
                    let t = from + (to - from) * (step as f64 / steps as f64);
                    let next = Place::new(self.curve, if step == steps { to } else { t })?;
                    normal = carried(&here, &next, &normal);
                    here = next;
                }
                from = to;
                normals[i].clone_from(&normal);
            }
        }
        Ok(normals)
    }
}

fn steps_between(from: f64, to: f64, cuts: usize) -> usize {
    ((to - from).abs() * FIRST_STEPS * cuts as f64).ceil() as usize
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
fn carried(here: &Place, next: &Place, normal: &[f64]) -> Vec<f64> {
    let chord = plus(&next.point, -1.0, &here.point);
    let normal = reflected(normal, &chord);
    let tangent = reflected(&here.tangent, &chord);
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

/// A unit vector across the tangent: from the coordinate axis it leans on least.
fn any_normal(tangent: &[f64]) -> Vec<f64> {
    let least = (0..tangent.len())
        .min_by(|&i, &j| tangent[i].abs().total_cmp(&tangent[j].abs()))
        .unwrap_or(0);
    let mut axis = vec![0.0; tangent.len()];
    axis[least] = 1.0;
    unit(&plus(&axis, -dot(&axis, tangent), tangent))
}
