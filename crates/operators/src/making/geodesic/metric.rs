//! What a geodesic feels of a surface: the products of its first and second derivatives.
//!
//! With `f_u, f_v` and the second derivatives, a curve on the surface is straight there when its second
//! derivative has no part in the tangent plane: `f_k·(f_u u″ + f_v v″ + f_uu u′² + 2 f_uv u′v′ + f_vv v′²) = 0`.
//! Products are summed coordinate after coordinate, so the space may have any dimension.

#![allow(
    clippy::inline_always,
    clippy::needless_range_loop,
    reason = "only what is inlined is compiled for the wider sets; components are counted"
)]

use super::number::Number;

/// The largest order along an axis that has a place on the stack.
pub(super) const MOST: usize = 32;

/// Poles of a piece, coordinate after coordinate, the weight last; C order within each.
#[derive(Clone, Debug)]
pub(super) struct Net {
    pub orders: [usize; 2],
    pub ambient: usize,
    /// Do the weights differ?
    pub rational: bool,
    pub poles: Vec<f64>,
}

/// Inner products of the derivatives of a surface at a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Metric<T> {
    /// `f_u·f_u`, `f_u·f_v`, `f_v·f_v`.
    pub first: [T; 3],
    /// `f_u` and `f_v` with `f_uu`, then with `f_uv`, then with `f_vv`.
    pub bends: [[T; 2]; 3],
    /// `f_uu·f_vv − f_uv·f_uv`.
    pub twist: T,
}

/// Values, slopes and second derivatives of Bernstein polynomials.
pub(super) type Rows<T, const N: usize> = [[T; N]; 3];

/// The first `order` places of each row.
#[inline(always)]
fn rows<T: Number, const N: usize>(order: usize, t: T) -> Rows<T, N> {
    let (zero, one) = (t.like(0.0), t.like(1.0));
    let mut rows = [[zero; N]; 3];
    let s = one - t;
    let degree = order - 1;
    rows[0][0] = one;
    for length in 1..order {
        if length + 1 == degree {
            let twice = t.like((degree * (degree - 1)) as f64);
            for i in 0..=degree {
                let at = |k: usize| if k < length { rows[0][k] } else { zero };
                let before = |k: usize| if i < k { zero } else { at(i - k) };
                rows[2][i] = twice * (before(2) - before(1) - before(1) + before(0));
            }
        }
        if length == degree {
            let factor = t.like(degree as f64);
            let mut left = zero;
            for i in 0..degree {
                let here = factor * rows[0][i];
                rows[1][i] = left - here;
                left = here;
            }
            rows[1][degree] = left;
        }
        let mut left = t * rows[0][0];
        rows[0][0] = s * rows[0][0];
        for i in 1..length {
            let above = rows[0][i];
            rows[0][i] = s * above + left;
            left = t * above;
        }
        rows[0][length] = left;
    }
    rows
}

/// `f, f_u, f_v, f_uu, f_uv, f_vv` of one coordinate.
#[inline(always)]
fn contracted<T: Number, const N: usize>(
    poles: &[f64],
    [m, n]: [usize; 2],
    u: &Rows<T, N>,
    v: &Rows<T, N>,
) -> [T; 6] {
    let zero = u[0][0].like(0.0);
    let mut sums = [zero; 6];
    let poles = &poles[..m * n];
    for i in 0..m {
        let mut row = [zero; 3];
        for j in 0..n {
            let pole = zero.like(poles[i * n + j]);
            for k in 0..3 {
                row[k] = row[k] + pole * v[k][j];
            }
        }
        sums[0] = sums[0] + u[0][i] * row[0];
        sums[1] = sums[1] + u[1][i] * row[0];
        sums[2] = sums[2] + u[0][i] * row[1];
        sums[3] = sums[3] + u[2][i] * row[0];
        sums[4] = sums[4] + u[1][i] * row[1];
        sums[5] = sums[5] + u[0][i] * row[2];
    }
    sums
}

/// The derivatives of `x/w` from those of both.
#[inline(always)]
fn quotient<T: Number>(x: [T; 6], w: &[T; 6], inverse: T) -> [T; 6] {
    let f = x[0] * inverse;
    let fu = (x[1] - f * w[1]) * inverse;
    let fv = (x[2] - f * w[2]) * inverse;
    let fuu = (x[3] - (fu + fu) * w[1] - f * w[3]) * inverse;
    let fuv = (x[4] - fu * w[2] - fv * w[1] - f * w[4]) * inverse;
    let fvv = (x[5] - (fv + fv) * w[2] - f * w[5]) * inverse;
    [f, fu, fv, fuu, fuv, fvv]
}

impl Net {
    pub(super) fn pole(&self, plane: usize, i: usize, j: usize) -> f64 {
        self.poles[(plane * self.orders[0] + i) * self.orders[1] + j]
    }

    /// Derivatives of every coordinate at a place of the piece, given to `each` one by one.
    #[inline(always)]
    fn derivatives<T: Number>(&self, at: [T; 2], each: impl FnMut([T; 6])) {
        // Orders that are known make loops that need not be counted.
        match self.orders {
            [3, 3] => self.derivatives_by::<T, 3>([3, 3], at, each),
            [4, 4] => self.derivatives_by::<T, 4>([4, 4], at, each),
            orders if orders[0].max(orders[1]) <= 6 => {
                self.derivatives_by::<T, 6>(orders, at, each);
            }
            orders => self.derivatives_by::<T, MOST>(orders, at, each),
        }
    }

