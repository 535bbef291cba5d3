//! The four edges of a patch, sampled so that neighbours agree to the last bit.

use pforms_kernel::{Form, Result};

use crate::space::{project, quadruples};
use crate::vector::{Vec3, norm, subtract};

/// Poles of an edge count as one point within this many roundings of the largest coordinate.
const ROUNDINGS: f64 = 16.0 * f64::EPSILON;

/// An edge of a patch as a curve, in the direction both neighbours agree on.
#[derive(Clone, Debug)]
pub(crate) struct Edge {
    poles: Vec<[f64; 4]>,
    reversed: bool,
}

/// What two edges have in common when they are the same curve.
pub(crate) type Key = Vec<[u64; 4]>;

impl Edge {
    /// The edge along the free axis of the border where `fixed` is 0 or 1.
    pub(crate) fn of(form: &Form, fixed: usize, high: bool) -> Self {
        let (orders, all) = (form.orders(), quadruples(form));
        let index = if high { orders[fixed] - 1 } else { 0 };
        let poles: Vec<[f64; 4]> =
            (0..orders[1 - fixed])
                .map(|k| {
                    if fixed == 0 { all[index * orders[1] + k] } else { all[k * orders[1] + index] }
                })
                // Adding 0 turns −0 into 0: the same place must have the same bits.
                .map(|pole| pole.map(|x| x + 0.0))
                .collect();
        let backwards: Vec<[f64; 4]> = poles.iter().rev().copied().collect();
        let reversed = backwards.partial_cmp(&poles).is_some_and(std::cmp::Ordering::is_lt);
        Self { poles: if reversed { backwards } else { poles }, reversed }
    }

    /// The bits of the poles: equal for two edges that are one curve run either way.
    pub(crate) fn key(&self) -> Key {
        self.poles.iter().map(|pole| pole.map(f64::to_bits)).collect()
    }

    /// Does the patch run against the direction both neighbours agree on?
    pub(crate) fn is_reversed(&self) -> bool {
        self.reversed
    }

    /// The points at these parameters, in the direction both neighbours agree on.
    ///
    /// An edge whose poles are all one point is that point, whatever the weights.
    pub(crate) fn points(&self, ticks: &[f64]) -> Result<Vec<Vec3>> {
        if let Some(point) = self.single_point() {
            return Ok(vec![point; ticks.len()]);
        }
        let form = Form::from_homogeneous(&[self.poles.len()], 3, self.poles.concat())?;
        let mut points = vec![[0.0; 3]; ticks.len()];
        form.grid_into(&[ticks], points.as_flattened_mut())?;
        Ok(points)
    }

    /// The point an edge has collapsed to, if it has: all poles are multiples of it, and of weight 0
    /// only the one that is nothing at all.
    pub(crate) fn single_point(&self) -> Option<Vec3> {
        let first = project(self.poles.iter().find(|pole| pole[3] != 0.0)?);
        let heaviest = self.poles.iter().fold(0.0_f64, |most, pole| most.max(pole[3].abs()));
        let size = norm(first);
        let same = |pole: &[f64; 4]| match *pole {
            [x, y, z, 0.0] => norm([x, y, z]) <= ROUNDINGS * size * heaviest,
            pole => norm(subtract(project(&pole), first)) <= ROUNDINGS * size,
        };
        self.poles.iter().all(same).then_some(first)
    }
}
