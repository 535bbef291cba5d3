//! That the foot is the only one: over the box of the cells that might be nearer, the margin is
//! convex, or rises from the side that holds the foot.

use pforms_kernel::vectors::{Lanes, Simd};

use super::super::search::Search;
use super::near::{Near, Window};
use super::newton::{Feet, Local};
use super::{Quick, dot, least, less, most};

/// The verdict on a block of feet.
pub(super) struct Verdict<S: Simd> {
    /// 1 where the foot is proved to be the nearest.
    pub proved: Lanes<S>,
    /// Up to this.
    pub gap: Lanes<S>,
}

/// Coefficients of margins, and buffers for their slopes.
pub(super) struct Proof<'a, S: Simd, const W: usize> {
    quick: &'a Quick,
    search: &'a Search,
    orders: [usize; 2],
    margin: Vec<Lanes<S>>,
    slopes: [Vec<Lanes<S>>; 2],
    bends: [Vec<Lanes<S>>; 3],
}

/// How much of a margin's bending is asked for everywhere: the rest may vary.
const SHARE: f64 = 1.0 / 64.0;

/// What second derivatives and slopes are over a box, in its units.
struct Shape<S: Simd> {
    /// 1 where the margin is convex everywhere.
    convex: Lanes<S>,
    /// Least and most slope along each axis.
    slopes: [[Lanes<S>; 2]; 2],
    /// Least second derivative along each axis on the first and last side of the other.
    sides: [[Lanes<S>; 2]; 2],
}

impl<'a, S: Simd, const W: usize> Proof<'a, S, W> {
    #[inline(always)]
    pub(super) fn new(simd: S, quick: &'a Quick, search: &'a Search) -> Self {
        let orders = quick.orders.map(|order| 2 * order - 1);
        let buffer = || vec![Lanes::splat(simd, 0.0); orders[0] * orders[1]];
        let bends = [buffer(), buffer(), buffer()];
        Self { quick, search, orders, margin: buffer(), slopes: [buffer(), buffer()], bends }
    }

    #[inline(always)]
    pub(super) fn of(&mut self, near: &Near<S>, x: &[Lanes<S>; 3], feet: &Feet<S>) -> Verdict<S> {
        let (simd, local) = (x[0].simd(), &feet.local);
        let (zero, one) = (Lanes::splat(simd, 0.0), Lanes::splat(simd, 1.0));
        let size = dot(x, x).sqrt() + one;
        let noise = size * Lanes::splat(simd, self.search.target.noise());
        let tie = most(noise * Lanes::splat(simd, 8.0), Lanes::splat(simd, self.search.tie));
        let mut window = near.within(local.distance + tie + noise);
        for axis in 0..2 {
            window.lower[axis] = least(window.lower[axis], local.at[axis]);
            window.upper[axis] = most(window.upper[axis], local.at[axis]);
        }
        self.fill(x, local.distance);
        self.cut(&window);
        let needed = needed(local);
        let sides = [window.upper[0] - window.lower[0], window.upper[1] - window.lower[1]];
        let weight = local.weight * local.weight;
        let bend = needed * weight * Lanes::splat(simd, 2.0 * SHARE);
        let shifts = [bend * sides[0] * sides[0], bend * sides[1] * sides[1]];
        let shape = self.shape(&shifts);
        let rounding = self.rounding(size, noise);
        // Half of the bending asked for goes to rounding, half to the gap.
        let limit = rounding * Lanes::splat(simd, 2.0);
        let enough = [less(limit, shifts[0], one, zero), less(limit, shifts[1], one, zero)];
        let proved = feet.ended * shape.holds(local, enough, rounding, self.quick.is_curve());
        let mut slopes = zero;
        for axis in 0..2 {
            let slope = local.gradient[axis].abs() + noise * local.speeds[axis];
            slopes = slopes + slope * slope;
        }
        let least_weight = self.search.target.least_weight.powi(2);
        let deficit = slopes * weight * Lanes::splat(simd, 2.0 / (SHARE * least_weight)) / needed;
        let gap = least(feet.distance, deficit / local.distance) + noise + feet.remainder;
        Verdict { proved, gap: least(gap, feet.distance) }
    }

