//! Coons patches of any dimension: the form that its faces span.
//!
//! With `P_k` the linear blend between the two faces across axis `k`, the patch is the Boolean sum
//! `1 − Π (1 − P_k)`: of four curves `P_u + P_v − P_u·P_v`, two ruled surfaces less a facet
//! (Coons 1967; Gordon 1971; book 332).

mod faces;
mod meeting;
mod net;
mod pointwise;
mod spline;

use pforms_kernel::{Error, Form, Result, Scalar};

use faces::Faces;

pub use spline::coons_splines;

/// What a Coons patch is asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct CoonsOptions<S = f64> {
    /// Largest gap between faces that should meet, as a fraction of the largest coordinate.
    pub accuracy: S,
    /// Blend the euclidean points, whatever the weights: orders of rational faces add up.
    pub pointwise: bool,
}

impl<S: Scalar> Default for CoonsOptions<S> {
    /// Homogeneous; no gap at all in exact arithmetic, one of 10⁻⁹ in floating.
    fn default() -> Self {
        let accuracy = if S::EXACT { S::zero() } else { S::ratio(1, 1_000_000_000) };
        Self { accuracy, pointwise: false }
    }
}

/// The form of `d` axes spanned by its `2d` faces, forms of `d − 1` axes.
///
/// Faces come in pairs, those across the last axis first: of a surface `(v=0, v=1, u=0, u=1)`, of a
/// volume `(w=0, w=1, v=0, v=1, u=0, u=1)`, of a curve its ends. The axes of a face are those of the
/// patch that are left, in their order, and run the same way. Orders may differ: each is raised to
/// the largest along its axis.
///
/// The faces of the result are the given ones, exactly; where two meet within the accuracy only,
/// the one given first is kept. Rational faces are blended with their weights when these agree
/// where faces meet, if need be after a constant factor for each face. Otherwise, and when
/// `pointwise` is set, the euclidean points are blended over a common denominator: the faces are
/// the same points at the same parameters, with other weights, and no new weight vanishes.
///
/// Errors: `Shape` for a wrong number of faces, of axes or of coordinates; `Domain` naming the corner
/// or edge and the gap where faces do not meet, and for corners at infinity that are to be blended
/// pointwise; `Limit`.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{CoonsOptions, coons};
/// let curve = |points: &[f64]| Form::from_points(&[points.len() / 3], 3, points, None);
/// let (c0, c1) = (curve(&[0., 0., 0., 1., 0., 0.])?, curve(&[0., 1., 0., 1., 1., 0.])?);
/// let (d0, d1) = (curve(&[0., 0., 0., 0., 0.5, 1., 0., 1., 0.])?, curve(&[1., 0., 0., 1., 1., 0.])?);
/// let patch = coons(&[&c0, &c1, &d0, &d1], &CoonsOptions::default())?;
/// assert_eq!(patch.kind().to_string(), "pS23");
/// assert_eq!(patch.at(&[0.5, 0.5])?, [0.5, 0.5, 0.25]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn coons<S: Scalar>(faces: &[&Form<S>], options: &CoonsOptions<S>) -> Result<Form<S>> {
    require_accuracy(&options.accuracy)?;
    let given = Faces::new(faces)?;
    let raised = given.raised()?;
    meeting::require_corners(&raised, &options.accuracy)?;
    if !options.pointwise
        && let Some(scaled) = meeting::on_one_scale(&raised, &options.accuracy)?
    {
        let at: Vec<Vec<S>> = scaled.orders().iter().map(|&order| even(order)).collect();
        return net::filled(&scaled, &at);
    }
    meeting::require_edges(&raised, &options.accuracy, |part, _| Ok(vec![part.clone()]))?;
    pointwise::blended(&given)
}

fn require_accuracy<S: Scalar>(accuracy: &S) -> Result<()> {
    if accuracy.is_finite() && *accuracy >= S::zero() {
        return Ok(());
    }
    Err(Error::domain("accuracy", format!("{accuracy:?}"), "a finite number of at least 0"))
}

/// The parameter itself as a form of the given order: its poles are evenly spread.
fn even<S: Scalar>(order: usize) -> Vec<S> {
    (0..order).map(|i| S::ratio(i as i64, order as i64 - 1)).collect()
}

/// The size of a number.
fn size<S: Scalar>(x: &S) -> S {
    if *x < S::zero() { -x.clone() } else { x.clone() }
}

/// The larger of two numbers.
fn larger<S: Scalar>(x: S, y: S) -> S {
    if x >= y { x } else { y }
}
