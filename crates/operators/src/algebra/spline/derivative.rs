//! Derivatives of splines.

use pforms_kernel::{Form, Result, Scalar};

use super::{Knots, Spline};
use crate::derivative;

impl<S: Scalar> Spline<S> {
    /// The derivative `∂^orders`, as a spline whose points are the derivative vectors: that of each
    /// piece, see [`derivative`], with the length of its window divided out. Exact.
    ///
    /// At a knot repeated `m` times the derivatives above the `(p − m)`-th may jump: there the
    /// pieces keep their own end poles.
    ///
    /// Errors: `Shape` unless there is one order for each axis; `Limit`.
    pub fn derivative(&self, orders: &[usize]) -> Result<Self> {
        self.net.require_per_axis("orders", orders)?;
        let parted = self.parted_by(orders)?;
        parted.map_pieces(|piece, window| {
            let mut factor = S::one();
            for ((from, to), &order) in window.iter().zip(orders) {
                factor = factor / (to.clone() - from.clone()).power(order);
            }
            scaled(&derivative(piece, orders)?, &factor)
        })
    }

    /// The first derivative along `axis`, see [`Spline::derivative`].
    ///
    /// Errors: `Shape` when there is no such axis; `Limit`.
    pub fn hodograph(&self, axis: usize) -> Result<Self> {
        self.net.require_axis(axis)?;
        let orders: Vec<usize> = (0..self.axes()).map(|k| usize::from(k == axis)).collect();
        self.derivative(&orders)
    }

    /// The same spline with a gap at each knot where the derivatives may jump.
    pub(crate) fn parted_by(&self, orders: &[usize]) -> Result<Self> {
        let part = |(knots, &order): (&Knots<S>, &usize)| -> Result<Knots<S>> {
            let mut more = Vec::new();
            let breaks = knots.breaks();
            for t in breaks.iter().skip(1).take(breaks.len().saturating_sub(2)) {
                let times = knots.multiplicity(t);
                if order > 0 && times + order > knots.degree() {
                    more.extend(vec![t.clone(); knots.degree() + 1 - times]);
                }
            }
            knots.with(&more)
        };
        let knots = self.knots.iter().zip(orders).map(part).collect::<Result<Vec<_>>>()?;
        self.refined(knots)
    }
}

/// Coordinates times `factor`, weights as they are.
fn scaled<S: Scalar>(form: &Form<S>, factor: &S) -> Result<Form<S>> {
    let width = form.width();
    let mut poles = form.homogeneous().to_vec();
    for pole in poles.chunks_exact_mut(width) {
        for x in &mut pole[..width - 1] {
            *x = x.clone() * factor.clone();
        }
    }
    Form::from_homogeneous(form.orders(), form.ambient(), poles)
}