    /// The margin over the window at the distances of the feet.
    #[inline(always)]
    fn fill(&mut self, x: &[Lanes<S>; 3], distance: Lanes<S>) {
        let simd = distance.simd();
        let [squares, xs, ys, zs, weights] = &self.quick.squares;
        let twice = [-(x[0] + x[0]), -(x[1] + x[1]), -(x[2] + x[2])];
        let last = dot(x, x) - distance * distance;
        let lists = squares.iter().zip(xs).zip(ys).zip(zs).zip(weights);
        for (margin, ((((square, x), y), z), weight)) in self.margin.iter_mut().zip(lists) {
            let sum = Lanes::splat(simd, *square) + twice[0] * Lanes::splat(simd, *x);
            let sum = sum + twice[1] * Lanes::splat(simd, *y) + twice[2] * Lanes::splat(simd, *z);
            let weight = if W > 3 { Lanes::splat(simd, *weight) } else { Lanes::splat(simd, 1.0) };
            *margin = sum + last * weight;
        }
    }

    /// The margin over a box in each lane.
    #[inline(always)]
    fn cut(&mut self, window: &Window<S>) {
        let columns = self.orders[1];
        let [lower, upper] = [&window.lower, &window.upper];
        let share = lower[1] / upper[1];
        for line in self.margin.chunks_exact_mut(columns) {
            restrict_line(line, upper[1], share);
        }
        restrict(&mut self.margin, columns, upper[0], lower[0] / upper[0]);
    }

    /// Slopes and second derivatives of the margin, raised to its orders, `shifts` taken off the
    /// latter.
    #[inline(always)]
    fn shape(&mut self, shifts: &[Lanes<S>; 2]) -> Shape<S> {
        let simd = shifts[0].simd();
        let [rows, columns] = self.orders;
        let far = Lanes::splat(simd, f64::INFINITY);
        let [slopes, others] = &mut self.slopes;
        slope(&self.margin, columns, rows, slopes);
        each_line(&self.margin, columns, others);
        let bounds = [extremes(slopes), extremes(others)];
        let [uu, uv, vv] = &mut self.bends;
        slope(slopes, columns, rows, uu);
        each_line(slopes, columns, uv);
        each_line(others, columns, vv);
        let mut definite = far;
        for ((a, f), q) in uu.iter_mut().zip(uv).zip(&mut *vv) {
            *a = *a - shifts[0];
            *q = *q - shifts[1];
            definite = least(definite, least(*a, *a * *q - *f * *f));
        }
        let mut sides = [[far; 2]; 2];
        for j in 0..columns {
            sides[0][0] = least(sides[0][0], vv[j]);
            sides[0][1] = least(sides[0][1], vv[vv.len() - 1 - j]);
        }
        for i in 0..rows {
            sides[1][0] = least(sides[1][0], uu[i * columns]);
            sides[1][1] = least(sides[1][1], uu[(i + 1) * columns - 1]);
        }
        let (zero, one) = (Lanes::splat(simd, 0.0), Lanes::splat(simd, 1.0));
        let convex = less(zero, definite, one, zero);
        Shape { convex, slopes: bounds, sides }
    }

    /// By how much rounding may change a second derivative.
    #[inline(always)]
    fn rounding(&self, size: Lanes<S>, noise: Lanes<S>) -> Lanes<S> {
        let simd = size.simd();
        let degree = (self.orders[0].max(self.orders[1]) - 1) as f64;
        let terms =
            (self.search.target.form.pole_count() + 2 * self.orders[0] + 2 * self.orders[1] + 12)
                as f64;
        // Coordinates of the target are at most 2, so no pole is farther than this.
        let reach = size + Lanes::splat(simd, 3.0);
        let margin = reach * reach * Lanes::splat(simd, 2.0 * terms * f64::EPSILON)
            + reach * noise * Lanes::splat(simd, 12.0);
        margin * Lanes::splat(simd, 8.0 * degree * degree)
    }
}

impl<S: Simd> Shape<S> {
    /// 1 where the margin is shown to hold one foot, where the foot lies.
    #[inline(always)]
    fn holds(
        &self,
        local: &Local<S>,
        enough: [Lanes<S>; 2],
        rounding: Lanes<S>,
        curve: bool,
    ) -> Lanes<S> {
        let simd = rounding.simd();
        let (zero, one) = (Lanes::splat(simd, 0.0), Lanes::splat(simd, 1.0));
        let mut proved = if curve { zero } else { self.convex * enough[0] * enough[1] };
        // Per axis: 1 where the foot is held and the margin rises from there.
        let mut rises = [zero; 2];
        for axis in 0..2 {
            let [low, high] = self.slopes[axis];
            let above = less(rounding, low, local.held[axis][0], zero);
            rises[axis] = above + less(high, -rounding, local.held[axis][1], zero);
        }
        if curve {
            rises[1] = one;
        }
        for axis in 0..2 {
            // On the side that holds the foot the margin bends along the other axis.
            let side = less(zero, local.held[axis][0], self.sides[axis][0], self.sides[axis][1]);
            let bends = less(zero, side, enough[1 - axis], zero);
            proved = most(proved, rises[axis] * most(bends, rises[1 - axis]));
        }
        proved
    }
}

