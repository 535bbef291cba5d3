//! Eight points at once: the same sums as for one point, with a point in each vector lane.
//!
//! Written in plain arithmetic and compiled for each instruction set that the processor may have;
//! the choice is made at run time. No multiplication is fused with an addition, so every set gives
//! the same bits.

#![allow(
    clippy::inline_always,
    clippy::needless_range_loop,
    reason = "only what is inlined is compiled for the wider sets; lanes are counted, not iterated"
)]

use pulp::{Arch, WithSimd};

use crate::jet::unreachable;
use crate::{Form, Result};

/// Points in one block: a register of AVX-512, two of AVX2, four of SSE2 and of WebAssembly.
pub(crate) const LANES: usize = 8;

/// One number for each of the points in a block.
type Lanes = [f64; LANES];

/// The widest poles that are summed in registers: four coordinates and a weight.
const WIDEST: usize = 5;

/// Evaluates blocks of points of one form, with buffers for the basis values.
pub(crate) struct Blocks<'a> {
    form: &'a Form<f64>,
    uniform: Option<f64>,
    arch: Arch,
    rows: Vec<Lanes>,
}

impl<'a> Blocks<'a> {
    /// Blocks for this form, or `None` when its poles are too wide or it has no axis.
    pub(crate) fn new(form: &'a Form<f64>) -> Option<Self> {
        let rows = vec![[0.0; LANES]; form.orders().iter().sum()];
        let uniform = form.uniform_weight().copied();
        let fits = form.width() <= WIDEST && form.axes() > 0;
        fits.then(|| Self { form, uniform, arch: Arch::new(), rows })
    }

    /// The euclidean points at `parameters[axis][start ..][.. LANES]`, one after another in `out`.
    ///
    /// Errors: `Domain` when a weight vanishes at one of them or a coordinate overflows.
    pub(crate) fn write(
        &mut self,
        parameters: &[&[f64]],
        start: usize,
        out: &mut [f64],
    ) -> Result<()> {
        let Self { form, uniform, ref mut rows, .. } = *self;
        self.arch.dispatch(Block { form, uniform, rows, parameters, start, out })
    }
}

struct Block<'a> {
    form: &'a Form<f64>,
    uniform: Option<f64>,
    rows: &'a mut [Lanes],
    parameters: &'a [&'a [f64]],
    start: usize,
    out: &'a mut [f64],
}

impl WithSimd for Block<'_> {
    type Output = Result<()>;

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) -> Result<()> {
        let mut rest = &mut self.rows[..];
        for (list, order) in self.parameters.iter().zip(self.form.orders()) {
            let (rows, others) = rest.split_at_mut(*order);
            let mut t = [0.0; LANES];
            t.copy_from_slice(&list[self.start..][..LANES]);
            basis(&t, rows);
            rest = others;
        }
        match self.form.width() {
            2 => self.finish::<2>(),
            3 => self.finish::<3>(),
            4 => self.finish::<4>(),
            _ => self.finish::<5>(),
        }
    }
}

/// The Bernstein polynomials at eight parameters, by the triangle of de Casteljau.
#[inline(always)]
fn basis(t: &Lanes, rows: &mut [Lanes]) {
    let s = t.map(|t| 1.0 - t);
    rows[0] = [1.0; LANES];
    for degree in 1..rows.len() {
        let mut left = [0.0; LANES];
        for row in &mut rows[..degree] {
            for k in 0..LANES {
                let above = row[k];
                row[k] = s[k] * above + left[k];
                left[k] = t[k] * above;
            }
        }
        rows[degree] = left;
    }
}

impl Block<'_> {
    /// Sums the poles of all axes and projects.
    #[inline(always)]
    fn finish<const W: usize>(self) -> Result<()> {
        let (poles, _) = self.form.homogeneous().as_chunks::<W>();
        let mut point = [[0.0; LANES]; W];
        match *self.form.orders() {
            [_] => add_line(poles, self.rows, &[1.0; LANES], &mut point),
            [first, second] => {
                let (u, v) = self.rows.split_at(first);
                for (factor, line) in u.iter().zip(poles.chunks_exact(second)) {
                    add_line(line, v, factor, &mut point);
                }
            }
            ref orders => add_poles(poles, orders, self.rows, &[1.0; LANES], &mut point),
        }
        if let Some(weight) = self.uniform {
            point[W - 1] = [weight; LANES];
        }
        project(&point, self.out)
    }
}

/// The same for any number of axes: one axis a step.
fn add_poles<const W: usize>(
    poles: &[[f64; W]],
    orders: &[usize],
    rows: &[Lanes],
    factor: &Lanes,
    point: &mut [Lanes; W],
) {
    let Some((&order, [_, ..])) = orders.split_first() else {
        return add_line(poles, rows, factor, point);
    };
    let (outer, inner) = rows.split_at(order);
    for (row, part) in outer.iter().zip(poles.chunks_exact(poles.len() / order)) {
        let product = std::array::from_fn(|k| factor[k] * row[k]);
        add_poles(part, &orders[1..], inner, &product, point);
    }
}

/// `point += factor · Σ row · pole` along the last axis.
#[inline(always)]
fn add_line<const W: usize>(
    line: &[[f64; W]],
    rows: &[Lanes],
    factor: &Lanes,
    point: &mut [Lanes; W],
) {
    let mut sum = [[0.0; LANES]; W];
    for (row, pole) in rows.iter().zip(line) {
        for c in 0..W {
            for k in 0..LANES {
                sum[c][k] += row[k] * pole[c];
            }
        }
    }
    for c in 0..W {
        for k in 0..LANES {
            point[c][k] += factor[k] * sum[c][k];
        }
    }
}

#[inline(always)]
fn project<const W: usize>(point: &[Lanes; W], out: &mut [f64]) -> Result<()> {
    let weight = &point[W - 1];
    let mut guard = weight.map(|w| 0.0 * w);
    for (k, part) in out.chunks_exact_mut(W - 1).enumerate() {
        for (c, x) in part.iter_mut().enumerate() {
            *x = point[c][k] / weight[k];
            guard[k] += 0.0 * *x;
        }
    }
    match guard.iter().position(|sum| *sum != 0.0) {
        None => Ok(()),
        Some(k) => Err(unreachable(&weight[k])),
    }
}
