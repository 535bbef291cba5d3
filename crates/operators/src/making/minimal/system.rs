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
    /// No row is exchanged: of a positive matrix none need be. Zeros stay zeros.
    ///
    /// Errors: `Degenerate` when a pivot is not positive.
    pub(super) fn factored(mut self) -> Result<Self> {
        for k in 0..self.rows.len() {
            let (done, rest) = self.rows.split_at_mut(k + 1);
            let row = &done[k];
            if row[0] <= S::zero() || !row[0].is_finite() {
                let received = format!("{:?} as pivot {k}", row[0]);
                return Err(Error::degenerate("boundary", received, "poles that are determined"));
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
    let matrix = between(net.orders(), energy, free)?.factored()?;
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
