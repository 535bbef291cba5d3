//! Points on grids: the net is contracted axis after axis, and the last axis runs in lanes.

#![allow(clippy::inline_always, reason = "only what is inlined is compiled for the wider sets")]

use crate::basis::bernstein_row_into;
use crate::lanes::{Job, Lanes, MOST, bernstein};
use crate::planar::{BLOCK, Planar};
use crate::{Form, Result, bernstein_row};

/// Numbers in a table of basis values at most: they stay in the second cache.
const TABLE: usize = 1 << 14;

/// The points of forms on the grid of `parameters`, one list for each axis: a grid for each form.
pub(crate) struct Grids<'a> {
    pub forms: &'a [&'a Form<f64>],
    pub parameters: &'a [&'a [f64]],
    pub out: &'a mut [f64],
}

impl Job for Grids<'_> {
    type Output = Result<()>;

    #[inline(always)]
    fn run<const N: usize>(self) -> Result<()> {
        let points: usize = self.parameters.iter().map(|list| list.len()).product();
        let mut rest = self.out;
        let mut plan: Option<Plan<N>> = None;
        for form in self.forms {
            let (part, others) = rest.split_at_mut(points * form.ambient());
            rest = others;
            let plan = match &mut plan {
                Some(plan) if plan.orders == form.orders() => plan,
                plan => plan.insert(Plan::new(form, self.parameters)),
            };
            plan.write(form, part)?;
        }
        Ok(())
    }
}

/// Tables and buffers for the grids of forms of the same orders.
struct Plan<'a, const N: usize> {
    orders: Vec<usize>,
    leading: Vec<Leading<'a>>,
    last: Last<'a, N>,
    planar: Planar,
}

impl<'a, const N: usize> Plan<'a, N> {
    fn new(form: &Form<f64>, parameters: &[&'a [f64]]) -> Self {
        let mut axes = parameters.iter().zip(form.orders());
        let last = axes.next_back().map_or((&[0.0][..], 1), |(list, order)| (*list, *order));
        Self {
            orders: form.orders().to_vec(),
            leading: axes.map(|(list, order)| Leading::new(list, *order)).collect(),
            last: Last::new(last.0, last.1),
            planar: Planar::default(),
        }
    }

    #[inline(always)]
    fn write(&mut self, form: &Form<f64>, out: &mut [f64]) -> Result<()> {
        let Self { leading, last, planar, .. } = self;
        planar.begin(form);
        let (ambient, length) = (form.ambient(), last.list.len());
        let lines: usize = leading.iter().map(|axis| axis.list.len()).product();
        for tile in 0..length.div_ceil(last.tile) {
            let samples = last.fill(tile);
            let together = if samples == length { BLOCK / length } else { 1 };
            for first in (0..lines).step_by(together) {
                let group = first..lines.min(first + together);
                for (place, line) in group.clone().enumerate() {
                    let anew = tile == 0 && line == 0;
                    let poles = contract_leading::<N>(form, leading, line, anew);
                    last.put(poles, form.width(), samples, planar, place * samples);
                }
                let start = (first * length + tile * last.tile) * ambient;
                planar.project(&mut out[start..][..group.len() * samples * ambient])?;
            }
        }
        Ok(())
    }
}

/// An axis that is contracted for one sample after another.
struct Leading<'a> {
    list: &'a [f64],
    order: usize,
    /// The basis values of all samples, where they are few.
    table: Vec<f64>,
    row: Vec<f64>,
    /// The poles contracted along this axis and those before it, at sample `at`.
    line: Vec<f64>,
    at: usize,
}

impl<'a> Leading<'a> {
    fn new(list: &'a [f64], order: usize) -> Self {
        let few = list.len().saturating_mul(order) <= TABLE;
        let samples = if few { list } else { &[] };
        let table = samples.iter().flat_map(|t| bernstein_row(order - 1, t)).collect();
        Self { list, order, table, row: Vec::new(), line: Vec::new(), at: 0 }
    }

    /// Contracts the poles with the basis values at a sample.
    #[inline(always)]
    fn contract<const N: usize>(&mut self, poles: &[f64], at: usize) {
        self.at = at;
        let row = if self.table.is_empty() {
            bernstein_row_into(self.order - 1, &self.list[at], &mut self.row);
            &self.row[..]
        } else {
            &self.table[at * self.order..][..self.order]
        };
        let inner = poles.len() / self.order;
        self.line.resize(inner, 0.0);
        combine::<N>(row, poles, &mut self.line);
    }
}

