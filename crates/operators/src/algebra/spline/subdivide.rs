//! Pieces halved again and again.

use pforms_kernel::{Result, Scalar, limit};

use super::{Knots, Spline};
use crate::algebra::partition::{partition, parts};

impl<S: Scalar> Spline<S> {
    /// Every piece cut into `2^r` along each axis: the refined net, as [`crate::subdivide`] gives
    /// it of a form. Exact but for the rounding of knots.
    ///
    /// Errors: `Shape` unless there is one level for each axis; `Limit`.
    pub fn subdivide(&self, r: &[u32]) -> Result<Self> {
        self.net().require_per_axis("r", r)?;
        let mut orders = Vec::with_capacity(r.len());
        for (knots, &levels) in self.knots().iter().zip(r) {
            let pieces = parts("r", levels)?.saturating_mul(knots.spans().len());
            orders.push(knots.degree().saturating_mul(pieces).saturating_add(1));
        }
        limit::check::<S>("the refined net", &orders, self.net().width())?;
        let knots = self.knots().iter().zip(r).map(|(knots, &levels)| knots.halved(levels));
        self.refined(knots.collect::<Result<_>>()?)
    }
}

impl<S: Scalar> Knots<S> {
    /// Each piece in `2^r`, which meet in poles.
    fn halved(&self, r: u32) -> Result<Self> {
        let mut more = Vec::new();
        for pair in self.breaks().windows(2) {
            let inner = partition(&pair[0], &pair[1], r)?;
            let inner = &inner[1..inner.len() - 1];
            more.extend(inner.iter().flat_map(|t| vec![t.clone(); self.degree()]));
        }
        self.full()?.with(&more)
    }
}