/// The least of half the second derivatives along what is not held.
#[inline(always)]
fn needed<S: Simd>(local: &Local<S>) -> Lanes<S> {
    let simd = local.distance.simd();
    let (zero, one) = (Lanes::splat(simd, 0.0), Lanes::splat(simd, 1.0));
    let [a, f, q] = local.hessian;
    // 1 / |H⁻¹| ≥ determinant / trace.
    let both = (a * q - f * f) / (a + q);
    let fixed_u = local.held[0][0] + local.held[0][1];
    let fixed_v = local.held[1][0] + local.held[1][1];
    let with_u = less(zero, fixed_u, less(zero, fixed_v, one, q), both);
    less(zero, fixed_u, with_u, less(zero, fixed_v, a, both))
}

/// The least and the largest.
#[inline(always)]
fn extremes<S: Simd>(list: &[Lanes<S>]) -> [Lanes<S>; 2] {
    let mut low = Lanes::splat(list[0].simd(), f64::INFINITY);
    let mut high = -low;
    for x in list {
        low = least(low, *x);
        high = most(high, *x);
    }
    [low, high]
}

/// `i·(F_i − F_{i−1}) + (m − i)·(F_{i+1} − F_i)`: the derivative along lines of `order` numbers
/// that are `stride` apart, raised to the same order.
#[inline(always)]
fn slope<S: Simd>(poles: &[Lanes<S>], stride: usize, order: usize, slopes: &mut [Lanes<S>]) {
    let (degree, simd) = (order - 1, poles[0].simd());
    for slope in &mut slopes[..stride] {
        *slope = Lanes::splat(simd, 0.0);
    }
    for i in 0..degree {
        let (before, after) = slopes[i * stride..][..2 * stride].split_at_mut(stride);
        let (low, high) = poles[i * stride..][..2 * stride].split_at(stride);
        let (left, right) =
            (Lanes::splat(simd, (degree - i) as f64), Lanes::splat(simd, (i + 1) as f64));
        let lists = before.iter_mut().zip(after).zip(low.iter().zip(high));
        for ((before, after), (low, high)) in lists {
            let step = *high - *low;
            *before = *before + left * step;
            *after = right * step;
        }
    }
}

/// [`slope`] along every line.
#[inline(always)]
fn each_line<S: Simd>(poles: &[Lanes<S>], order: usize, slopes: &mut [Lanes<S>]) {
    let (degree, simd) = (order - 1, poles[0].simd());
    for (line, slopes) in poles.chunks_exact(order).zip(slopes.chunks_exact_mut(order)) {
        let mut carried = Lanes::splat(simd, 0.0);
        for i in 0..degree {
            let step = line[i + 1] - line[i];
            slopes[i] = carried + Lanes::splat(simd, (degree - i) as f64) * step;
            carried = Lanes::splat(simd, (i + 1) as f64) * step;
        }
        slopes[degree] = carried;
    }
}

/// The poles of the part from `share·upper` to `upper`: de Casteljau's scheme from one end, then
/// from the other.
#[inline(always)]
fn restrict_line<S: Simd>(line: &mut [Lanes<S>], upper: Lanes<S>, share: Lanes<S>) {
    let one = Lanes::splat(upper.simd(), 1.0);
    let rest = one - upper;
    for step in 1..line.len() {
        let mut low = line[step - 1];
        for pole in &mut line[step..] {
            (low, *pole) = (*pole, rest * low + upper * *pole);
        }
    }
    let rest = one - share;
    for last in (1..line.len()).rev() {
        let mut high = line[last];
        for pole in line[..last].iter_mut().rev() {
            (high, *pole) = (*pole, rest * *pole + share * high);
        }
    }
}

/// [`restrict_line`] on lines of lines: `stride` numbers each.
#[inline(always)]
fn restrict<S: Simd>(lines: &mut [Lanes<S>], stride: usize, upper: Lanes<S>, share: Lanes<S>) {
    let order = lines.len() / stride;
    let one = Lanes::splat(upper.simd(), 1.0);
    let rest = one - upper;
    for step in 1..order {
        for i in (step..order).rev() {
            let (low, high) = lines[(i - 1) * stride..][..2 * stride].split_at_mut(stride);
            for (low, high) in low.iter().zip(high) {
                *high = rest * *low + upper * *high;
            }
        }
    }
    let rest = one - share;
    for step in 1..order {
        for i in 0..order - step {
            let (low, high) = lines[i * stride..][..2 * stride].split_at_mut(stride);
            for (low, high) in low.iter_mut().zip(high) {
                *low = rest * *low + share * *high;
            }
        }
    }
}
