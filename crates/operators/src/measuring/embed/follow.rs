//! Points that follow a cage.

use pforms_kernel::{Error, Form, Result, Sparse};

use super::NUMBERS;
use crate::{Poles, Shape, pole_derivatives};

/// Where a point stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// In the cage.
    Inside,
    /// Beyond it, with parameters of the cage continued.
    Extended,
    /// Beyond it: it stays where it is.
    Outside,
}

/// Points with their parameters in a cage.
#[derive(Clone, Debug, PartialEq)]
pub struct Embedding {
    /// The parameters, a list for each axis; where the cage begins for points that stay.
    pub parameters: Vec<Vec<f64>>,
    /// The points, one after another.
    pub points: Vec<f64>,
    /// Where each stands.
    pub standings: Vec<Standing>,
    /// Distance from the point to that of the cage at its parameters, at most, rounding included:
    /// proved. Infinite for those that stay.
    pub residuals: Vec<f64>,
    /// How many places of the window give the point: more than one in a cage that folds, of which
    /// the first in the order of the parameters was taken.
    pub counts: Vec<usize>,
    /// Is it proved that there are no other places?
    pub complete: Vec<bool>,
}

impl Embedding {
    /// From rows of parameters, residual, count and completeness.
    pub(super) fn from_rows(rows: &[f64], points: &[f64], axes: usize) -> Self {
        let width = axes + NUMBERS;
        let column = |k: usize| rows[k.min(rows.len())..].iter().step_by(width).copied();
        let standing = |count: f64| match count {
            0.0 => Standing::Outside,
            -1.0 => Standing::Extended,
            _ => Standing::Inside,
        };
        Self {
            parameters: (0..axes).map(|k| column(k).collect()).collect(),
            points: points.to_vec(),
            standings: column(axes + 1).map(standing).collect(),
            residuals: column(axes).collect(),
            counts: column(axes + 1).map(|count| count.max(0.0) as usize).collect(),
            complete: column(axes + 2).map(|complete| complete > 0.0).collect(),
        }
    }

    /// Appends the answers for more points.
    pub fn extend(&mut self, more: Self) {
        for (list, more) in self.parameters.iter_mut().zip(more.parameters) {
            list.extend(more);
        }
        self.points.extend(more.points);
        self.standings.extend(more.standings);
        self.residuals.extend(more.residuals);
        self.counts.extend(more.counts);
        self.complete.extend(more.complete);
    }

    /// Number of points.
    pub fn len(&self) -> usize {
        self.standings.len()
    }

    /// Are there none?
    pub fn is_empty(&self) -> bool {
        self.standings.is_empty()
    }

    /// Which points are in the cage.
    pub fn inside(&self) -> impl Iterator<Item = bool> {
        self.standings.iter().map(|standing| *standing == Standing::Inside)
    }

    /// The points in another cage: those outside stay where they are.
    ///
    /// Errors: `Shape` when the cage has other axes, or another space and points stay; `Domain`
    /// where its weight vanishes.
    pub fn at(&self, cage: &Shape) -> Result<Vec<f64>> {
        let mut moved = vec![0.0; self.len() * cage.net().ambient()];
        self.at_into(cage, &mut moved)?;
        Ok(moved)
    }

    /// [`Embedding::at`] into an array of the caller's.
    ///
    /// Errors: as there, and `Shape` when the array does not fit.
    pub fn at_into(&self, cage: &Shape, out: &mut [f64]) -> Result<()> {
        self.require_axes(cage)?;
        let width = cage.net().ambient();
        let axes = self.parameters.len();
        let staying = || self.standings.iter().enumerate();
        let mut staying =
            staying().filter(|(_, s)| **s == Standing::Outside).map(|(i, _)| i).peekable();
        if staying.peek().is_some() && width != axes {
            let expected = format!("one in {axes}D, where the points outside stay");
            return Err(Error::shape("cage", format!("a cage in {width}D"), expected));
        }
        let lists: Vec<&[f64]> = self.parameters.iter().map(Vec::as_slice).collect();
        match cage {
            Shape::Form(form) => form.scattered_into(&lists, out)?,
            Shape::Spline(spline) => spline.scattered_into(&lists, out)?,
        }
        for i in staying {
            let range = i * axes..(i + 1) * axes;
            out[range.clone()].copy_from_slice(&self.points[range]);
        }
        Ok(())
    }

    /// How each point follows each pole of the cage: a row for each point, a column for each pole, by
    /// which every coordinate of the pole moves that of the point. Rows of points that stay are
    /// empty.
    ///
    /// Errors: as [`Embedding::at`]; `Limit`.
    pub fn sensitivities(&self, cage: &Shape) -> Result<Sparse> {
        self.require_axes(cage)?;
        let count = self.len();
        let mut place = vec![0.0; self.parameters.len()];
        let mut rows = Vec::with_capacity(count);
        for i in 0..count {
            if self.standings[i] == Standing::Outside {
                rows.push(Vec::new());
                continue;
            }
            for (t, list) in place.iter_mut().zip(&self.parameters) {
                *t = list[i];
            }
            rows.push(pole_derivatives(cage, &place)?);
        }
        Sparse::from_rows(cage.net().pole_count(), rows)
    }

    /// Determinants of the derivatives of a cage at the points: where they change sign it folds.
    /// 0 for points that stay.
    ///
    /// Errors: `Shape` unless the cage has as many axes as coordinates; `Domain` where its weight
    /// vanishes.
    pub fn jacobians(&self, cage: &Shape) -> Result<Vec<f64>> {
        self.require_axes(cage)?;
        let (net, axes) = (cage.net(), self.parameters.len());
        if net.ambient() != axes {
            let received = format!("a {} in {}D", net.kind(), net.ambient());
            return Err(Error::shape("cage", received, format!("one in {axes}D")));
        }
        let lists: Vec<&[f64]> = self.parameters.iter().map(Vec::as_slice).collect();
        let mut columns = Vec::with_capacity(axes);
        for axis in 0..axes {
            let mut orders = vec![0; axes];
            orders[axis] = 1;
            let mut column = vec![0.0; self.len() * axes];
            match cage {
                Shape::Form(form) => {
                    form.scattered_derivative_into(&lists, &orders, &mut column)?;
                }
                Shape::Spline(spline) => {
                    spline.scattered_derivative_into(&lists, &orders, &mut column)?;
                }
            }
            columns.push(column);
        }
        let determinant = |i: usize| -> f64 {
            if self.standings[i] == Standing::Outside {
                return 0.0;
            }
            let entries = columns.iter().flat_map(|column| &column[i * axes..(i + 1) * axes]);
            super::matrix::determinant(entries.copied().collect(), axes)
        };
        Ok((0..self.len()).map(determinant).collect())
    }

    fn require_axes(&self, cage: &Shape) -> Result<()> {
        let net: &Form = cage.net();
        if net.axes() == self.parameters.len() {
            return Ok(());
        }
        Err(Error::shape(
            "cage",
            format!("a {}", net.kind()),
            format!("{} axes, as the points are embedded in", self.parameters.len()),
        ))
    }
}
