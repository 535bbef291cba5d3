//! A part of a plane curve: its poles on the stack, and its window.

/// A part of a plane curve of order at most `N`, with (`D` = 3) or without (`D` = 2) weights. The
/// weights are positive, so that the part lies in the hull of its poles.
#[derive(Clone, Copy)]
pub(super) struct Part<const D: usize, const N: usize> {
    /// Number of poles.
    pub order: usize,
    /// Homogeneous poles.
    pub poles: [[f64; D]; N],
    /// Where the window begins.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
    /// By how much a coordinate of a pole may be off.
    pub noise: f64,
}

/// The least and the greatest of each coordinate.
pub(super) type Box2 = [[f64; 2]; 2];

/// What a convex combination of two numbers below 1 rounds, at most.
const LERP: f64 = 2.5 * f64::EPSILON / 2.0;

impl<const D: usize, const N: usize> Part<D, N> {
    /// The whole of a curve whose poles are below 2.
    pub(super) fn new(poles: &[[f64; 3]]) -> Self {
        let mut part =
            Self { order: poles.len(), poles: [[0.0; D]; N], from: 0.0, to: 1.0, noise: 0.0 };
        for (pole, [x, y, w]) in part.poles.iter_mut().zip(poles) {
            pole[0] = *x;
            pole[1] = *y;
            if D == 3 {
                pole[2] = *w;
            }
        }
        part
    }

    /// The weight of a pole.
    pub(super) fn weight(&self, i: usize) -> f64 {
        if D == 3 { self.poles[i][2] } else { 1.0 }
    }

    /// A pole as a point.
    pub(super) fn point(&self, i: usize) -> [f64; 2] {
        let pole = &self.poles[i];
        if D == 3 { [pole[0] / pole[2], pole[1] / pole[2]] } else { [pole[0], pole[1]] }
    }

    /// The poles as points, and by how much these may be off.
    pub(super) fn points(&self) -> ([[f64; 2]; N], f64) {
        let mut points = [[0.0; 2]; N];
        let (mut reach, mut least) = (0.0_f64, 1.0_f64);
        for (i, point) in points.iter_mut().enumerate().take(self.order) {
            *point = self.point(i);
            if D == 3 {
                reach = reach.max(point[0].abs()).max(point[1].abs());
                least = least.min(self.poles[i][2]);
            }
        }
        let noise =
            if D == 3 { (self.noise + f64::EPSILON) * (1.0 + reach) / least } else { self.noise };
        (points, noise)
    }

    /// Length of the window.
    pub(super) fn length(&self) -> f64 {
        self.to - self.from
    }

    /// The two halves.
    pub(super) fn halves(&self) -> (Self, Self) {
        let (mut left, mut right) = (*self, *self);
        let last = self.order - 1;
        for step in 0..last {
            left.poles[step] = right.poles[0];
            for i in 0..last - step {
                for k in 0..D {
                    right.poles[i][k] = 0.5 * (right.poles[i][k] + right.poles[i + 1][k]);
                }
            }
        }
        left.poles[last] = right.poles[0];
        let middle = 0.5 * (self.from + self.to);
        left.to = middle;
        right.from = middle;
        left.noise += LERP * last as f64;
        right.noise = left.noise;
        (left, right)
    }

    /// The part over `low` to `high`, in shares of this one.
    pub(super) fn cut(&self, low: f64, high: f64) -> Self {
        let mut part = *self;
        let last = self.order - 1;
        if high < 1.0 {
            // Poles of the window before `high`: the first of each step.
            let rest = 1.0 - high;
            for step in 1..=last {
                for i in (step..=last).rev() {
                    for k in 0..D {
                        part.poles[i][k] = rest * part.poles[i - 1][k] + high * part.poles[i][k];
                    }
                }
            }
        }
        let share = low / high;
        if share > 0.0 {
            let rest = 1.0 - share;
            for step in 1..=last {
                for i in 0..=last - step {
                    for k in 0..D {
                        part.poles[i][k] = rest * part.poles[i][k] + share * part.poles[i + 1][k];
                    }
                }
            }
        }
        let length = self.length();
        part.to = if high < 1.0 { self.from + high * length } else { self.to };
        part.from += low * length;
        // The cut is known to a rounding of its place: as much again, times the speed.
        part.noise += 4.0 * LERP * last as f64;
        part
    }
}

/// The box of points.
pub(super) fn box_of(points: &[[f64; 2]]) -> Box2 {
    let mut all = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    for point in points {
        for (ends, x) in all.iter_mut().zip(point) {
            ends[0] = if *x < ends[0] { *x } else { ends[0] };
            ends[1] = if *x > ends[1] { *x } else { ends[1] };
        }
    }
    all
}

/// Are two boxes farther apart than `margin`?
pub(super) fn apart(a: &Box2, b: &Box2, margin: f64) -> bool {
    a.iter().zip(b).any(|(x, y)| x[0] - y[1] > margin || y[0] - x[1] > margin)
}
