//! One line of a surface laid out in the plane.

use super::quadrature::Quadrature;
use crate::measuring::vector::{cross, dot, norm};

/// A point of the surface, with what unrolling asks of it.
#[derive(Clone, Debug)]
pub(super) struct Spot {
    /// `f_u` and `f_v`.
    pub first: [[f64; 3]; 2],
    /// `f_uu` and `f_vv`.
    pub second: [[f64; 3]; 2],
    pub normal: [f64; 3],
}

impl Spot {
    /// How fast the line along `axis` turns to its left on the surface, by its parameter.
    fn turning(&self, axis: usize) -> f64 {
        let (along, bend) = (&self.first[axis], &self.second[axis]);
        let turning = dot(&self.normal, &cross(along, bend));
        let square = dot(along, along);
        // Straight, or standing still.
        if turning.abs() <= 1e-14 * norm(along) * norm(bend) { 0.0 } else { turning / square }
    }

    /// The angle on the surface from its line along `axis` to the other.
    pub(super) fn angle(&self, axis: usize) -> f64 {
        let (along, other) = (&self.first[axis], &self.first[1 - axis]);
        libm::atan2(dot(&self.normal, &cross(along, other)), dot(along, other))
    }
}

/// A place in the plane, and a direction there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pose {
    pub point: [f64; 2],
    pub angle: f64,
}

/// The poses at all nodes of an interval, from one of them on.
/// A line collapsed to a point stays one.
pub(super) fn laid_out(
    spots: &[&Spot],
    axis: usize,
    start: Pose,
    from: usize,
    quadrature: &Quadrature,
) -> Vec<Pose> {
    let turning: Vec<f64> = spots.iter().map(|spot| spot.turning(axis)).collect();
    let speed: Vec<f64> = spots.iter().map(|spot| norm(&spot.first[axis])).collect();
    let angles = quadrature.integrals(&turning, from);
    let angles: Vec<f64> = angles.iter().map(|angle| start.angle + angle).collect();
    let steps = |f: fn(f64) -> f64| -> Vec<f64> {
        let pairs = speed.iter().zip(&angles);
        quadrature
            .integrals(&pairs.map(|(speed, angle)| speed * f(*angle)).collect::<Vec<_>>(), from)
    };
    let (x, y) = (steps(libm::cos), steps(libm::sin));
    let pose =
        |i: usize| Pose { point: [start.point[0] + x[i], start.point[1] + y[i]], angle: angles[i] };
    (0..spots.len()).map(pose).collect()
}
