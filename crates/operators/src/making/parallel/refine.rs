//! Division small enough for the tolerance.

use pforms_kernel::{Error, Form, Result};

use super::cell::{Cell, square, weight};
use super::distance::{Distance, Quotient};
use super::fold::fold;
use super::interval::Interval;
use super::positive::refuted;
use super::{Field, ParallelOptions, check_options, function};
use crate::Spline;
use crate::measuring::about_one::unit_of;

/// The cells of a form, and the bound on the error of its parallel.
pub(super) struct Division {
    fields: Vec<Field>,
    counts: Vec<usize>,
    breaks: Vec<Vec<f64>>,
    lists: Vec<Vec<Interval>>,
    cells: Vec<Cell>,
    distance: Distance,
    first_weight: f64,
    pub error: f64,
}

/// A form is cut no finer than into so many cells,
const MOST_CELLS: usize = 1 << 12;

/// and into fewer when there is more work in each: multiplications for all of them, about.
const MOST_WORK: f64 = 1e10;

/// Nor into smaller parts of a piece than this: halving has stopped to help.
const NARROWEST: f64 = 1.0 / 1_048_576.0;

/// Halvings of a cell, along all its axes, before a doubt whether it folds counts.
const SHARPER: usize = 3;

/// Roundings that the poles of the result may be off, generously.
const ROUNDINGS: f64 = 64.0;

impl Division {
    pub(super) fn new(
        form: &Spline,
        distance: &Distance,
        options: &ParallelOptions,
    ) -> Result<Self> {
        check_options(options)?;
        distance.check(form.axes())?;
        let unit = unit_of(form.net())?;
        let fields = fields(form, options, unit)?;
        let counts = form.counts();
        let whole = |count: &usize| (0..*count).map(Interval::whole);
        let mut cells = Self {
            lists: counts.iter().map(|count| whole(count).collect()).collect(),
            breaks: form.breaks(),
            fields,
            counts,
            cells: Vec::new(),
            distance: distance.clone(),
            first_weight: form.net().weights()[0],
            error: 0.0,
        };
        let most = cells.farthest()?;
        let rounding = ROUNDINGS * f64::EPSILON * (2.0_f64.powi(unit.clamp(-1022, 1022)) + most);
        let target = (options.tolerance - rounding) / most;
        if target <= 0.0 {
            let received = format!("{:e}, below rounding", options.tolerance);
            return Err(Error::accuracy("tolerance", received, format!("above {rounding:.1e}")));
        }
        let worst = cells.refine(target)?;
        cells.error = most * worst + rounding;
        if !options.folds {
            cells.refuse_folds(2.0_f64.powi(unit))?;
        }
        Ok(cells)
    }

    /// Halves intervals until every cell is good enough; the largest relative error left.
    fn refine(&mut self, target: f64) -> Result<f64> {
        let axes = 0..self.counts.len();
        let largest = |axis| self.fields.iter().map(move |field| field.normal.orders()[axis]).max();
        let plain: Vec<usize> = axes.map(|axis| largest(axis).unwrap_or(1)).collect();
        self.cells = self.computed(&plain)?;
        // A length that is a polynomial has been met already.
        if let Some(worst) = self.good_enough(target) {
            return Ok(worst);
        }
        let order = order_for(target);
        let orders: Vec<usize> =
            plain.iter().map(|&plain| if plain == 1 { 1 } else { plain.max(order) }).collect();
        loop {
            self.cells = self.computed(&orders)?;
            if let Some(worst) = self.good_enough(target) {
                return Ok(worst);
            }
            self.halve(target, &orders)?;
        }
    }

    fn good_enough(&self, target: f64) -> Option<f64> {
        let worst = self.cells.iter().fold(0.0_f64, |worst, cell| worst.max(cell.error));
        (worst <= target).then_some(worst)
    }

    fn computed(&self, orders: &[usize]) -> Result<Vec<Cell>> {
        self.places().iter().map(|place| self.cell(&self.intervals(place), orders)).collect()
    }

    fn cell(&self, intervals: &[Interval], orders: &[usize]) -> Result<Cell> {
        let low: Vec<f64> = intervals.iter().map(|interval| interval.low).collect();
        let high: Vec<f64> = intervals.iter().map(|interval| interval.high).collect();
        Cell::new(self.field(intervals), &low, &high, orders)
    }

    /// Halves, for every cell that is not good enough, the interval that helps most.
    fn halve(&mut self, target: f64, orders: &[usize]) -> Result<()> {
        let mut marked: Vec<Vec<bool>> =
            self.lists.iter().map(|list| vec![false; list.len()]).collect();
        for (place, cell) in self.places().iter().zip(&self.cells) {
            if cell.error > target {
                let intervals = self.intervals(place);
                let axis = self.best_axis(&intervals, orders)?;
                if intervals[axis].high - intervals[axis].low < NARROWEST {
                    return Err(self.stuck(&intervals, cell.error));
                }
                marked[axis][place[axis]] = true;
            }
        }
        for (list, marked) in self.lists.iter_mut().zip(&marked) {
            let pairs = list.iter().zip(marked);
            *list =
                pairs.flat_map(|(one, cut)| if *cut { one.halves() } else { vec![*one] }).collect();
        }
        let count = self.lists.iter().map(Vec::len).product::<usize>();
        let poles = self.fields.iter().map(|field| field.normal.pole_count()).max().unwrap_or(1);
        let most = MOST_CELLS.min((MOST_WORK / (8.0 * poles as f64 * poles as f64)) as usize);
        if count > most {
            let expected = format!("a tolerance that {most} cells reach");
            let received = format!("one that takes {count} cells");
            return Err(Error::accuracy("tolerance", received, expected));
        }
        Ok(())
    }