/// The poles at sample `line` of the leading axes, the last of which runs fastest. Only what has
/// changed since the line before is contracted again, or everything `anew`.
#[inline(always)]
fn contract_leading<'a, const N: usize>(
    form: &'a Form<f64>,
    leading: &'a mut [Leading],
    line: usize,
    anew: bool,
) -> &'a [f64] {
    let mut stride: usize = leading.iter().map(|axis| axis.list.len()).product();
    let mut changed = anew;
    for k in 0..leading.len() {
        let (before, here) = leading.split_at_mut(k);
        let poles = before.last().map_or(form.homogeneous(), |axis| &axis.line);
        stride /= here[0].list.len();
        let at = line / stride % here[0].list.len();
        changed |= here[0].at != at;
        if changed {
            here[0].contract::<N>(poles, at);
        }
    }
    leading.last().map_or(form.homogeneous(), |axis| &axis.line)
}

/// `line = Σ row · poles`, lines of poles.
#[inline(always)]
fn combine<const N: usize>(row: &[f64], poles: &[f64], line: &mut [f64]) {
    let inner = line.len();
    for start in (0..inner / N * N).step_by(N) {
        let mut sum = Lanes::<N>::ZERO;
        for (entry, pole) in row.iter().zip(poles.chunks_exact(inner)) {
            sum = sum + Lanes::splat(*entry) * Lanes::load(&pole[start..]);
        }
        sum.store(&mut line[start..]);
    }
    for k in inner / N * N..inner {
        let terms = row.iter().zip(poles.chunks_exact(inner));
        line[k] = terms.fold(0.0, |sum, (entry, pole)| sum + entry * pole[k]);
    }
}

/// The last axis: its samples in tiles, with their basis values in columns.
struct Last<'a, const N: usize> {
    list: &'a [f64],
    /// Samples of a tile, and the length of a column, which holds whole lanes.
    tile: usize,
    column: usize,
    table: Vec<f64>,
    filled: Option<usize>,
    row: Vec<Lanes<N>>,
}

impl<'a, const N: usize> Last<'a, N> {
    fn new(list: &'a [f64], order: usize) -> Self {
        let most = (TABLE / order / MOST * MOST).clamp(MOST, BLOCK);
        let tile = list.len().min(most);
        let column = tile.next_multiple_of(MOST);
        let table = vec![0.0; order * column];
        Self { list, tile, column, table, filled: None, row: vec![Lanes::ZERO; order] }
    }

    /// Makes the table of a tile, unless it is there; tells the number of samples.
    #[inline(always)]
    fn fill(&mut self, tile: usize) -> usize {
        let list = &self.list[tile * self.tile..];
        let list = &list[..list.len().min(self.tile)];
        if self.filled != Some(tile) {
            self.filled = Some(tile);
            for at in (0..list.len()).step_by(N) {
                bernstein(Lanes::load_some(&list[at..]), &mut self.row);
                for (values, column) in
                    self.row.iter().zip(self.table.chunks_exact_mut(self.column))
                {
                    values.store(&mut column[at..]);
                }
            }
        }
        list.len()
    }

    /// Puts down the points of a line of poles at the samples of the tile.
    #[inline(always)]
    fn put(&self, line: &[f64], width: usize, samples: usize, planar: &mut Planar, place: usize) {
        match (width, planar.columns()) {
            (4, 4) => self.put_all::<4, 4>(line, samples, planar, place),
            (4, 3) => self.put_all::<4, 3>(line, samples, planar, place),
            (3, 3) => self.put_all::<3, 3>(line, samples, planar, place),
            (3, 2) => self.put_all::<3, 2>(line, samples, planar, place),
            (width, columns) => {
                for column in 0..columns {
                    self.put_column(&line[column..], width, samples, planar, column, place);
                }
            }
        }
    }

    /// The same for the first `C` components of poles of `W` numbers.
    #[inline(always)]
    fn put_all<const W: usize, const C: usize>(
        &self,
        line: &[f64],
        samples: usize,
        planar: &mut Planar,
        place: usize,
    ) {
        let (poles, _) = line.as_chunks::<W>();
        for at in (0..samples).step_by(N) {
            let mut sum = [Lanes::<N>::ZERO; C];
            for (column, pole) in self.table.chunks_exact(self.column).zip(poles) {
                let values = Lanes::load(&column[at..]);
                for c in 0..C {
                    sum[c] = sum[c] + values * Lanes::splat(pole[c]);
                }
            }
            planar.put(0, place + at, &sum);
        }
    }

    /// The same for one component of poles of any width.
    #[inline(always)]
    fn put_column(
        &self,
        line: &[f64],
        width: usize,
        samples: usize,
        planar: &mut Planar,
        column: usize,
        place: usize,
    ) {
        for at in (0..samples).step_by(N) {
            let mut sum = Lanes::<N>::ZERO;
            for (values, pole) in self.table.chunks_exact(self.column).zip(line.chunks(width)) {
                sum = sum + Lanes::load(&values[at..]) * Lanes::splat(pole[0]);
            }
            planar.put(column, place + at, &[sum]);
        }
    }
}
