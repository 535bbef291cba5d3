//! Points at scattered parameters: the sums of one point, with a point in every lane.

#![allow(
    clippy::inline_always,
    clippy::needless_range_loop,
    reason = "only what is inlined is compiled for the wider sets; lanes are counted, not iterated"
)]

use std::marker::PhantomData;

use crate::planar::{BLOCK, Planar};
use crate::vector_rows::{column_sum, short_row};
use crate::vectors::{Job, Lanes, Simd, bernstein, in_lanes, line_sums};
use crate::{Form, Result};

/// The points of a form at `parameters[axis][i]`, into `out`.
///
/// The common shapes are compiled each for itself, so that their rows stay in registers.
pub(crate) fn write_scattered(
    form: &Form<f64>,
    parameters: &[&[f64]],
    out: &mut [f64],
) -> Result<()> {
    match *form.orders() {
        [2, 2] => write_shape::<Square<2>>(form, parameters, out),
        [3, 3] => write_shape::<Square<3>>(form, parameters, out),
        [4, 4] => write_shape::<Square<4>>(form, parameters, out),
        [2, 2, 2] => write_shape::<Cube<2>>(form, parameters, out),
        [3, 3, 3] => write_shape::<Cube<3>>(form, parameters, out),
        [4, 4, 4] => write_shape::<Cube<4>>(form, parameters, out),
        _ => write_shape::<Any>(form, parameters, out),
    }
}

/// Goes on with the width of the poles, and the components to be summed, known to the compiler.
fn write_shape<K: Shape>(form: &Form<f64>, parameters: &[&[f64]], out: &mut [f64]) -> Result<()> {
    let mut planar = Planar::default();
    planar.begin(form);
    let (width, summed) = (form.width(), planar.summed());
    let blocks = Blocks { form, parameters, planar, out };
    match (width, summed) {
        (4, 4) => in_lanes(OfWidth::<K, 4, 4>(blocks, PhantomData)),
        (4, 3) => in_lanes(OfWidth::<K, 4, 3>(blocks, PhantomData)),
        (3, 3) => in_lanes(OfWidth::<K, 3, 3>(blocks, PhantomData)),
        (3, 2) => in_lanes(OfWidth::<K, 3, 2>(blocks, PhantomData)),
        _ => in_lanes(OfAnyWidth::<K>(blocks, PhantomData)),
    }
}

/// Points to be written, a block after the other.
struct Blocks<'a> {
    form: &'a Form<f64>,
    parameters: &'a [&'a [f64]],
    planar: Planar,
    out: &'a mut [f64],
}

/// The blocks of a form whose poles are `W` numbers wide, the first `C` of them to be summed.
struct OfWidth<'a, K, const W: usize, const C: usize>(Blocks<'a>, PhantomData<K>);

impl<K: Shape, const W: usize, const C: usize> Job for OfWidth<'_, K, W, C> {
    type Output = Result<()>;

    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Result<()> {
        let Blocks { form, parameters, mut planar, out } = self.0;
        let (poles, _) = form.homogeneous().as_chunks::<W>();
        let mut rows = K::rows(simd, form.orders());
        for (block, out) in out.chunks_mut(BLOCK * (W - 1)).enumerate() {
            for at in (0..out.len() / (W - 1)).step_by(S::F64_LANES) {
                rows.fill(simd, parameters, block * BLOCK + at);
                planar.put(0, at, &rows.sums::<W, C>(poles));
            }
            planar.project(out)?;
        }
        Ok(())
    }
}

/// The blocks of a form whose poles have any width: one component after another.
struct OfAnyWidth<'a, K>(Blocks<'a>, PhantomData<K>);

impl<K: Shape> Job for OfAnyWidth<'_, K> {
    type Output = Result<()>;

    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Result<()> {
        let Blocks { form, parameters, mut planar, out } = self.0;
        let mut rows = K::rows(simd, form.orders());
        for (block, out) in out.chunks_mut(BLOCK * form.ambient()).enumerate() {
            for at in (0..out.len() / form.ambient()).step_by(S::F64_LANES) {
                rows.fill(simd, parameters, block * BLOCK + at);
                for column in 0..planar.summed() {
                    let poles = &form.homogeneous()[column..];
                    planar.put(column, at, &[sum_column(poles, form.width(), &rows)]);
                }
            }
            planar.project(out)?;
        }
        Ok(())
    }
}

/// What is known to the compiler about the orders of a form.
trait Shape {
    /// The basis values of such a form.
    type Rows<S: Simd>: Rows<S>;

    /// Room for them.
    fn rows<S: Simd>(simd: S, orders: &[usize]) -> Self::Rows<S>;
}

/// A surface of the same order along both axes.
struct Square<const O: usize>;

impl<const O: usize> Shape for Square<O> {
    type Rows<S: Simd> = SquareRows<S, O>;

    #[inline(always)]
    fn rows<S: Simd>(simd: S, _: &[usize]) -> SquareRows<S, O> {
        SquareRows([[Lanes::splat(simd, 0.0); O]; 2])
    }
}

/// A volume of the same order along all axes.
struct Cube<const O: usize>;

impl<const O: usize> Shape for Cube<O> {
    type Rows<S: Simd> = CubeRows<S, O>;

    #[inline(always)]
    fn rows<S: Simd>(simd: S, _: &[usize]) -> CubeRows<S, O> {
        let zero = Lanes::splat(simd, 0.0);
        CubeRows { factors: [[zero; O]; O], last: [zero; O] }
    }
}

/// Anything else.
struct Any;

impl Shape for Any {
    type Rows<S: Simd> = AnyRows<S>;

