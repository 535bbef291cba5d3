//! Newton's steps, a point in each lane, within the window.

use pforms_kernel::vectors::{Lanes, Simd};

use super::{Quick, difference, dot, less, most, numbers};

/// Steps at most: five are usual.
const STEPS: usize = 12;

/// Where descent ended, and what was known there.
pub(super) struct Feet<S: Simd> {
    /// The parameters after the last step, which was tiny.
    pub parameters: [Lanes<S>; 2],
    /// The distance of the point there.
    pub distance: Lanes<S>,
    /// What the last step, taken as straight, leaves out of the point, at most.
    pub remainder: Lanes<S>,
    /// Did it end?
    pub ended: Lanes<S>,
    /// What was known before that step.
    pub local: Local<S>,
}

/// The square distance around a place: half its derivatives.
#[derive(Clone, Copy)]
pub(super) struct Local<S: Simd> {
    /// The parameters.
    pub at: [Lanes<S>; 2],
    /// The weight.
    pub weight: Lanes<S>,
    /// The distance.
    pub distance: Lanes<S>,
    /// Lengths of the first derivatives of the form.
    pub speeds: [Lanes<S>; 2],
    /// The slope.
    pub gradient: [Lanes<S>; 2],
    /// Second derivatives along `uu`, `uv`, `vv`, or what stands for them.
    pub hessian: [Lanes<S>; 3],
    /// 1 where a side of the window holds a parameter: 0 below, 1 above.
    pub held: [[Lanes<S>; 2]; 2],
    /// 1 where the square distance is convex along what is not held.
    pub convex: Lanes<S>,
}

/// Derivatives up to the second.
struct Jet<S: Simd> {
    weight: Lanes<S>,
    point: [Lanes<S>; 3],
    first: [[Lanes<S>; 3]; 2],
    second: [[Lanes<S>; 3]; 3],
}

/// Poles, and buffers for the basis.
pub(super) struct Newton<'a, S: Simd, const W: usize> {
    poles: &'a [[f64; W]],
    orders: [usize; 2],
    curve: bool,
    /// Values, first and second derivatives of the basis, for each axis.
    rows: [[Vec<Lanes<S>>; 3]; 2],
}

impl<'a, S: Simd, const W: usize> Newton<'a, S, W> {
    #[inline(always)]
    pub(super) fn new(simd: S, quick: &'a Quick) -> Self {
        let (poles, _) = quick.poles.as_chunks::<W>();
        let row = |axis: usize| vec![Lanes::splat(simd, 0.0); quick.orders[axis]];
        let rows = [0, 1].map(|axis| [row(axis), row(axis), row(axis)]);
        Self { poles, orders: quick.orders, curve: quick.is_curve(), rows }
    }

    #[inline(always)]
    pub(super) fn descend(&mut self, start: [Lanes<S>; 2], x: &[Lanes<S>; 3]) -> Feet<S> {
        let zero = Lanes::splat(start[0].simd(), 0.0);
        let mut at = start;
        let mut left = STEPS;
        loop {
            let jet = self.jet(&at);
            let local = self.local(&jet, &at, x);
            let step = local.step();
            let ended = local.ends_with(&step);
            left -= 1;
            if left == 0 || are_all(ended) {
                return finished(&jet, local, &step, ended, x);
            }
            for axis in 0..2 {
                at[axis] = less(zero, ended, at[axis], at[axis] + step[axis]);
            }
        }
    }

    /// The square distance from `x` around a place.
    #[inline(always)]
    fn local(&self, jet: &Jet<S>, at: &[Lanes<S>; 2], x: &[Lanes<S>; 3]) -> Local<S> {
        let simd = jet.weight.simd();
        let (zero, one) = (Lanes::splat(simd, 0.0), Lanes::splat(simd, 1.0));
        let offset = difference(&jet.point, x);
        let mut gradient = [dot(&offset, &jet.first[0]), dot(&offset, &jet.first[1])];
        let mut held = [[zero; 2]; 2];
        for axis in 0..2 {
            let below = less(zero, at[axis], zero, less(zero, gradient[axis], one, zero));
            let above = less(at[axis], one, zero, less(gradient[axis], zero, one, zero));
            held[axis] = if self.curve && axis == 1 { [one, zero] } else { [below, above] };
        }
        let mut metric = [
            dot(&jet.first[0], &jet.first[0]),
            dot(&jet.first[0], &jet.first[1]),
            dot(&jet.first[1], &jet.first[1]),
        ];
        let speeds = [metric[0].sqrt(), metric[2].sqrt()];
        let [uu, uv, vv] = &jet.second;
        let mut hessian = [
            metric[0] + dot(&offset, uu),
            metric[1] + dot(&offset, uv),
            metric[2] + dot(&offset, vv),
        ];
        // A held axis takes no part.
        for axis in 0..2 {
            let fixed = held[axis][0] + held[axis][1];
            gradient[axis] = less(zero, fixed, zero, gradient[axis]);
            hessian[2 * axis] = less(zero, fixed, one, hessian[2 * axis]);
            hessian[1] = less(zero, fixed, zero, hessian[1]);
            metric[2 * axis] = less(zero, fixed, one, metric[2 * axis]);
            metric[1] = less(zero, fixed, zero, metric[1]);
        }
        let determinant = hessian[0] * hessian[2] - hessian[1] * hessian[1];
        let convex = less(zero, hessian[0], less(zero, determinant, one, zero), zero);
        for k in 0..3 {
            hessian[k] = less(zero, convex, hessian[k], metric[k]);
        }
        let distance = dot(&offset, &offset).sqrt();
        Local { at: *at, weight: jet.weight, distance, speeds, gradient, hessian, held, convex }
    }

