//! The linear system for the poles that are free.

use pforms_kernel::{Error, Form, Result, Scalar, limit};

use super::energy::{Energy, place};

/// A symmetric positive matrix by its rows from the diagonal on, up to where only zeros follow.
pub(super) struct Banded<S> {
    rows: Vec<Vec<S>>,
}

impl<S: Scalar> Banded<S> {
    pub(super) fn new(rows: Vec<Vec<S>>) -> Self {
        Self { rows }
    }

    /// Takes the matrix apart into `Lᵀ·D·L`: the rows become those of `D·L`.
    ///
    /// No row is exchanged: of a positive matrix none need be. Zeros stay zeros. A pivot that is no
    /// more than `floor` of its diagonal is rounding; `mend` puts the floor itself in its place, and the
    /// matrix is another one nearby.
    ///
    /// Errors: `Accuracy` for such a pivot, unless it is mended, and for numbers that are not finite.
    pub(super) fn factored(mut self, floor: &S, mend: bool) -> Result<Self> {
        let floors: Vec<S> = self.rows.iter().map(|row| row[0].clone() * floor.clone()).collect();
        for (k, floor) in floors.into_iter().enumerate() {
            let (done, rest) = self.rows.split_at_mut(k + 1);
            let row = &mut done[k];
            let small = row[0] <= floor;
            if !row[0].is_finite() || (small && !(mend && floor > S::zero())) {
                let expected = "orders or knots low and even enough to solve for poles";
                return Err(Error::accuracy(
                    "boundary",
                    "a system that rounding makes singular",
                    expected,
                ));
            }
            if small {
                row[0] = floor;
            }
            for (i, target) in (1..row.len()).zip(rest) {
                if !row[i].is_zero() {
                    let factor = -(row[i].clone() / row[0].clone());
                    S::add_multiple(target, &factor, &row[i..]);
                }
            }
        }
        Ok(self)
    }

    /// Solves for several columns, the numbers of one unknown side by side; after [`Self::factored`].
    pub(super) fn solve(&self, values: &mut [S], width: usize) {
        for (k, row) in self.rows.iter().enumerate() {
            let (done, rest) = values.split_at_mut((k + 1) * width);
            let own = &done[k * width..];
            for (entry, target) in row[1..].iter().zip(rest.chunks_exact_mut(width)) {
                if !entry.is_zero() {
                    S::add_multiple(target, &-(entry.clone() / row[0].clone()), own);
                }
            }
        }
        for (k, row) in self.rows.iter().enumerate().rev() {
            let (before, after) = values.split_at_mut((k + 1) * width);
            let own = &mut before[k * width..];
            for (entry, known) in row[1..].iter().zip(after.chunks_exact(width)) {
                if !entry.is_zero() {
                    S::add_multiple(own, &-entry.clone(), known);
                }
            }
            for x in own {
                *x = x.clone() / row[0].clone();
            }
        }
    }
}

/// The net with its free poles where the energy is least; weights are not touched.
///
/// `free` holds the indices of poles in ascending order.
pub(super) fn least<S: Scalar>(
    net: &Form<S>,
    energy: &Energy<S>,
    free: &[usize],
) -> Result<Form<S>> {
    if free.is_empty() {
        return Ok(net.clone());
    }
    let (ambient, width) = (net.ambient(), net.width());
    // The last bit but twenty of numbers of twice the precision; plain ones are for nets alone,
    // whose pivots are above a quarter of the diagonal.
    let floor = if S::EXACT { S::zero() } else { S::one() / S::from_integer(2).power(86) };
    let matrix = between(net.orders(), energy, free)?.factored(&floor, false)?;
    let mut poles = net.homogeneous().to_vec();
    for &index in free {
        poles[index * width..][..ambient].fill(S::zero());
    }
    let slope = energy.gradient(&Form::from_homogeneous(net.orders(), ambient, poles.clone())?)?;
    let mut values: Vec<S> = free
        .iter()
        .flat_map(|&index| slope[index * width..][..ambient].iter().map(|x| -x.clone()))
        .collect();
    matrix.solve(&mut values, ambient);
    for (&index, pole) in free.iter().zip(values.chunks_exact(ambient)) {
        poles[index * width..][..ambient].clone_from_slice(pole);
    }
    let found = Form::from_homogeneous(net.orders(), ambient, poles)?;
    Ok(match net.uniform_weight() {
        Some(weight) => found.with_uniform_weight(weight),
        None => found,
    })
}

/// The entries between free poles.
fn between<S: Scalar>(orders: &[usize], energy: &Energy<S>, free: &[usize]) -> Result<Banded<S>> {
    let mut stride = 1;
    let mut reach = 0;
    for (axis, order) in orders.iter().enumerate().rev() {
        reach += energy.reach(axis) * stride;
        stride *= order;
    }
    let width = free.len().min(reach + 1);
    limit::check::<S>("the system for the free poles", &[free.len(), width], 1)?;
    let places: Vec<Vec<usize>> = free.iter().map(|&index| place(index, orders)).collect();
    let row = |k: usize| {
        let near = free[k..].iter().take_while(|&&index| index - free[k] <= reach).count();
        places[k..k + near].iter().map(|other| energy.entry(&places[k], other)).collect()
    };
    Ok(Banded::new((0..free.len()).map(row).collect()))
}
