//! Evaluate one point, in any scalar.

use crate::jet::unreachable;
use crate::{Form, Result, Scalar, bernstein_row};

impl<S: Scalar> Form<S> {
    /// The homogeneous point at `parameters`: `ambient + 1` numbers, the weight last.
    ///
    /// Any real parameters are legal; `[0, 1]` is the usual window. In `f64` and inside the window
    /// each coordinate is within `2·Σdegrees + axes` roundings of the exact value, relative to
    /// the largest pole; a weight that all poles share is the weight of the point to the bit.
    ///
    /// Errors: `Shape` unless there is one parameter for each axis; `Domain` when one is not finite.
    pub fn homogeneous_at(&self, parameters: &[S]) -> Result<Vec<S>> {
        self.require_parameters(parameters)?;
        let mut point = self.homogeneous().to_vec();
        for (t, order) in parameters.iter().zip(self.orders()) {
            let inner = point.len() / order;
            let row = bernstein_row(order - 1, t);
            let mut sum = vec![S::zero(); inner];
            for (coefficient, line) in row.iter().zip(point.chunks_exact(inner)) {
                S::add_multiple(&mut sum, coefficient, line);
            }
            point = sum;
        }
        if let Some(weight) = self.uniform_weight() {
            point[self.ambient()] = weight.clone();
        }
        Ok(point)
    }

    /// The euclidean point at `parameters`: `ambient` numbers.
    ///
    /// Errors: as [`Form::homogeneous_at`], and `Domain` where the weight vanishes or a coordinate
    /// overflows.
    pub fn at(&self, parameters: &[S]) -> Result<Vec<S>> {
        let mut point = self.homogeneous_at(parameters)?;
        let weight = point.pop().unwrap_or_else(S::zero);
        if weight.is_zero() || !weight.is_finite() {
            return Err(unreachable(&weight));
        }
        for x in &mut point {
            *x = x.clone() / weight.clone();
        }
        match point.iter().all(S::is_finite) {
            true => Ok(point),
            false => Err(unreachable(&weight)),
        }
    }

    pub(crate) fn require_parameters(&self, parameters: &[S]) -> Result<()> {
        self.require_per_axis("parameters", parameters)?;
        match parameters.iter().position(|t| !t.is_finite()) {
            None => Ok(()),
            Some(axis) => Err(crate::Error::domain(
                "parameters",
                format!("{:?} on axis {axis}", parameters[axis]),
                "finite numbers",
            )),
        }
    }
}
