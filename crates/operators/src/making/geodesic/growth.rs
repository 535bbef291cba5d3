//! What becomes of small errors: neighbouring geodesics part as `y″ + K·y = 0` (Jacobi).
//!
//! A wrong turn of a step, and a step aside, go on as a geodesic beside the true one. All that may have come
//! together is kept as an ellipse of `(y, y′)`: it turns and stretches as the fields do, without the
//! growth that bounds for `y` and `y′` apart would have where geodesics only swing about one another.

/// Bounds of the error along a course, and the field of the geodesics through its beginning.
#[derive(Clone, Copy, Debug)]
pub(super) struct Growth {
    /// Of the ellipse `(y, y′)·E⁻¹·(y, y′) ≤ 1`: `E_yy`, `E_yy′`, `E_y′y′`.
    ellipse: [f64; 3],
    /// Of the error along the course.
    along: f64,
    /// The field with `y = 0`, `y′ = 1` at the beginning.
    pub field: [f64; 2],
    /// The length at which the field first returned to 0.
    pub conjugate: Option<f64>,
}

/// Gauss curvatures at the begin, the quarters and the end of a step.
pub(super) type Curvatures = [f64; 5];

impl Growth {
    pub(super) fn new() -> Self {
        Self { ellipse: [0.0; 3], along: 0.0, field: [0.0, 1.0], conjugate: None }
    }

    /// How far the place may be from the true one.
    pub(super) fn error(&self) -> f64 {
        self.ellipse[0].max(0.0).sqrt() + self.along
    }

    /// Takes a step from `length` on, which adds errors of place and direction of its own.
    pub(super) fn step(
        &mut self,
        length: f64,
        by: f64,
        curvatures: &Curvatures,
        place: f64,
        turn: f64,
    ) {
        let one = carried([1.0, 0.0], by, curvatures);
        let two = carried([0.0, 1.0], by, curvatures);
        let [y, slope] = self.field;
        let field = [y * one[0] + slope * two[0], y * one[1] + slope * two[1]];
        if self.conjugate.is_none() && y != 0.0 && y * field[0] <= 0.0 {
            self.conjugate = Some(length + by * root([y, by * slope], [field[0], by * field[1]]));
        }
        self.field = field;
        let [a, b, c] = self.ellipse;
        let moved = |p: [f64; 2], q: [f64; 2]| {
            a * p[0] * q[0] + b * (p[0] * q[1] + p[1] * q[0]) + c * p[1] * q[1]
        };
        let (top, bottom) = ([one[0], two[0]], [one[1], two[1]]);
        self.ellipse = [moved(top, top), moved(top, bottom), moved(bottom, bottom)];
        self.add(place, turn);
    }

    /// Adds errors of place and direction: the least ellipse about the sum of two, in the sum of the squares of
    /// its axes.
    pub(super) fn add(&mut self, place: f64, turn: f64) {
        self.along += place;
        // The half axes of an ellipse about a rectangle.
        let more = [2.0 * place * place, 2.0 * turn * turn];
        let (size, extra) =
            ((self.ellipse[0] + self.ellipse[2]).sqrt(), (more[0] + more[1]).sqrt());
        if size == 0.0 || extra == 0.0 {
            self.ellipse[0] += more[0];
            self.ellipse[2] += more[1];
            return;
        }
        let (old, new) = (1.0 + extra / size, 1.0 + size / extra);
        let [a, b, c] = self.ellipse;
        self.ellipse = [old * a + new * more[0], old * b, old * c + new * more[1]];
    }
}

/// How little the curvatures tell of the fields within a step: the difference of what two halves and the whole of it
/// say, in shares of what counts as too much.
pub(super) fn unclear(by: f64, curvatures: &Curvatures) -> f64 {
    let [k, _, l, _, m] = *curvatures;
    let starts = [[1.0, 0.0], [0.0, 1.0 / by]];
    let miss = |start: [f64; 2]| {
        let [y, slope] = carried(start, by, curvatures);
        let [z, other] = over(start, by, [k, l, m], BENT / (by * by));
        (y - z).abs().max(by * (slope - other).abs())
    };
    miss(starts[0]).max(miss(starts[1])) / UNCLEAR
}

const UNCLEAR: f64 = 0.05;

/// Where the cubic with these values and slopes at 0 and 1 vanishes; the values differ in sign.
fn root([y, slope]: [f64; 2], [end, last]: [f64; 2]) -> f64 {
    let cubic = |t: f64| {
        let s = 1.0 - t;
        s * s * ((1.0 + 2.0 * t) * y + t * slope) + t * t * ((1.0 + 2.0 * s) * end - s * last)
    };
    let (mut before, mut after) = (0.0, 1.0);
    for _ in 0..40 {
        let middle = f64::midpoint(before, after);
        *(if cubic(middle) * y > 0.0 { &mut before } else { &mut after }) = middle;
    }
    f64::midpoint(before, after)
}

/// Curvature times the square of a step, at most.
const BENT: f64 = 4.0;

/// A Jacobi field over a step, by two steps of order 4.
fn carried(start: [f64; 2], by: f64, curvatures: &Curvatures) -> [f64; 2] {
    let [k, l, m, n, o] = *curvatures;
    // A step bends little, or it would not have been taken: more is rounding, as beside an apex.
    let most = BENT / (by * by);
    let middle = over(start, by / 2.0, [k, l, m], most);
    over(middle, by / 2.0, [m, n, o], most)
}

/// The same by one step, with the curvatures at its begin, middle and end.
fn over(at: [f64; 2], h: f64, k: [f64; 3], most: f64) -> [f64; 2] {
    let slope = |[y, s]: [f64; 2], k: f64| [s, -k.clamp(-most, most) * y];
    let moved = |d: [f64; 2], by: f64| [at[0] + by * d[0], at[1] + by * d[1]];
    let a = slope(at, k[0]);
    let b = slope(moved(a, h / 2.0), k[1]);
    let c = slope(moved(b, h / 2.0), k[1]);
    let d = slope(moved(c, h), k[2]);
    [0, 1].map(|i| at[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn on_a_sphere_neighbours_meet_after_half_a_turn() {
        let mut growth = Growth::new();
        for k in 0..100 {
            growth.step(f64::from(k) * 0.04, 0.04, &[1.0; 5], 0.0, 0.0);
        }
        // Two steps of order 4 over 0.04: 1e-9 of the field.
        assert!((growth.field[0] - libm::sin(4.0)).abs() < 1e-8);
        assert!((growth.conjugate.unwrap() - std::f64::consts::PI).abs() < 1e-7);
    }

    #[test]
    fn errors_swing_on_a_sphere_and_grow_on_a_saddle() {
        let bound = |curvature: f64| {
            let mut growth = Growth::new();
            growth.add(1e-10, 0.0);
            for k in 0..1000 {
                growth.step(f64::from(k) * 0.01, 0.01, &[curvature; 5], 0.0, 0.0);
            }
            growth.error()
        };
        // √2 for the ellipse about a rectangle, and the error along.
        assert!(bound(1.0) < 3e-10);
        let grown = libm::cosh(10.0) * 1e-10;
        assert!(bound(-1.0) > grown && bound(-1.0) < 3.0 * grown);
    }
}