    #[inline(always)]
    fn derivatives_by<T: Number, const N: usize>(
        &self,
        orders: [usize; 2],
        at: [T; 2],
        mut each: impl FnMut([T; 6]),
    ) {
        let (u, v) = (rows::<T, N>(orders[0], at[0]), rows::<T, N>(orders[1], at[1]));
        let plane = |k: usize| contracted(&self.poles[k * orders[0] * orders[1]..], orders, &u, &v);
        if self.rational {
            let weight = plane(self.ambient);
            let inverse = at[0].like(1.0) / weight[0];
            for k in 0..self.ambient {
                each(quotient(plane(k), &weight, inverse));
            }
        } else {
            // Weights that are all alike are 1.
            for k in 0..self.ambient {
                each(plane(k));
            }
        }
    }

    /// The same, compiled once.
    pub(super) fn each(&self, at: [f64; 2], each: &mut dyn FnMut([f64; 6])) {
        self.derivatives(at, each);
    }

    /// The point and its five derivatives: one row of coordinates for each.
    pub(super) fn jet(&self, at: [f64; 2]) -> [Vec<f64>; 6] {
        let mut jet: [Vec<f64>; 6] = std::array::from_fn(|_| Vec::with_capacity(self.ambient));
        self.each(at, &mut |one| {
            for (row, x) in jet.iter_mut().zip(one) {
                row.push(x);
            }
        });
        jet
    }

    pub(super) fn point(&self, at: [f64; 2]) -> Vec<f64> {
        let mut point = Vec::with_capacity(self.ambient);
        self.each(at, &mut |[x, ..]| point.push(x));
        point
    }

    #[inline(always)]
    pub(super) fn metric<T: Number>(&self, at: [T; 2]) -> Metric<T> {
        let zero = at[0].like(0.0);
        let mut sum = Metric { first: [zero; 3], bends: [[zero; 2]; 3], twist: zero };
        self.derivatives(at, |[_, u, v, uu, uv, vv]| {
            sum.first[0] = sum.first[0] + u * u;
            sum.first[1] = sum.first[1] + u * v;
            sum.first[2] = sum.first[2] + v * v;
            for (k, bend) in [uu, uv, vv].into_iter().enumerate() {
                sum.bends[k][0] = sum.bends[k][0] + u * bend;
                sum.bends[k][1] = sum.bends[k][1] + v * bend;
            }
            sum.twist = sum.twist + (uu * vv - uv * uv);
        });
        sum
    }
}

impl Metric<f64> {
    /// What there is where there is no surface.
    pub(super) fn nowhere() -> Self {
        Self { first: [f64::NAN; 3], bends: [[f64::NAN; 2]; 3], twist: f64::NAN }
    }
}

impl<T: Number> Metric<T> {
    /// `EG − F²`.
    #[inline(always)]
    pub(super) fn area(&self) -> T {
        let [e, f, g] = self.first;
        e * g - f * f
    }

    /// The vector whose products with `f_u, f_v` are these.
    #[inline(always)]
    pub(super) fn raised(&self, [a, b]: [T; 2]) -> [T; 2] {
        let [e, f, g] = self.first;
        let inverse = e.like(1.0) / self.area();
        [(g * a - f * b) * inverse, (e * b - f * a) * inverse]
    }

    /// The product of two directions.
    #[inline(always)]
    pub(super) fn product(&self, a: [T; 2], b: [T; 2]) -> T {
        let [e, f, g] = self.first;
        e * a[0] * b[0] + f * (a[0] * b[1] + a[1] * b[0]) + g * a[1] * b[1]
    }

    /// `Γ(a, b)`: the part of the second derivative in the tangent plane.
    #[inline(always)]
    pub(super) fn connection(&self, a: [T; 2], b: [T; 2]) -> [T; 2] {
        let (uu, uv, vv) = (a[0] * b[0], a[0] * b[1] + a[1] * b[0], a[1] * b[1]);
        let sum = |k: usize| self.bends[0][k] * uu + self.bends[1][k] * uv + self.bends[2][k] * vv;
        self.raised([sum(0), sum(1)])
    }

    /// The second derivative of a straight course with this velocity.
    #[inline(always)]
    pub(super) fn acceleration(&self, velocity: [T; 2]) -> [T; 2] {
        let [a, b] = self.connection(velocity, velocity);
        [-a, -b]
    }

    /// The Gauss curvature, in a space of any dimension (Gauss's equation).
    #[inline(always)]
    pub(super) fn curvature(&self) -> T {
        let [uu, uv, vv] = self.bends;
        let (raised_vv, raised_uv) = (self.raised(vv), self.raised(uv));
        let tangential = uu[0] * raised_vv[0] + uu[1] * raised_vv[1]
            - uv[0] * raised_uv[0]
            - uv[1] * raised_uv[1];
        (self.twist - tangential) / self.area()
    }
}