    /// The axis along which halving leaves the smaller error.
    fn best_axis(&self, intervals: &[Interval], orders: &[usize]) -> Result<usize> {
        let mut best = (0, f64::INFINITY, 0.0);
        for axis in (0..orders.len()).filter(|&axis| orders[axis] > 1) {
            let mut worst = 0.0_f64;
            for half in intervals[axis].halves() {
                let mut part = intervals.to_vec();
                part[axis] = half;
                worst = worst.max(self.cell(&part, orders)?.error);
            }
            let width = intervals[axis].high - intervals[axis].low;
            if worst < best.1 || (worst == best.1 && width > best.2) {
                best = (axis, worst, width);
            }
        }
        Ok(best.0)
    }

    fn stuck(&self, intervals: &[Interval], error: f64) -> Error {
        let middle = vec![0.5; intervals.len()];
        let place = self.place(intervals, &middle);
        if error.is_finite() {
            let received = format!("one that is not reached near parameters {place:?}");
            return Error::accuracy("tolerance", received, "a larger tolerance");
        }
        Error::degenerate(
            "form",
            format!("a form without a normal near parameters {place:?}"),
            "a form whose normals vanish at most on whole edges",
        )
    }

    fn refuse_folds(&self, unit: f64) -> Result<()> {
        for (place, cell) in self.places().iter().zip(&self.cells) {
            if let Some(place) = self.fold_within(&self.intervals(place), cell, unit, SHARPER)? {
                return Err(Error::degenerate(
                    "distance",
                    format!("one that reaches the radius of curvature at parameters {place:?}"),
                    "a shorter one, or folds accepted",
                ));
            }
        }
        Ok(())
    }

    /// Parameters near which the parallel of a cell folds. A doubt may be rounding, of which there is
    /// less in a part than in the whole: it counts when it stays in a part of a part.
    fn fold_within(
        &self,
        intervals: &[Interval],
        cell: &Cell,
        unit: f64,
        halvings: usize,
    ) -> Result<Option<Vec<f64>>> {
        let Some(local) = fold(cell, &self.distance_on(intervals)?, unit)? else {
            return Ok(None);
        };
        if halvings == 0 {
            return Ok(Some(self.place(intervals, &local)));
        }
        let orders: Vec<usize> = cell.length.degrees().iter().map(|degree| degree + 1).collect();
        for part in halved(intervals) {
            let cell = self.cell(&part, &orders)?;
            if let Some(place) = self.fold_within(&part, &cell, unit, halvings - 1)? {
                return Ok(Some(place));
            }
        }
        Ok(None)
    }

    /// One form for each cell, in C order, with weights like those of the original.
    pub(super) fn each(
        &self,
        make: impl Fn(&Cell, &Quotient) -> Result<Form>,
    ) -> Result<Vec<Form>> {
        let pairs = self.places().into_iter().zip(&self.cells);
        let forms = pairs
            .map(|(place, cell)| make(cell, &self.distance_on(&self.intervals(&place))?))
            .collect::<Result<Vec<_>>>()?;
        let factor = self.first_weight / forms[0].weights()[0];
        forms.iter().map(|form| scaled(form, factor)).collect()
    }

    /// The forms of all cells in one spline, after `leading` axes of one piece, and the largest gap.
    pub(super) fn joined(&self, forms: &[Form], leading: usize) -> Result<(Spline, f64)> {
        let ends = |axis: usize| {
            let list = &self.lists[axis];
            let starts = list.iter().map(move |one| self.parameter(axis, one.piece, one.low));
            let last = self.breaks[axis].last().copied();
            starts.chain(last).collect::<Vec<f64>>()
        };
        let mut breaks = vec![vec![0.0, 1.0]; leading];
        breaks.extend((0..self.lists.len()).map(ends));
        super::net::joined(forms, &breaks)
    }

    fn distance_on(&self, intervals: &[Interval]) -> Result<Quotient> {
        let share = |(axis, t): (usize, f64)| {
            let breaks = &self.breaks[axis];
            let (from, to) = (breaks[0], breaks[breaks.len() - 1]);
            (self.parameter(axis, intervals[axis].piece, t) - from) / (to - from)
        };
        let low = intervals.iter().map(|one| one.low).enumerate().map(share);
        let high = intervals.iter().map(|one| one.high).enumerate().map(share);
        self.distance.on(&low.collect::<Vec<_>>(), &high.collect::<Vec<_>>())
    }

