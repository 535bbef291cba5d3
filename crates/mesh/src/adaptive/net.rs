//! The poles of a patch on a part of its window.

#![allow(
    clippy::inline_always,
    clippy::needless_range_loop,
    reason = "only what is inlined is compiled for the wider sets; lanes are counted, not iterated"
)]

use pforms_kernel::Form;

use crate::space::quadruples;
use crate::vector::Vec3;

/// A pole, or any other homogeneous vector.
pub(crate) type Quadruple = [f64; 4];

/// Homogeneous poles in rows: `poles[i * columns + j]`.
#[derive(Clone, Debug, Default)]
pub(crate) struct Net {
    pub(crate) rows: usize,
    pub(crate) columns: usize,
    pub(crate) poles: Vec<Quadruple>,
}

impl Net {
    /// The net of a surface in space, its axes exchanged if `swapped`, its first weight positive.
    pub(crate) fn of(form: &Form, swapped: bool) -> Self {
        let (orders, all) = (form.orders(), quadruples(form));
        let [rows, columns] = if swapped { [orders[1], orders[0]] } else { [orders[0], orders[1]] };
        let sign = if all.first().is_some_and(|pole| pole[3] < 0.0) { -1.0 } else { 1.0 };
        let at = |k: usize| {
            let (i, j) = (k / columns, k % columns);
            if swapped { all[j * orders[1] + i] } else { all[k] }
        };
        let poles = (0..all.len()).map(|k| at(k).map(|x| sign * x)).collect();
        Self { rows, columns, poles }
    }

    /// Writes the net of the part with row parameters in `[a, b]`.
    pub(crate) fn rows_between(&self, [a, b]: [f64; 2], out: &mut Self) {
        out.clone_from(self);
        let (degree, width) = (self.rows - 1, self.columns);
        let poles = &mut out.poles[..];
        if a > 0.0 {
            for step in 1..=degree {
                for i in 0..=degree - step {
                    let (here, next) = poles[i * width..].split_at_mut(width);
                    blend(here, &next[..width], a);
                }
            }
        }
        if b < 1.0 {
            let t = (b - a) / (1.0 - a);
            for step in 1..=degree {
                for i in (step..=degree).rev() {
                    let (before, here) = poles[(i - 1) * width..].split_at_mut(width);
                    blend(&mut here[..width], before, 1.0 - t);
                }
            }
        }
    }

    /// The homogeneous curve of the row at parameter `u`.
    pub(crate) fn row_at(&self, u: f64, basis: &mut Vec<f64>, out: &mut Vec<Quadruple>) {
        bernstein(self.rows - 1, u, basis);
        self.contracted(basis, out);
    }

    /// The rows summed with these factors.
    pub(crate) fn contracted(&self, factors: &[f64], out: &mut Vec<Quadruple>) {
        out.clear();
        out.resize(self.columns, [0.0; 4]);
        for (factor, row) in factors.iter().zip(self.poles.chunks_exact(self.columns)) {
            for (sum, pole) in out.iter_mut().zip(row) {
                for k in 0..4 {
                    sum[k] += factor * pole[k];
                }
            }
        }
    }
}

/// The point of a homogeneous curve.
pub(crate) fn point_at(curve: &[Quadruple], t: f64, basis: &mut Vec<f64>) -> Vec3 {
    bernstein(curve.len() - 1, t, basis);
    let mut sum = [0.0; 4];
    for (factor, pole) in basis.iter().zip(curve) {
        for k in 0..4 {
            sum[k] += factor * pole[k];
        }
    }
    crate::space::project(&sum)
}

/// The Bernstein polynomials at `t`, by the triangle of de Casteljau.
pub(crate) fn bernstein(degree: usize, t: f64, row: &mut Vec<f64>) {
    row.clear();
    row.push(1.0);
    for _ in 0..degree {
        let mut left = 0.0;
        for entry in row.iter_mut() {
            (left, *entry) = (t * *entry, (1.0 - t) * *entry + left);
        }
        row.push(left);
    }
}

/// Makes the poles of a curve those of its part between `a` and `b`, by de Casteljau twice.
#[inline(always)]
pub(crate) fn narrow(line: &mut [Quadruple], [a, b]: [f64; 2]) {
    let degree = line.len() - 1;
    if a > 0.0 {
        for step in 1..=degree {
            for j in 0..=degree - step {
                line[j] = between(&line[j], &line[j + 1], a);
            }
        }
    }
    if b < 1.0 {
        let t = (b - a) / (1.0 - a);
        for step in 1..=degree {
            for j in (step..=degree).rev() {
                line[j] = between(&line[j - 1], &line[j], t);
            }
        }
    }
}

/// `here = (1 − t)·here + t·next`.
#[inline]
fn blend(here: &mut [Quadruple], next: &[Quadruple], t: f64) {
    for (x, y) in here.iter_mut().zip(next) {
        *x = between(x, y, t);
    }
}

#[inline(always)]
fn between(x: &Quadruple, y: &Quadruple, t: f64) -> Quadruple {
    let (s, mut sum) = (1.0 - t, [0.0; 4]);
    for k in 0..4 {
        sum[k] = s * x[k] + t * y[k];
    }
    sum
}
