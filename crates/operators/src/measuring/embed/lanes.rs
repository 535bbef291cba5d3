//! Newton's steps for several points of a piece at once, a point in each lane, each proved by what
//! its last step leaves out.

#![allow(
    clippy::inline_always,
    clippy::needless_range_loop,
    reason = "only what is inlined is compiled for the wider sets; lanes are counted, not iterated"
)]

use pforms_kernel::vectors::{self, Job, Lanes, Simd};

use super::cage::Cage;
use super::guide::Reach;
use super::sums::{Any, Cube, Rows};

/// Steps at most, after the first three: none are usual.
const MORE: usize = 6;

/// Points of one piece on their way, in columns.
#[derive(Default)]
pub(super) struct Queue {
    /// Which points they are.
    pub numbers: Vec<u32>,
    /// Their coordinates.
    pub points: [Vec<f64>; 3],
    /// Where to begin; then the parameters found.
    pub at: [Vec<f64>; 3],
    /// Bounds of the sum of the coordinates of `X − x·W` there; infinite where nothing was found.
    pub left: Vec<f64>,
}

impl Queue {
    #[inline]
    pub(super) fn push(&mut self, number: usize, point: &[f64], at: &[f64]) {
        self.numbers.push(number as u32);
        for k in 0..point.len().min(3) {
            self.points[k].push(point[k]);
            self.at[k].push(at[k]);
        }
        self.left.push(f64::INFINITY);
    }

    pub(super) fn clear(&mut self) {
        self.numbers.clear();
        self.left.clear();
        for list in self.points.iter_mut().chain(&mut self.at) {
            list.clear();
        }
    }
}

/// The points of a queue to be found in a piece.
pub(super) struct Task<'a> {
    pub cage: &'a Cage,
    pub poles: &'a [f64],
    pub reach: &'a Reach,
    pub queue: &'a mut Queue,
}

impl Job for Task<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self, simd: S) {
        match (self.cage.axes(), self.cage.is_rational()) {
            (1, false) => self.in_space::<S, 1, 1>(simd),
            (1, true) => self.in_space::<S, 1, 2>(simd),
            (2, false) => self.in_space::<S, 2, 2>(simd),
            (2, true) => self.in_space::<S, 2, 3>(simd),
            (_, false) => self.in_space::<S, 3, 3>(simd),
            (_, true) => self.in_space::<S, 3, 4>(simd),
        }
    }
}

impl Task<'_> {
    #[inline(always)]
    fn in_space<S: Simd, const D: usize, const W: usize>(self, simd: S) {
        match *self.cage.orders {
            [2, 2, 2] => self.each_vector::<S, Cube<S, 2>, D, W>(simd, Cube::new(simd)),
            [3, 3, 3] => self.each_vector::<S, Cube<S, 3>, D, W>(simd, Cube::new(simd)),
            [4, 4, 4] => self.each_vector::<S, Cube<S, 4>, D, W>(simd, Cube::new(simd)),
            _ => {
                let rows = Any::new(simd, &self.cage.orders);
                self.each_vector::<S, Any<S>, D, W>(simd, rows);
            }
        }
    }

    #[inline(always)]
    fn each_vector<S: Simd, R: Rows<S>, const D: usize, const W: usize>(
        self,
        simd: S,
        mut rows: R,
    ) {
        let (poles, _) = self.poles.as_chunks::<W>();
        let count = self.queue.numbers.len();
        let limits = Limits::new(simd, self.cage, self.reach);
        for first in (0..count).step_by(S::F64_LANES) {
            let mut point = [Lanes::splat(simd, 0.0); D];
            let mut at = point;
            for k in 0..D {
                point[k] = Lanes::load_some(simd, &self.queue.points[k][first..]);
                at[k] = Lanes::load_some(simd, &self.queue.at[k][first..]);
            }
            let left = found::<S, R, D, W>(&mut rows, poles, &limits, &point, &mut at);
            let room = (count - first).min(S::F64_LANES);
            for k in 0..D {
                put(at[k], &mut self.queue.at[k][first..first + room]);
            }
            put(left, &mut self.queue.left[first..first + room]);
        }
    }
}

