//! Extrusion: a form moved along a path, and all it passes through.

use pforms_kernel::{Error, Form, Result, Scalar, limit};

use super::transform::require_in_space;
use super::{Knots, Poles, Shape, Spline};

/// The form `path(s) + form(t)`: the form carried along by the vectors of the path.
///
/// The axes of the path come first. Exact, of any dimensions, rational or not: poles are
/// `(x·v + w·q, w·v)` for a pole `(x, w)` of the form and `(q, v)` of the path. With a curve and a curve
/// this is the surface of translation; with a segment from the origin, see [`extrude`], a prism.
///
/// Errors: `Shape` when the spaces differ; `Limit`.
///
/// ```
/// use pforms_kernel::Form;
/// let arch: Form = Form::from_points(&[3], 3, &[0., 0., 0., 1., 0., 2., 2., 0., 0.], None)?;
/// let rail = Form::from_points(&[3], 3, &[0., 0., 0., 0., 1., 1., 0., 2., 0.], None)?;
/// let roof = pforms_operators::extrude_along(&arch, &rail)?;
/// assert_eq!(roof.kind().to_string(), "pS33");
/// assert_eq!(roof.at(&[0.5, 0.5])?, [1., 1., 1.5]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn extrude_along<S: Scalar>(form: &Form<S>, path: &Form<S>) -> Result<Form<S>> {
    let ambient = form.ambient();
    if path.ambient() != ambient {
        return Err(Error::shape(
            "path",
            format!("a {} in {}D", path.kind(), path.ambient()),
            format!("one in {ambient}D, as the form is"),
        ));
    }
    let orders = [path.orders(), form.orders()].concat();
    let count = limit::check::<S>("the extrusion", &orders, form.width())?;
    let mut poles = Vec::with_capacity(count);
    for along in path.homogeneous().chunks_exact(path.width()) {
        for pole in form.homogeneous().chunks_exact(form.width()) {
            let (v, w) = (&along[ambient], &pole[ambient]);
            let pairs = pole.iter().zip(along).take(ambient);
            poles.extend(pairs.map(|(x, q)| x.clone() * v.clone() + w.clone() * q.clone()));
            poles.push(w.clone() * v.clone());
        }
    }
    Form::from_homogeneous(&orders, ambient, poles)
}

/// The form moved by a vector and all between: a new axis 0 of two poles.
///
/// Exact; the far end is [`translate`](super::translate) of the near one.
///
/// Errors: `Shape` unless `by` has as many coordinates as the space; `Domain` when one is not finite;
/// `Limit`. Book 312.
///
/// ```
/// use pforms_kernel::Form;
/// let arc: Form = Form::from_homogeneous(&[3], 3, vec![
///     1., 0., 0., 1., 1., 1., 0., 1., 0., 2., 0., 2.,
/// ])?;
/// let cylinder = pforms_operators::extrude(&arc, &[0., 0., 5.])?;
/// assert_eq!(cylinder.kind().to_string(), "pS23");
/// assert_eq!(cylinder.at(&[1.0, 0.0])?, [1., 0., 5.]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn extrude<S: Scalar>(form: &Form<S>, by: &[S]) -> Result<Form<S>> {
    extrude_along(form, &path_of(by, form.ambient())?)
}

/// [`extrude_along`] of forms and splines: the knots of both are kept.
///
/// Errors: as [`extrude_along`].
pub fn extrude_shapes<S: Scalar>(form: &Shape<S>, path: &Shape<S>) -> Result<Shape<S>> {
    let net = extrude_along(form.net(), path.net())?;
    if let (Shape::Form(_), Shape::Form(_)) = (form, path) {
        return Ok(net.into());
    }
    let [path, form] = [path, form].map(|shape| shape.clone().into_spline());
    let knots: Vec<Knots<S>> = [path.knots(), form.knots()].concat();
    Ok(Spline::on(net, knots)?.into())
}

/// The segment from the origin to a vector: the path of [`extrude`].
///
/// Errors: `Shape` unless there are `ambient` coordinates; `Domain` when one is not finite.
pub fn path_of<S: Scalar>(by: &[S], ambient: usize) -> Result<Form<S>> {
    require_in_space("by", by, ambient)?;
    let ends: Vec<S> = (0..ambient).map(|_| S::zero()).chain(by.iter().cloned()).collect();
    Form::from_points(&[2], ambient, &ends, None)
}
