//! Where two curves come nearest, from a start: steps of Gauss and Newton on the square distance.

use pforms_kernel::Form;

use crate::measuring::vector::{dot, norm};

/// A pair of places, and how far they are apart.
#[derive(Clone, Copy, Debug)]
pub(super) struct Near {
    pub s: f64,
    pub t: f64,
    /// The distance.
    pub gap: f64,
    /// The sine of the angle between the tangents; 0 where there is none.
    pub sine: f64,
}

/// Steps at most; two or three from a good start, more towards tangents.
const STEPS: usize = 60;

/// The point of a curve and its first derivative.
pub(super) fn jet(form: &Form, t: f64) -> (Vec<f64>, Vec<f64>) {
    let (width, order) = (form.width(), form.orders()[0]);
    let mut p = form.homogeneous().to_vec();
    for step in 1..order.saturating_sub(1) {
        for i in 0..(order - step) * width {
            p[i] = (1.0 - t) * p[i] + t * p[i + width];
        }
    }
    let mut value = p[..width].to_vec();
    let mut slope = vec![0.0; width];
    if order > 1 {
        for k in 0..width {
            value[k] = (1.0 - t) * p[k] + t * p[k + width];
            slope[k] = (order - 1) as f64 * (p[k + width] - p[k]);
        }
    }
    let (weight, change) = (value[width - 1], slope[width - 1]);
    let point: Vec<f64> = value[..width - 1].iter().map(|x| x / weight).collect();
    let derivative = slope.iter().zip(&point).map(|(d, x)| (d - x * change) / weight).collect();
    (point, derivative)
}

/// Descends within a window.
pub(super) fn closest(a: &Form, b: &Form, start: [f64; 2], window: &[[f64; 2]; 2]) -> Near {
    let [mut s, mut t] = start;
    let mut near = at(a, b, s, t);
    let mut damping = 0.0;
    for _ in 0..STEPS {
        let ((p, u), (q, v)) = (jet(a, s), jet(b, t));
        let offset: Vec<f64> = p.iter().zip(&q).map(|(x, y)| x - y).collect();
        let (uu, uv, vv) = (dot(&u, &u), dot(&u, &v), dot(&v, &v));
        let (gs, gt) = (dot(&offset, &u), -dot(&offset, &v));
        // At an end where the distance falls outwards only the other parameter moves.
        let held = |x: f64, g: f64, w: &[f64; 2]| (x <= w[0] && g > 0.0) || (x >= w[1] && g < 0.0);
        let (hold_s, hold_t) = (held(s, gs, &window[0]), held(t, gt, &window[1]));
        let grown = 1.0 + damping;
        let det = uu * vv * grown * grown - uv * uv;
        let (ds, dt) = match (hold_s, hold_t) {
            (true, true) => break,
            (true, false) => (0.0, -gt / (vv * grown)),
            (false, true) => (-gs / (uu * grown), 0.0),
            (false, false) if det > 1e-14 * uu * vv => {
                ((-gs * vv * grown - gt * uv) / det, (-gt * uu * grown - gs * uv) / det)
            }
            (false, false) => (-gs / (2.0 * uu), -gt / (2.0 * vv)),
        };
        if !ds.is_finite() || !dt.is_finite() {
            break;
        }
        let next_s = (s + ds).clamp(window[0][0], window[0][1]);
        let next_t = (t + dt).clamp(window[1][0], window[1][1]);
        if next_s == s && next_t == t {
            break;
        }
        let next = at(a, b, next_s, next_t);
        if next.gap <= near.gap {
            let still = next.gap == near.gap;
            (s, t, near) = (next_s, next_t, next);
            damping *= 0.1;
            if still {
                break;
            }
        } else {
            damping = if damping == 0.0 { 1e-3 } else { damping * 8.0 };
            if damping > 1e12 {
                break;
            }
        }
    }
    near
}

/// What is between two places.
pub(super) fn at(a: &Form, b: &Form, s: f64, t: f64) -> Near {
    let ((p, u), (q, v)) = (jet(a, s), jet(b, t));
    let offset: Vec<f64> = p.iter().zip(&q).map(|(x, y)| x - y).collect();
    let (uu, uv, vv) = (dot(&u, &u), dot(&u, &v), dot(&v, &v));
    let square = (1.0 - uv * uv / (uu * vv)).max(0.0);
    let sine = if square.is_finite() { square.sqrt() } else { 0.0 };
    Near { s, t, gap: norm(&offset), sine }
}