    #[inline(always)]
    fn rows<S: Simd>(simd: S, orders: &[usize]) -> AnyRows<S> {
        let most = orders.iter().max().copied().unwrap_or(1);
        let rows = vec![Lanes::splat(simd, 1.0); most];
        AnyRows { orders: orders.to_vec(), factors: Vec::new(), rows }
    }
}

/// Basis values at the points of a vector: for the lines of poles along the last axis, and along that axis.
trait Rows<S: Simd> {
    /// Takes the values at the parameters from `place` on.
    fn fill(&mut self, simd: S, parameters: &[&[f64]], place: usize);

    /// For every line the product of the values along the axes before the last.
    fn factors(&self) -> &[Lanes<S>];

    /// The values along the last axis.
    fn last(&self) -> &[Lanes<S>];

    /// `Σ factor · Σ value · pole` of the first `C` components of all poles.
    #[inline(always)]
    fn sums<const W: usize, const C: usize>(&self, poles: &[[f64; W]]) -> [Lanes<S>; C] {
        let last = self.last();
        let mut total = [Lanes::splat(last[0].simd(), 0.0); C];
        for (factor, line) in self.factors().iter().zip(poles.chunks_exact(last.len())) {
            add_line(&mut total, *factor, last, line);
        }
        total
    }
}

/// Rows of a [`Square`].
struct SquareRows<S: Simd, const O: usize>([[Lanes<S>; O]; 2]);

impl<S: Simd, const O: usize> Rows<S> for SquareRows<S, O> {
    #[inline(always)]
    fn fill(&mut self, simd: S, parameters: &[&[f64]], place: usize) {
        for axis in 0..2 {
            self.0[axis] = short_row(Lanes::load_some(simd, &parameters[axis][place..]));
        }
    }

    #[inline(always)]
    fn factors(&self) -> &[Lanes<S>] {
        &self.0[0]
    }

    #[inline(always)]
    fn last(&self) -> &[Lanes<S>] {
        &self.0[1]
    }

    #[inline(always)]
    fn sums<const W: usize, const C: usize>(&self, poles: &[[f64; W]]) -> [Lanes<S>; C] {
        let (lines, _) = poles.as_chunks::<O>();
        assert!(lines.len() >= O);
        let mut total = [Lanes::splat(self.0[0][0].simd(), 0.0); C];
        for i in 0..O {
            add_line(&mut total, self.0[0][i], &self.0[1], &lines[i]);
        }
        total
    }
}

/// Rows of a [`Cube`].
struct CubeRows<S: Simd, const O: usize> {
    factors: [[Lanes<S>; O]; O],
    last: [Lanes<S>; O],
}

impl<S: Simd, const O: usize> Rows<S> for CubeRows<S, O> {
    #[inline(always)]
    fn fill(&mut self, simd: S, parameters: &[&[f64]], place: usize) {
        let first = short_row::<S, O>(Lanes::load_some(simd, &parameters[0][place..]));
        let second = short_row::<S, O>(Lanes::load_some(simd, &parameters[1][place..]));
        for i in 0..O {
            for j in 0..O {
                self.factors[i][j] = first[i] * second[j];
            }
        }
        self.last = short_row(Lanes::load_some(simd, &parameters[2][place..]));
    }

    #[inline(always)]
    fn factors(&self) -> &[Lanes<S>] {
        self.factors.as_flattened()
    }

    #[inline(always)]
    fn last(&self) -> &[Lanes<S>] {
        &self.last
    }
}

/// Rows of [`Any`] form.
struct AnyRows<S: Simd> {
    orders: Vec<usize>,
    factors: Vec<Lanes<S>>,
    rows: Vec<Lanes<S>>,
}

impl<S: Simd> Rows<S> for AnyRows<S> {
    #[inline(always)]
    fn fill(&mut self, simd: S, parameters: &[&[f64]], place: usize) {
        self.factors.clear();
        self.factors.push(Lanes::splat(simd, 1.0));
        for (axis, &order) in self.orders.iter().enumerate() {
            let row = &mut self.rows[..order];
            bernstein(Lanes::load_some(simd, &parameters[axis][place..]), row);
            if axis + 1 < self.orders.len() {
                spread(&mut self.factors, row);
            }
        }
    }

    #[inline(always)]
    fn factors(&self) -> &[Lanes<S>] {
        &self.factors
    }

    #[inline(always)]
    fn last(&self) -> &[Lanes<S>] {
        &self.rows[..self.orders.last().copied().unwrap_or(1)]
    }
}

/// Every factor becomes its products with the entries of a row, from the last on.
#[inline(always)]
fn spread<S: Simd>(factors: &mut Vec<Lanes<S>>, row: &[Lanes<S>]) {
    let count = factors.len();
    factors.resize(count * row.len(), row[0]);
    for i in (0..count).rev() {
        let factor = factors[i];
        for (product, entry) in factors[i * row.len()..].iter_mut().zip(row) {
            *product = factor * *entry;
        }
    }
}

/// `total += factor · Σ value · pole` along a line of poles.
#[inline(always)]
fn add_line<S: Simd, const W: usize, const C: usize>(
    total: &mut [Lanes<S>; C],
    factor: Lanes<S>,
    values: &[Lanes<S>],
    line: &[[f64; W]],
) {
    let sum = line_sums::<S, W, C>(values, line);
    for c in 0..C {
        total[c] = total[c] + factor * sum[c];
    }
}

/// [`Rows::sums`] for the first component of poles of any width.
#[inline(always)]
fn sum_column<S: Simd>(poles: &[f64], width: usize, rows: &impl Rows<S>) -> Lanes<S> {
    let last = rows.last();
    let mut total = Lanes::splat(last[0].simd(), 0.0);
    for (factor, line) in rows.factors().iter().zip(poles.chunks(last.len() * width)) {
        total = total + *factor * column_sum(last, line, width);
    }
    total
}
