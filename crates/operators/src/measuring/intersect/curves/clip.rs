//! Clipping: what of a curve lies in the band around another.
//!
//! T. W. Sederberg and T. Nishita, *Curve intersection using Bézier clipping*, 1990. The distances
//! of the poles from a line are the coefficients of a polynomial; where the hull of their graph
//! is outside the band, so is the curve.

use super::part::Part;

/// The window of `part`, in shares, outside of which it is farther than `margin` from the hull of
/// `points`; none if all of it is.
pub(super) fn clip<const D: usize, const N: usize>(
    part: &Part<D, N>,
    own: &[[f64; 2]],
    points: &[[f64; 2]],
    margin: f64,
) -> Option<(f64, f64)> {
    let (first, last) = (points[0], points[points.len() - 1]);
    let (mut dx, mut dy) = (last[0] - first[0], last[1] - first[1]);
    let mut length = dx.abs() + dy.abs();
    if length < 1e-280 {
        (dx, dy, length) = (1.0, 0.0, 1.0);
    }
    // Unit in the sum of coordinates, so that a distance is at most the true one.
    (dx, dy) = (dx / length, dy / length);
    let offset = |p: &[f64; 2]| (p[1] - first[1]) * dx - (p[0] - first[0]) * dy;
    let (mut low, mut high) = (0.0_f64, 0.0_f64);
    for point in points {
        let x = offset(point);
        low = if x < low { x } else { low };
        high = if x > high { x } else { high };
    }
    // The offset is less than the distance times 1, and carries some roundings.
    let margin = margin + 8.0 * f64::EPSILON;
    let (low, high) = (low - margin, high + margin);
    let mut above = [0.0; N];
    let mut below = [0.0; N];
    for (i, point) in own.iter().enumerate() {
        let x = offset(point);
        above[i] = (x - low) * part.weight(i);
        below[i] = (high - x) * part.weight(i);
    }
    let (a, b) = positive(&above[..own.len()])?;
    let (c, d) = positive(&below[..own.len()])?;
    let (from, to) = (a.max(c), b.min(d));
    (from <= to).then_some((from, to))
}

/// Slack of a clip: more than what rounding does to it.
const SLACK: f64 = 1e-13;

/// Where the hull of the graph of these coefficients reaches 0 or above.
fn positive(c: &[f64]) -> Option<(f64, f64)> {
    let last = c.len() - 1;
    let from = if c[0] >= 0.0 { 0.0 } else { rise(last, |i| c[i])? - SLACK };
    let to = if c[last] >= 0.0 { 1.0 } else { 1.0 - rise(last, |i| c[last - i])? + SLACK };
    Some((from.max(0.0), to.min(1.0)))
}

/// The least place at which a chord from a negative coefficient goes up to 0.
fn rise(last: usize, c: impl Fn(usize) -> f64) -> Option<f64> {
    let mut least = f64::INFINITY;
    for j in 1..=last {
        let high = c(j);
        if high < 0.0 {
            continue;
        }
        for i in 0..j {
            let low = c(i);
            if low < 0.0 {
                let place = i as f64 + (j - i) as f64 * (low / (low - high));
                least = if place < least { place } else { least };
            }
        }
    }
    (least.is_finite()).then(|| least / last as f64)
}