    /// The largest distance anywhere.
    fn farthest(&self) -> Result<f64> {
        let axes = self.counts.len();
        Ok(self.distance.on(&vec![0.0; axes], &vec![1.0; axes])?.most)
    }

    /// Which interval along each axis, for every cell in C order.
    fn places(&self) -> Vec<Vec<usize>> {
        let mut all = vec![Vec::new()];
        for list in &self.lists {
            let longer = |place: &Vec<usize>| {
                let place = place.clone();
                (0..list.len()).map(move |i| [place.as_slice(), &[i]].concat())
            };
            all = all.iter().flat_map(longer).collect();
        }
        all
    }

    fn intervals(&self, place: &[usize]) -> Vec<Interval> {
        place.iter().zip(&self.lists).map(|(&i, list)| list[i]).collect()
    }

    fn field(&self, intervals: &[Interval]) -> &Field {
        let flat =
            intervals.iter().zip(&self.counts).fold(0, |flat, (one, n)| flat * n + one.piece);
        &self.fields[flat]
    }

    fn place(&self, intervals: &[Interval], local: &[f64]) -> Vec<f64> {
        let pairs = intervals.iter().zip(local).enumerate();
        pairs
            .map(|(axis, (one, t))| {
                self.parameter(axis, one.piece, one.low + (one.high - one.low) * t)
            })
            .collect()
    }

    fn parameter(&self, axis: usize, piece: usize, t: f64) -> f64 {
        let (from, to) = (self.breaks[axis][piece], self.breaks[axis][piece + 1]);
        if t < 1.0 { from + (to - from) * t } else { to }
    }
}

/// All homogeneous coordinates times a factor, unless that is none.
fn scaled(form: &Form, factor: f64) -> Result<Form> {
    if !factor.is_normal() {
        return Ok(form.clone());
    }
    let weight = form.uniform_weight().map(|weight| weight * factor);
    let scaled = form.map_scalar(|x| x * factor)?;
    Ok(weight.map_or_else(|| scaled.clone(), |weight| scaled.clone().with_uniform_weight(&weight)))
}

/// Poles that lengths deserve: about half a digit each.
fn order_for(target: f64) -> usize {
    ((-target.log10() / 2.0).ceil().max(1.0) as usize + 2).min(9)
}

/// The normals of every piece, in C order, as they are in the parameters of the whole.
fn fields(form: &Spline, options: &ParallelOptions, unit: i32) -> Result<Vec<Field>> {
    let breaks = form.breaks();
    let mut fields = Vec::new();
    let counts = form.counts();
    for flat in 0..counts.iter().product::<usize>() {
        let mut rest = flat;
        let mut index: Vec<usize> = counts.iter().rev().map(|n| (rest % n, rest /= n).0).collect();
        index.reverse();
        let piece = form.piece(&index)?;
        let mut field = Field::new(&piece, &options.side, unit)?;
        require_weight(&field.piece)?;
        require_normals(&field.normal)?;
        let widths = index.iter().zip(&breaks).map(|(&i, list)| list[i + 1] - list[i]);
        let shrink = widths.product::<f64>().powi(-Field::power(&options.side));
        if shrink != 1.0 {
            let normal = field.normal.map_scalar(|x| x * shrink)?;
            field.normal = normal.with_uniform_weight(&1.0);
        }
        fields.push(field);
    }
    Ok(fields)
}

fn require_weight(piece: &Form) -> Result<()> {
    let scaled = weight(piece);
    let orders: Vec<usize> = scaled.degrees().iter().map(|degree| degree + 1).collect();
    let values =
        if orders == piece.orders() { piece.weights() } else { scaled.coefficients().to_vec() };
    match refuted(&function(&values, &orders)?, 0.0, DEEP)? {
        None => Ok(()),
        Some(place) => Err(Error::domain(
            "form",
            format!("a weight that vanishes near {place:?} of a piece"),
            "a form that is finite on its window",
        )),
    }
}

/// Halvings of a piece in search of a zero.
const DEEP: usize = 40;

/// Share of the longest normal that counts as none.
const NONE: f64 = 1e-8;

fn require_normals(normal: &Form) -> Result<()> {
    let square = square(normal)?;
    let most = square.points()?.into_iter().fold(0.0, f64::max);
    match refuted(&square, NONE * NONE * most, DEEP)? {
        None => Ok(()),
        Some(place) => Err(Error::degenerate(
            "form",
            format!("a form without a normal near {place:?} of a piece"),
            "a form whose normals vanish at most on whole edges",
        )),
    }
}

/// All parts that halving along every axis leaves.
fn halved(intervals: &[Interval]) -> Vec<Vec<Interval>> {
    let mut parts = vec![Vec::new()];
    for interval in intervals {
        let longer = |part: &Vec<Interval>| {
            let halves = interval.halves().into_iter();
            halves.map(|half| [&part[..], &[half]].concat()).collect::<Vec<_>>()
        };
        parts = parts.iter().flat_map(longer).collect();
    }
    parts
}
