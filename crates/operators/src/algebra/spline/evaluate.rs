//! Points of a spline.

use pforms_kernel::{Error, Form, Result, Scalar};

use super::Spline;

impl<S: Scalar> Spline<S> {
    /// The homogeneous point at `parameters`; outside the window the outermost pieces go on, and at
    /// a gap the piece that begins there counts. Exact.
    ///
    /// Errors: `Shape` unless there is one parameter for each axis; `Domain` when one is not finite.
    pub fn homogeneous_at(&self, parameters: &[S]) -> Result<Vec<S>> {
        self.net.require_per_axis("parameters", parameters)?;
        if let Some(t) = parameters.iter().find(|t| !t.is_finite()) {
            return Err(Error::domain("parameters", format!("{t:?}"), "finite numbers"));
        }
        let (spans, factors): (Vec<usize>, Vec<Vec<S>>) = self
            .knots
            .iter()
            .zip(parameters)
            .map(|(knots, t)| {
                let (first, factors) = knots.basis(t);
                (first + knots.degree(), factors)
            })
            .unzip();
        // Only the poles of one piece count.
        let mut poles = Vec::new();
        self.copy(&spans, self.net.homogeneous(), &mut poles);
        let weight = poles[self.ambient()].clone();
        let one_weight = poles.chunks_exact(self.net.width()).all(|p| p[self.ambient()] == weight);
        for factors in &factors {
            let share = poles.len() / factors.len();
            let mut sum = vec![S::zero(); share];
            for (factor, line) in factors.iter().zip(poles.chunks_exact(share)) {
                S::add_multiple(&mut sum, factor, line);
            }
            poles = sum;
        }
        if one_weight {
            poles[self.ambient()] = weight;
        }
        Ok(poles)
    }

    /// The euclidean point at `parameters`, as [`Spline::homogeneous_at`].
    ///
    /// Errors: as there, and `Domain` where the weight vanishes.
    pub fn at(&self, parameters: &[S]) -> Result<Vec<S>> {
        Form::from_homogeneous(&[], self.ambient(), self.homogeneous_at(parameters)?)?.at(&[])
    }
}
