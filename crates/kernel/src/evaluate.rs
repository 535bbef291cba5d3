//! Evaluate one point, in any scalar.

use crate::jet::vanishing_weight;
use crate::{Form, Result, Scalar, bernstein_row};

impl<S: Scalar> Form<S> {
    /// The homogeneous point at `parameters`: `ambient + 1` numbers, the weight last.
    ///
    /// Any real parameters are legal; `[0, 1]` is the usual window. In `f64` and inside the window
    /// each coordinate is within `2·Σdegrees + axes` roundings of the exact value, relative to
    /// the largest pole.
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
        Ok(point)
    }

    /// The euclidean point at `parameters`: `ambient` numbers.
    ///
    /// Errors: as [`Form::homogeneous_at`], and `Domain` where the weight vanishes.
    pub fn at(&self, parameters: &[S]) -> Result<Vec<S>> {
        let mut point = self.homogeneous_at(parameters)?;
        match point.pop() {
            Some(weight) if !weight.is_zero() => {
                Ok(point.into_iter().map(|x| x / weight.clone()).collect())
            }
            _ => Err(vanishing_weight()),
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
