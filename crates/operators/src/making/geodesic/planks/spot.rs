//! What a line on a surface is like at one place: Darboux's frame, and how the surface bends there.

use super::super::metric::Net;
use crate::measuring::vector::{cross, dot, norm, scaled, unit};

/// A place of a line: its point always, the frame where the surface has a tangent plane.
#[derive(Clone, Debug)]
pub(super) struct Spot {
    pub point: Vec<f64>,
    pub frame: Option<Frame>,
}

/// Darboux's frame of a line on a surface, and the second fundamental form in it.
#[derive(Clone, Debug)]
pub(super) struct Frame {
    pub tangent: Vec<f64>,
    /// To the left of the line in the tangent plane: `N × T`.
    pub across: Vec<f64>,
    pub normal: Vec<f64>,
    /// Normal curvature `II(T, T)`.
    pub bend: f64,
    /// `II(T, B)`: the geodesic torsion, up to its sign.
    pub twist: f64,
}

/// Areas below this share of `|f_u|·|f_v|` belong to no tangent plane.
const THIN: f64 = 1e-12;

/// The spot at a place of a piece that is passed with a velocity; `sign` turns the normal, and there is no
/// frame where `|f_u × f_v|` is not above `floor`.
pub(super) fn spot(net: &Net, place: [f64; 2], velocity: [f64; 2], sign: f64, floor: f64) -> Spot {
    let [point, u, v, uu, uv, vv] = net.jet(place);
    let normal = cross(&u, &v);
    let area = norm(&normal);
    let course: Vec<f64> =
        u.iter().zip(&v).map(|(u, v)| u * velocity[0] + v * velocity[1]).collect();
    let speed = norm(&course);
    // Written so that NaN has no frame.
    let stands = area > floor.max(THIN * norm(&u) * norm(&v)) && speed > 0.0 && speed.is_finite();
    if !stands {
        return Spot { point, frame: None };
    }
    let normal = scaled(&normal, sign / area);
    let tangent = unit(&course);
    let across = cross(&normal, &tangent).to_vec();
    let second = [&uu, &uv, &vv].map(|bent| dot(&normal, bent));
    let along = velocity.map(|x| x / speed);
    let aside = raised(&u, &v, &across);
    let both = |a: [f64; 2], b: [f64; 2]| {
        second[0] * a[0] * b[0] + second[1] * (a[0] * b[1] + a[1] * b[0]) + second[2] * a[1] * b[1]
    };
    let (bend, twist) = (both(along, along), both(along, aside));
    Spot { point, frame: Some(Frame { tangent, across, normal, bend, twist }) }
}

/// The speeds in the parameters that give a vector of the tangent plane.
fn raised(u: &[f64], v: &[f64], vector: &[f64]) -> [f64; 2] {
    let (e, f, g) = (dot(u, u), dot(u, v), dot(v, v));
    let (a, b) = (dot(u, vector), dot(v, vector));
    let area = e * g - f * f;
    [(g * a - f * b) / area, (e * b - f * a) / area]
}

impl Frame {
    /// How far the ruling of the plank goes along the line for each length across it: the ruling is conjugate
    /// to the line, `II(T, B + slope·T) = 0`.
    pub(super) fn slope(&self) -> f64 {
        -self.twist / self.bend
    }
}
