//! Frames that do not turn about the tangent, as polynomials with a proved error.
//!
//! With a polynomial `D` along the tangent such a frame turns at the rate `ω = D × D′ / |D|²`. So a
//! polynomial `p` near a normal `n` leaves the residual `|D|²·p′ − (D × D′) × p`, a polynomial too:
//! its coefficients over the least of `|D|²` bound `|p′ − ω × p|`. As turning keeps lengths, the
//! distance of `p` and `n` grows by no more than that (Wang, Jüttler, Zheng and Liu 2008 for the
//! frame; Magnus's series in Blanes and Casas, *A Concise Introduction to Geometric Numerical
//! Integration*, 2016, for the steps).

use super::poly::Poly;
use super::vector::Vector;
use crate::measuring::vector::{cross, dot, norm, plus, unit};

/// Steps of order 6 over a piece: their error is far below that of a polynomial of degree 5.
const STEPS: usize = 2;

/// Rates of turning below this are rounding: the normal is constant.
const STILL: f64 = 64.0 * f64::EPSILON;

/// Two normals carried over a piece.
pub(super) struct Carried {
    /// Polynomials near the normals.
    pub normals: [Vector; 2],
    /// Where the normals arrive, unit vectors across the tangent.
    pub end: [[f64; 3]; 2],
    /// By how much the distance to the true normals may have grown.
    pub error: f64,
}

/// How a frame turns over a piece.
pub(super) struct Turning {
    tangent: Vector,
    rate: Vector,
    square: Poly,
    least: f64,
}

impl Turning {
    /// From a direction of the tangent; none unless it is proved to stay away from 0.
    pub(super) fn of(direction: &Vector) -> Option<Self> {
        let square = direction.dot(direction);
        let least = square.least();
        (least > 0.0).then(|| Self {
            rate: direction.cross(&direction.derivative()),
            tangent: direction.clone(),
            square,
            least,
        })
    }

    /// The unit tangents at the ends.
    pub(super) fn tangents(&self) -> [[f64; 3]; 2] {
        [self.tangent.first(), self.tangent.last()].map(|d| d.map(|x| x / norm(&d)))
    }

    /// The angular velocity.
    fn at(&self, t: f64) -> [f64; 3] {
        let square = self.square.at(t);
        self.rate.at(t).map(|x| x / square)
    }

    /// The derivative of the unit tangent.
    pub(super) fn bend(&self, t: f64) -> [f64; 3] {
        let tangent = self.tangent.at(t);
        let length = norm(&tangent);
        cross(&self.at(t), &tangent).map(|x| x / length)
    }

    /// Carries two normals from the beginning to the end.
    pub(super) fn carry(&self, start: [[f64; 3]; 2]) -> Carried {
        let most = self.rate.most() / self.least;
        if most <= STILL {
            return Carried { normals: start.map(Vector::constant), end: start, error: most };
        }
        let mut normal = start[0];
        for step in 0..STEPS {
            normal = turned(normal, self.step(step as f64 / STEPS as f64, 1.0 / STEPS as f64));
        }
        let tangent = self.tangents()[1];
        let normal = array(&unit(&plus(&normal, -dot(&normal, &tangent), &tangent)));
        let end = [normal, cross(&tangent, &normal)];
        let (first, last) = (self.velocity(Vector::first), self.velocity(Vector::last));
        let normals =
            [0, 1].map(|k| Vector::hermite(moving(start[k], first), moving(end[k], last)));
        let residuals = normals.each_ref().map(|near| self.residual(near));
        Carried { normals, end, error: residuals[0].max(residuals[1]) }
    }

    fn residual(&self, near: &Vector) -> f64 {
        let moved = near.derivative().times(&self.square);
        moved.plus(-1.0, &self.rate.cross(near)).most() / self.least
    }

    /// The angular velocity and its derivative at an end.
    fn velocity(&self, end: impl Fn(&Vector) -> [f64; 3]) -> [[f64; 3]; 2] {
        let (d, dd) = (end(&self.tangent), end(&self.tangent.derivative()));
        let ddd = end(&self.tangent.derivative().derivative());
        let square = dot(&d, &d);
        let rate = cross(&d, &dd).map(|x| x / square);
        let growth = 2.0 * dot(&d, &dd) / square;
        let change = cross(&d, &ddd).map(|x| x / square);
        [rate, array(&plus(&change, -growth, &rate))]
    }

    /// The turn over a step, by Magnus's series to order 6 with three Gauss points.
    fn step(&self, from: f64, h: f64) -> [f64; 3] {
        let aside = 0.15_f64.sqrt();
        let [a, b, c] = [0.5 - aside, 0.5, 0.5 + aside].map(|x| self.at(from + h * x));
        let sum = |f: &dyn Fn(usize) -> f64| -> [f64; 3] { std::array::from_fn(f) };
        let first = b.map(|x| h * x);
        let second = sum(&|k| 15_f64.sqrt() * h / 3.0 * (c[k] - a[k]));
        let third = sum(&|k| 10.0 * h / 3.0 * (c[k] - 2.0 * b[k] + a[k]));
        let inner = cross(&first, &second);
        let outer = cross(&first, &sum(&|k| 2.0 * third[k] + inner[k])).map(|x| -x / 60.0);
        let left = sum(&|k| -20.0 * first[k] - third[k] + inner[k]);
        let last = cross(&left, &sum(&|k| second[k] + outer[k]));
        sum(&|k| first[k] + third[k] / 12.0 + last[k] / 240.0)
    }
}

/// A normal with the first two derivatives that an angular velocity gives it.
fn moving(normal: [f64; 3], [rate, change]: [[f64; 3]; 2]) -> [[f64; 3]; 3] {
    let velocity = cross(&rate, &normal);
    let bend = plus(&cross(&change, &normal), 1.0, &cross(&rate, &velocity));
    [normal, velocity, array(&bend)]
}

/// The vector turned about an axis by the axis's length (Rodrigues).
fn turned(vector: [f64; 3], turn: [f64; 3]) -> [f64; 3] {
    let angle = norm(&turn);
    if angle == 0.0 {
        return vector;
    }
    let axis = turn.map(|x| x / angle);
    let (sine, cosine) = libm::sincos(angle);
    let side = cross(&axis, &vector);
    let along = dot(&axis, &vector) * (1.0 - cosine);
    std::array::from_fn(|k| cosine * vector[k] + sine * side[k] + along * axis[k])
}

pub(super) fn array(vector: &[f64]) -> [f64; 3] {
    [vector[0], vector[1], vector[2]]
}