    /// The form at parameters.
    #[inline(always)]
    fn jet(&mut self, at: &[Lanes<S>; 2]) -> Jet<S> {
        let simd = at[0].simd();
        for axis in 0..2 {
            basis(at[axis], &mut self.rows[axis]);
        }
        let [u, [c, c1, c2]] = &self.rows;
        let mut sums = [[Lanes::splat(simd, 0.0); W]; 6];
        let lines = self.poles.chunks_exact(self.orders[1]);
        for (((line, b), b1), b2) in lines.zip(&u[0]).zip(&u[1]).zip(&u[2]) {
            let mut part = [[Lanes::splat(simd, 0.0); W]; 3];
            for (((pole, c), c1), c2) in line.iter().zip(c).zip(c1).zip(c2) {
                for k in 0..W {
                    let x = Lanes::splat(simd, pole[k]);
                    part[0][k] = part[0][k] + *c * x;
                    part[1][k] = part[1][k] + *c1 * x;
                    part[2][k] = part[2][k] + *c2 * x;
                }
            }
            for k in 0..W {
                sums[0][k] = sums[0][k] + *b * part[0][k];
                sums[1][k] = sums[1][k] + *b1 * part[0][k];
                sums[2][k] = sums[2][k] + *b * part[1][k];
                sums[3][k] = sums[3][k] + *b2 * part[0][k];
                sums[4][k] = sums[4][k] + *b1 * part[1][k];
                sums[5][k] = sums[5][k] + *b * part[2][k];
            }
        }
        quotient(&sums)
    }
}

/// Is every lane above 0?
#[inline(always)]
fn are_all<S: Simd>(lanes: Lanes<S>) -> bool {
    let mut all = true;
    for x in &numbers(lanes)[..S::F64_LANES] {
        all &= *x > 0.0;
    }
    all
}

/// After one more step, so short that the form is straight along it.
#[inline(always)]
fn finished<S: Simd>(
    jet: &Jet<S>,
    local: Local<S>,
    step: &[Lanes<S>; 2],
    ended: Lanes<S>,
    x: &[Lanes<S>; 3],
) -> Feet<S> {
    let zero = Lanes::splat(ended.simd(), 0.0);
    let mut parameters = local.at;
    for axis in 0..2 {
        let to = local.at[axis] + step[axis];
        parameters[axis] = less(zero, ended, to, local.at[axis]);
    }
    let mut point = jet.point;
    for c in 0..3 {
        let moved = jet.point[c] + (jet.first[0][c] * step[0] + jet.first[1][c] * step[1]);
        point[c] = less(zero, ended, moved, point[c]);
    }
    let offset = difference(&point, x);
    let distance = dot(&offset, &offset).sqrt();
    let [uu, uv, vv] = &jet.second;
    let bend = (dot(uu, uu) + dot(uv, uv) + dot(uv, uv) + dot(vv, vv)).sqrt();
    let remainder = bend * (step[0] * step[0] + step[1] * step[1]);
    Feet { parameters, distance, remainder, ended, local }
}

