//! Straight lines as a host sees them.

use pforms_kernel::{Form, Result, Scalar};

use super::immerse;

/// The immersed segment from parameter point `a` to parameter point `b` of the host: the curve
/// whose parameters move on a straight line at constant speed (the book's isocline, 2232–2234).
///
/// Its order is `Σ (m_j − 1) + 1`; exact.
///
/// Errors: `Shape` unless `a` and `b` have one number for each axis of the host; `Domain`; `Limit`.
///
/// ```
/// use pforms_kernel::Form;
/// let facet: Form = Form::from_points(&[2, 2], 1, &[0., 0., 0., 1.], None)?;
/// let across = pforms_operators::segment(&facet, &[0., 0.], &[1., 1.])?;
/// assert_eq!(across.kind().to_string(), "pL3");
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn segment<S: Scalar>(host: &Form<S>, a: &[S], b: &[S]) -> Result<Form<S>> {
    host.require_per_axis("a", a)?;
    host.require_per_axis("b", b)?;
    let ends: Vec<S> = a.iter().chain(b).cloned().collect();
    if ends.is_empty() {
        return host.reshape(&[1]);
    }
    let line = Form::from_points(&[2], host.axes(), &ends, None)?;
    immerse(&line, host)
}

/// The immersed segments from each parameter point to the next.
///
/// Errors: as [`segment`]. Fewer than two points make no segment: the list is empty.
pub fn polyline<S: Scalar>(host: &Form<S>, points: &[&[S]]) -> Result<Vec<Form<S>>> {
    points.windows(2).map(|pair| segment(host, pair[0], pair[1])).collect()
}