/// Writes as many numbers as there is room for.
#[inline(always)]
fn put<S: Simd>(lanes: Lanes<S>, room: &mut [f64]) {
    if room.len() >= S::F64_LANES {
        return lanes.store(room);
    }
    let mut all = [0.0; vectors::MOST];
    lanes.store(&mut all);
    room.copy_from_slice(&all[..room.len()]);
}

/// Bounds in every lane.
struct Limits<S: Simd> {
    low: Lanes<S>,
    high: Lanes<S>,
    bend: Lanes<S>,
    noise: Lanes<S>,
}

impl<S: Simd> Limits<S> {
    #[inline(always)]
    fn new(simd: S, cage: &Cage, reach: &Reach) -> Self {
        let splat = |x| Lanes::splat(simd, x);
        Self {
            low: splat(-reach.ring),
            high: splat(1.0 + reach.ring),
            bend: splat(cage.axes() as f64 * reach.bend),
            noise: splat(cage.noise),
        }
    }

    /// The parameter after a step, within what is known.
    #[inline(always)]
    fn clamped(&self, t: Lanes<S>) -> Lanes<S> {
        t.max(self.low).min(self.high)
    }
}

/// Goes on until every lane has found its point, or no longer.
///
/// The remainder of a step `δ` is at most half the largest second derivative times `(Σ|δ|)²`; that of
/// a step with the slopes of the place before is that, and the product of both lengths. Gives bounds
/// of what is left of `X − x·W`, infinite for lanes that ended nowhere.
#[inline(always)]
fn found<S: Simd, R: Rows<S>, const D: usize, const W: usize>(
    rows: &mut R,
    poles: &[[f64; W]],
    limits: &Limits<S>,
    point: &[Lanes<S>; D],
    at: &mut [Lanes<S>; D],
) -> Lanes<S> {
    let simd = at[0].simd();
    let (zero, half) = (Lanes::splat(simd, 0.0), Lanes::splat(simd, 0.5));
    for t in at.iter_mut() {
        *t = limits.clamped(*t);
    }
    let mut local = Local::at(rows, poles, point, at);
    let (to, _) = local.step(limits, at);
    *at = to;
    local = Local::at(rows, poles, point, at);
    let (to, before) = local.step(limits, at);
    *at = to;
    local.value = value(rows, poles, point, at);
    let (to, length) = local.step(limits, at);
    let remainder = limits.bend * length * (half * length + before);
    let mut left = local.after(&to, at) + remainder;
    *at = to;
    for _ in 0..MORE {
        if is_all_below(left, limits.noise) {
            break;
        }
        local = Local::at(rows, poles, point, at);
        let (to, length) = local.step(limits, at);
        let later = local.after(&to, at) + half * limits.bend * length * length;
        for k in 0..D {
            at[k] = left.if_above(limits.noise, to[k], at[k]);
        }
        left = left.if_above(limits.noise, later, left);
    }
    // What is no number is not below either.
    let infinite = Lanes::splat(simd, f64::INFINITY);
    for t in at.iter_mut() {
        *t = t.if_above(-infinite, *t, zero);
    }
    limits.noise.if_above(left, left, infinite)
}

#[inline(always)]
fn is_all_below<S: Simd>(lanes: Lanes<S>, limit: Lanes<S>) -> bool {
    let one = Lanes::splat(lanes.simd(), 1.0);
    let mut all = [1.0; vectors::MOST];
    limit.if_above(lanes, one, Lanes::splat(lanes.simd(), 0.0)).store(&mut all);
    all.iter().all(|x| *x > 0.0)
}

/// `X − x·W` and its derivatives around a place.
struct Local<S: Simd, const D: usize> {
    value: [Lanes<S>; D],
    /// `[coordinate][axis]`.
    slopes: [[Lanes<S>; D]; D],
    inverse: [[Lanes<S>; D]; D],
}

impl<S: Simd, const D: usize> Local<S, D> {
    #[inline(always)]
    fn at<R: Rows<S>, const W: usize>(
        rows: &mut R,
        poles: &[[f64; W]],
        point: &[Lanes<S>; D],
        at: &[Lanes<S>; D],
    ) -> Self {
        let simd = at[0].simd();
        rows.fill(at);
        let sums = rows.jet(poles);
        let mut slopes = [[Lanes::splat(simd, 0.0); D]; D];
        for c in 0..D {
            for k in 0..D {
                // The sums of the last axes come last.
                slopes[c][k] = slope::<S, D, W>(&sums[1 + (3 - D) + k], c, point[c]);
            }
        }
        let mut value = [Lanes::splat(simd, 0.0); D];
        for c in 0..D {
            value[c] = offset::<S, D, W>(&sums[0], c, point[c]);
        }
        let inverse = inverse(&slopes);
        Self { value, slopes, inverse }
    }

