//! The piece at given parameters.

use pforms_kernel::{Error, Form, Result, Scalar};

use super::{Knots, Spline};

/// A piece of a spline and parameters in it.
#[derive(Clone, Debug, PartialEq)]
pub struct Located<S = f64> {
    /// The piece, a form on the window from 0 to 1.
    pub piece: Form<S>,
    /// Its index along each axis.
    pub index: Vec<usize>,
    /// The parameters as the piece counts them.
    pub parameters: Vec<S>,
    /// How long its window is along each axis of the spline: derivatives of the piece are larger by
    /// these factors than those of the spline.
    pub lengths: Vec<S>,
}

impl<S: Scalar> Spline<S> {
    /// The piece that counts at `parameters`, as for [`Spline::at`]: at a break the one that begins
    /// there, outside the window the outermost.
    ///
    /// Errors: `Shape` unless there is one parameter for each axis; `Domain` when one is not finite.
    ///
    /// ```
    /// use pforms_kernel::Form;
    /// use pforms_operators::subdivide;
    /// let line: Form = Form::from_points(&[2], 1, &[0., 8.], None)?;
    /// let place = subdivide(&line, &[2])?.locate(&[0.375])?;
    /// assert_eq!((place.index, place.parameters, place.lengths), (vec![1], vec![0.5], vec![0.25]));
    /// # Ok::<(), pforms_kernel::Error>(())
    /// ```
    pub fn locate(&self, parameters: &[S]) -> Result<Located<S>> {
        self.net().require_per_axis("parameters", parameters)?;
        if let Some(t) = parameters.iter().find(|t| !t.is_finite()) {
            return Err(Error::domain("parameters", format!("{t:?}"), "finite numbers"));
        }
        let pairs = || self.knots().iter().zip(parameters);
        let spans: Vec<usize> = pairs().map(|(knots, t)| knots.span(t)).collect();
        let place = |((knots, t), &span)| -> (usize, S, S) {
            let knots: &Knots<S> = knots;
            let t: &S = t;
            let index = knots.spans().iter().take_while(|other| **other < span).count();
            (index, knots.local(span, t.clone()), knots.length(span))
        };
        let mut located = Located {
            piece: self.over(&spans)?,
            index: Vec::new(),
            parameters: Vec::new(),
            lengths: Vec::new(),
        };
        for (index, t, length) in pairs().zip(&spans).map(place) {
            located.index.push(index);
            located.parameters.push(t);
            located.lengths.push(length);
        }
        Ok(located)
    }
}
