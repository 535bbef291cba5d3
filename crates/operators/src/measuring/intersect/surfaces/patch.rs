//! A piece of a surface, and its point and derivatives at any parameters.

use pforms_kernel::Form;
use smallvec::{SmallVec, smallvec};

use super::space::{V3, times};

/// A surface of space over the window from 0 to 1: homogeneous poles, weights positive.
#[derive(Clone)]
pub(super) struct Patch {
    /// Number of poles along each axis.
    pub orders: [usize; 2],
    /// The poles, the weight last, the last axis fastest.
    pub poles: Vec<[f64; 4]>,
    /// Are all weights 1?
    polynomial: bool,
}

/// A point of a surface with its derivatives; those of second order are 0 unless asked for.
#[derive(Clone, Copy, Default)]
pub(super) struct Jet {
    pub p: V3,
    pub u: V3,
    pub v: V3,
    pub uu: V3,
    pub uv: V3,
    pub vv: V3,
}

/// Values, first and second derivatives of the Bernstein polynomials at a parameter.
struct Basis {
    rows: [SmallVec<[f64; 8]>; 3],
}

impl Patch {
    /// The form about `centre`, in units of `scale`, its weights divided by `weight`.
    pub(super) fn new(form: &Form, centre: &V3, scale: f64, weight: f64) -> Self {
        let polynomial = !form.is_rational();
        let place = |pole: &[f64]| {
            let w = if polynomial { 1.0 } else { pole[3] / weight };
            // A pole that is a point is divided first, so that what is far and small keeps its digits.
            let coordinate = |k: usize| {
                if pole[3] * weight > 0.0 {
                    (pole[k] / pole[3] - centre[k]) / scale * w
                } else {
                    (pole[k] / weight - centre[k] * w) / scale
                }
            };
            [coordinate(0), coordinate(1), coordinate(2), w]
        };
        let poles = form.homogeneous().chunks_exact(4).map(place).collect();
        Self { orders: [form.orders()[0], form.orders()[1]], poles, polynomial }
    }

    /// The point and the derivatives, those of second order if `SECOND`.
    pub(super) fn jet<const SECOND: bool>(&self, u: f64, v: f64) -> Jet {
        let across = Basis::at(self.orders[0] - 1, u, SECOND);
        let along = Basis::at(self.orders[1] - 1, v, SECOND);
        // Homogeneous: the point, u, v, uu, uv, vv.
        let mut all = [[0.0; 4]; 6];
        for (i, row) in self.poles.chunks_exact(self.orders[1]).enumerate() {
            let mut line = [[0.0; 4]; 3];
            for (j, pole) in row.iter().enumerate() {
                for (sum, rows) in line.iter_mut().zip(&along.rows[..2 + usize::from(SECOND)]) {
                    (0..4).for_each(|k| sum[k] += rows[j] * pole[k]);
                }
            }
            let [b, b1] = [across.rows[0][i], across.rows[1][i]];
            for k in 0..4 {
                all[0][k] += b * line[0][k];
                all[1][k] += b1 * line[0][k];
                all[2][k] += b * line[1][k];
            }
            if SECOND {
                let b2 = across.rows[2][i];
                for k in 0..4 {
                    all[3][k] += b2 * line[0][k];
                    all[4][k] += b1 * line[1][k];
                    all[5][k] += b * line[2][k];
                }
            }
        }
        self.divided::<SECOND>(&all)
    }

    /// The point alone.
    pub(super) fn point(&self, u: f64, v: f64) -> V3 {
        self.jet::<false>(u, v).p
    }

    fn divided<const SECOND: bool>(&self, h: &[[f64; 4]; 6]) -> Jet {
        let part = |i: usize| [h[i][0], h[i][1], h[i][2]];
        if self.polynomial {
            let [p, u, v, uu, uv, vv] = [0, 1, 2, 3, 4, 5].map(part);
            return Jet { p, u, v, uu, uv, vv };
        }
        let share = 1.0 / h[0][3];
        let w = |i: usize| h[i][3] * share;
        let p = times(&part(0), share);
        let first = |i: usize| -> V3 { std::array::from_fn(|k| h[i][k] * share - p[k] * w(i)) };
        let (u, v) = (first(1), first(2));
        if !SECOND {
            return Jet { p, u, v, ..Jet::default() };
        }
        let second = |i: usize, a: (&V3, usize), b: (&V3, usize)| -> V3 {
            std::array::from_fn(|k| {
                h[i][k] * share - a.0[k] * w(b.1) - b.0[k] * w(a.1) - p[k] * w(i)
            })
        };
        let (du, dv) = ((&u, 1), (&v, 2));
        let [uu, uv, vv] = [second(3, du, du), second(4, du, dv), second(5, dv, dv)];
        Jet { p, u, v, uu, uv, vv }
    }
}

impl Basis {
    /// By the triangle of Bernstein polynomials, of which the last three rows are kept.
    fn at(degree: usize, t: f64, second: bool) -> Self {
        let mut row: SmallVec<[f64; 8]> = smallvec![0.0; degree + 1];
        let mut rows = [row.clone(), row.clone(), row.clone()];
        row[0] = 1.0;
        for step in 0..=degree {
            // Here `row` holds the polynomials of degree `step`.
            let n = degree as f64;
            let at = |k: usize, back: usize| if k < back { 0.0 } else { row[k - back] };
            if step + 2 == degree && second {
                for (k, x) in rows[2].iter_mut().enumerate() {
                    *x = n * (n - 1.0) * (at(k, 2) - 2.0 * at(k, 1) + at(k, 0));
                }
            }
            if step + 1 == degree {
                (0..=degree).for_each(|k| rows[1][k] = n * (at(k, 1) - at(k, 0)));
            }
            if step < degree {
                for k in (0..=step + 1).rev() {
                    let before = if k == 0 { 0.0 } else { row[k - 1] };
                    row[k] = (1.0 - t) * row[k] + t * before;
                }
            }
        }
        rows[0] = row;
        Self { rows }
    }
}