    /// Where Newton's step leads, and the sum of its absolute lengths.
    #[inline(always)]
    fn step(&self, limits: &Limits<S>, at: &[Lanes<S>; D]) -> ([Lanes<S>; D], Lanes<S>) {
        let mut to = *at;
        let mut length = Lanes::splat(at[0].simd(), 0.0);
        for k in 0..D {
            let mut by = self.inverse[k][0] * self.value[0];
            for c in 1..D {
                by = by + self.inverse[k][c] * self.value[c];
            }
            to[k] = limits.clamped(at[k] - by);
            length = length + (to[k] - at[k]).abs();
        }
        (to, length)
    }

    /// The sum of the coordinates of `value + slopes·(to − at)`.
    #[inline(always)]
    fn after(&self, to: &[Lanes<S>; D], at: &[Lanes<S>; D]) -> Lanes<S> {
        let mut all = Lanes::splat(at[0].simd(), 0.0);
        for c in 0..D {
            let mut sum = self.value[c];
            for k in 0..D {
                sum = sum + self.slopes[c][k] * (to[k] - at[k]);
            }
            all = all + sum.abs();
        }
        all
    }
}

/// `X − x·W` alone.
#[inline(always)]
fn value<S: Simd, R: Rows<S>, const D: usize, const W: usize>(
    rows: &mut R,
    poles: &[[f64; W]],
    point: &[Lanes<S>; D],
    at: &[Lanes<S>; D],
) -> [Lanes<S>; D] {
    rows.fill_values(at);
    let sums = rows.value(poles);
    let mut value = [Lanes::splat(at[0].simd(), 0.0); D];
    for c in 0..D {
        value[c] = offset::<S, D, W>(&sums, c, point[c]);
    }
    value
}

/// `X − x·W` in coordinate `c`, the weight last or 1.
#[inline(always)]
fn offset<S: Simd, const D: usize, const W: usize>(
    sums: &[Lanes<S>; W],
    c: usize,
    x: Lanes<S>,
) -> Lanes<S> {
    sums[c] - if W > D { x * sums[W - 1] } else { x }
}

/// The same of derivatives, where a weight of 1 has none.
#[inline(always)]
fn slope<S: Simd, const D: usize, const W: usize>(
    sums: &[Lanes<S>; W],
    c: usize,
    x: Lanes<S>,
) -> Lanes<S> {
    if W > D { sums[c] - x * sums[W - 1] } else { sums[c] }
}

/// The inverse, by minors; what has none gives numbers that are none, or infinite.
#[inline(always)]
fn inverse<S: Simd, const D: usize>(a: &[[Lanes<S>; D]; D]) -> [[Lanes<S>; D]; D] {
    let mut inverse = *a;
    let one = Lanes::splat(a[0][0].simd(), 1.0);
    if D == 1 {
        inverse[0][0] = one / a[0][0];
    } else if D == 2 {
        let factor = one / (a[0][0] * a[1][1] - a[0][1] * a[1][0]);
        inverse[0][0] = a[1][1] * factor;
        inverse[0][1] = -(a[0][1] * factor);
        inverse[1][0] = -(a[1][0] * factor);
        inverse[1][1] = a[0][0] * factor;
    } else {
        for k in 0..D {
            let (k1, k2) = ((k + 1) % D, (k + 2) % D);
            for c in 0..D {
                let (c1, c2) = ((c + 1) % D, (c + 2) % D);
                inverse[k][c] = a[c1][k1] * a[c2][k2] - a[c1][k2] * a[c2][k1];
            }
        }
        let mut determinant = inverse[0][0] * a[0][0];
        for c in 1..D {
            determinant = determinant + inverse[0][c] * a[c][0];
        }
        let factor = one / determinant;
        for k in 0..D {
            for c in 0..D {
                inverse[k][c] = inverse[k][c] * factor;
            }
        }
    }
    inverse
}
