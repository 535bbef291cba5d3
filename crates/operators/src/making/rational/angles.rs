//! Directions of angles, exact where a twenty-fourth of a turn is.

use std::f64::consts::{FRAC_1_SQRT_2, PI};

/// Cosines of 0, 15, … 90 degrees.
const COSINES: [f64; 7] = [
    1.0,
    0.965_925_826_289_068_3,
    0.866_025_403_784_438_6,
    FRAC_1_SQRT_2,
    0.5,
    0.258_819_045_102_520_76,
    0.0,
];

/// Cosine and sine of an angle in radians.
///
/// An angle of at most a turn and within a rounding of a multiple of 15 degrees is taken for it: `π/2`
/// in `f64` then has the cosine 0, and arcs that meet there share their poles to the bit.
pub(super) fn direction(angle: f64) -> [f64; 2] {
    named(angle).unwrap_or_else(|| [libm::cos(angle), libm::sin(angle)])
}

/// Cosine and sine of `start + count·step`, as if that were not rounded: neighbours on an arc are
/// then equally far apart however large the angles are.
pub(super) fn direction_after(start: f64, step: f64, count: usize) -> [f64; 2] {
    let times = count as f64;
    let turned = times * step;
    let rest = times.mul_add(step, -turned);
    let sum = start + turned;
    let back = sum - start;
    let lost = (start - (sum - back)) + (turned - back) + rest;
    named(sum).unwrap_or_else(|| {
        let (cosine, sine) = (libm::cos(sum), libm::sin(sum));
        [cosine - lost * sine, sine + lost * cosine]
    })
}

fn named(angle: f64) -> Option<[f64; 2]> {
    let count = angle / (PI / 12.0);
    let nearest = libm::round(count);
    let near = (count - nearest).abs() <= 2.0 * f64::EPSILON * count.abs();
    (near && nearest.abs() <= 24.0).then(|| [nearest as i64, nearest as i64 - 6].map(cosine))
}

/// Cosine of `steps` times 15 degrees.
fn cosine(steps: i64) -> f64 {
    let around = steps.rem_euclid(24);
    let up = around.min(24 - around);
    if up > 6 { -COSINES[(12 - up) as usize] } else { COSINES[up as usize] }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn named_angles_are_exact() {
        assert_eq!(direction(PI / 2.0), [0.0, 1.0]);
        assert_eq!(direction(-PI), [-1.0, 0.0]);
        assert_eq!(direction(7.0 * PI / 4.0), [FRAC_1_SQRT_2, -FRAC_1_SQRT_2]);
        assert_eq!(direction(PI / 3.0)[0], 0.5);
    }

    #[test]
    fn all_others_are_those_of_the_library() {
        for i in 0..1000 {
            let angle = f64::from(i) * 0.017 - 8.0;
            let [x, y] = direction(angle);
            // A named angle moves by at most so much.
            let bound = 2.0 * f64::EPSILON * angle.abs().max(1.0);
            assert!((x - libm::cos(angle)).abs() <= bound && (y - libm::sin(angle)).abs() <= bound);
        }
    }
}