/// Euclidean derivatives from homogeneous ones; poles of three numbers have weight 1.
#[inline(always)]
fn quotient<S: Simd, const W: usize>(sums: &[[Lanes<S>; W]; 6]) -> Jet<S> {
    let simd = sums[0][0].simd();
    let mut jets = [[Lanes::splat(simd, 0.0); 3]; 6];
    for (jet, sum) in jets.iter_mut().zip(sums) {
        jet.copy_from_slice(&sum[..3]);
    }
    let [mut x, mut u, mut v, mut uu, mut uv, mut vv] = jets;
    let weight = if W > 3 { sums[0][W - 1] } else { Lanes::splat(simd, 1.0) };
    if W > 3 {
        let inverse = Lanes::splat(simd, 1.0) / weight;
        let [wu, wv, wuu] = [sums[1][W - 1], sums[2][W - 1], sums[3][W - 1]];
        let [wuv, wvv] = [sums[4][W - 1], sums[5][W - 1]];
        for c in 0..3 {
            x[c] = x[c] * inverse;
            u[c] = (u[c] - wu * x[c]) * inverse;
            v[c] = (v[c] - wv * x[c]) * inverse;
            uu[c] = (uu[c] - wu * (u[c] + u[c]) - wuu * x[c]) * inverse;
            vv[c] = (vv[c] - wv * (v[c] + v[c]) - wvv * x[c]) * inverse;
            uv[c] = (uv[c] - wu * v[c] - wv * u[c] - wuv * x[c]) * inverse;
        }
    }
    Jet { weight, point: x, first: [u, v], second: [uu, uv, vv] }
}

impl<S: Simd> Local<S> {
    /// Newton's step, or Gauss's and Newton's, no farther than the sides of the window.
    #[inline(always)]
    fn step(&self) -> [Lanes<S>; 2] {
        let [a, f, q] = self.hessian;
        let simd = a.simd();
        let (zero, one) = (Lanes::splat(simd, 0.0), Lanes::splat(simd, 1.0));
        let inverse = one / (a * q - f * f);
        let mut steps = [
            (f * self.gradient[1] - q * self.gradient[0]) * inverse,
            (f * self.gradient[0] - a * self.gradient[1]) * inverse,
        ];
        for axis in 0..2 {
            let to = self.at[axis] + steps[axis];
            // What is no number ends up inside too.
            let to = less(to, zero, zero, less(to, one, to, one));
            steps[axis] = to - self.at[axis];
        }
        steps
    }

    /// 1 where this step is the last: it is short, and what it gains is nothing to the distance.
    #[inline(always)]
    fn ends_with(&self, step: &[Lanes<S>; 2]) -> Lanes<S> {
        let simd = step[0].simd();
        let (zero, one) = (Lanes::splat(simd, 0.0), Lanes::splat(simd, 1.0));
        let length = most(step[0].abs(), step[1].abs());
        let gain = -(step[0] * self.gradient[0] + step[1] * self.gradient[1]);
        let enough = less(gain, self.distance * Lanes::splat(simd, GAIN), one, zero);
        let short = less(length, Lanes::splat(simd, SHORT), enough, zero);
        let tiny = less(length, Lanes::splat(simd, TINY), one, short);
        less(zero, self.convex, tiny, zero)
    }
}

/// Steps below this are as good as straight: what they leave out is below rounding.
const SHORT: f64 = 1e-9;

/// Steps below this are rounding themselves.
const TINY: f64 = 1e-14;

/// Square distance gained, in units of the distance, that is not worth another step.
const GAIN: f64 = 1e-18;

/// Bernstein polynomials at `t` with two derivatives, by the triangle of de Casteljau.
#[inline(always)]
fn basis<S: Simd>(t: Lanes<S>, rows: &mut [Vec<Lanes<S>>; 3]) {
    let order = rows[0].len();
    let (zero, one) = (Lanes::splat(t.simd(), 0.0), Lanes::splat(t.simd(), 1.0));
    let s = one - t;
    let [values, first, second] = rows;
    values[0] = one;
    for count in 1..order {
        // The rows of degrees n − 2 and n − 1 give the derivatives.
        if count + 2 == order {
            second[..count].copy_from_slice(&values[..count]);
        }
        if count + 1 == order {
            first[..count].copy_from_slice(&values[..count]);
        }
        let mut left = zero;
        for value in &mut values[..count] {
            let above = *value;
            *value = s * above + left;
            left = t * above;
        }
        values[count] = left;
    }
    let degree = order as f64 - 1.0;
    differences(first, order.saturating_sub(1), degree);
    differences(second, order.saturating_sub(2), degree - 1.0);
    differences(second, order.saturating_sub(1), degree);
}

/// The derivative of `Σ row` of `count` entries: `factor · (row[j − 1] − row[j])`.
#[inline(always)]
fn differences<S: Simd>(row: &mut [Lanes<S>], count: usize, factor: f64) {
    let simd = row[0].simd();
    let zero = Lanes::splat(simd, 0.0);
    if count == 0 {
        for entry in row {
            *entry = zero;
        }
        return;
    }
    let factor = Lanes::splat(simd, factor);
    let mut left = zero;
    for entry in &mut row[..count] {
        let above = *entry;
        *entry = factor * (left - above);
        left = above;
    }
    row[count] = factor * left;
}
