//! Length, area, volume of forms, without sign.

use pforms_kernel::{Error, Form, Result, Scalar};

use super::integral::{Element, integrate};
use super::volume;
use crate::algebra::{Poles, Shape};

/// A number and how far the true one may be from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measure {
    /// The length, area or volume.
    pub value: f64,
    /// By how much the true one may differ, at most.
    pub error: f64,
}

/// The area of surfaces, added up: forms or splines in any dimension, polynomial or rational. Of curves
/// in the plane what they enclose, as [`volume`] does it.
///
/// Without sign: where a surface in the plane folds over, or surfaces overlap, the area counts as often
/// as they cover it. The error is bounded, not estimated; it is at most `accuracy` times the area,
/// unless the area itself is no more than rounding (of surfaces that are curves, say): then the error
/// is as large as the value.
///
/// Errors: `Shape` for other numbers of axes; `Domain` when `accuracy` is not between 0 and 1 or a
/// surface goes to infinity; `Accuracy` when the bound cannot be had.
///
/// ```
/// use pforms_operators::{Part, area, sphere};
/// let octant = sphere(&1.0, Part::Octant)?;
/// let measured = area(&[octant], 1e-12)?;
/// assert!((measured.value - std::f64::consts::FRAC_PI_2).abs() <= measured.error);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn area(surfaces: &[Shape], accuracy: f64) -> Result<Measure> {
    match require_alike(surfaces)? {
        (1, 2) => volume(surfaces, false, accuracy),
        (2, _) => measure(surfaces, accuracy),
        (axes, ambient) => Err(Error::shape(
            "surfaces",
            format!("{axes} axes in dimension {ambient}"),
            "surfaces, or curves in the plane",
        )),
    }
}

/// The area of forms in the plane with its sign: the integral of the determinant, or what closed curves
/// enclose, positive where they run counter-clockwise.
///
/// Errors: as [`volume`]; `Shape` unless all lies in the plane.
pub fn signed_area(shapes: &[Shape], accuracy: f64) -> Result<Measure> {
    match require_alike(shapes)? {
        (1 | 2, 2) => volume(shapes, true, accuracy),
        (axes, ambient) => Err(Error::shape(
            "shapes",
            format!("{axes} axes in dimension {ambient}"),
            "surfaces or closed curves in the plane, for an area with a sign",
        )),
    }
}

/// The measure of forms with `d` parameters in any dimension from `d` up: `∫ √det(JᵀJ)`, added up.
///
/// Errors: as [`area`]; `Shape` when the numbers of axes or the dimensions differ.
pub fn measure(shapes: &[Shape], accuracy: f64) -> Result<Measure> {
    let pieces = pieces(shapes)?;
    let axes = pieces.first().map_or(0, Form::axes);
    let integral = integrate(&pieces, Element::Size, 0, accuracy)?;
    in_units(integral.values[0], integral.error, integral.unit, axes)
}

/// The pieces of all shapes, which must have as many axes and coordinates.
pub(super) fn pieces(shapes: &[Shape]) -> Result<Vec<Form>> {
    require_alike(shapes)?;
    let lists = shapes.iter().map(Shape::pieces).collect::<Result<Vec<_>>>()?;
    Ok(lists.concat())
}

/// The numbers of axes and of coordinates that all shapes have.
pub(super) fn require_alike<S: Scalar>(shapes: &[Shape<S>]) -> Result<(usize, usize)> {
    let sizes = |shape: &Shape<S>| (shape.net().axes(), shape.net().ambient());
    let Some(first) = shapes.first().map(sizes) else {
        return Err(Error::shape("shapes", "none", "a form or more"));
    };
    match shapes.iter().find(|shape| sizes(shape) != first) {
        None => Ok(first),
        Some(other) => Err(Error::shape(
            "shapes",
            format!("a {} in dimension {}", other.net().kind(), other.net().ambient()),
            format!("{} axes in dimension {}, as the first", first.0, first.1),
        )),
    }
}

/// A measure in units of length, each of them a power of two.
pub(super) fn in_units(value: f64, error: f64, unit: f64, axes: usize) -> Result<Measure> {
    let times = |x: f64| (0..axes).fold(x, |x, _| x * unit);
    let measure = Measure { value: times(value), error: times(error) };
    if measure.value.is_finite() && measure.error.is_finite() {
        return Ok(measure);
    }
    Err(Error::domain("shapes", "a measure beyond the largest number", "smaller forms"))
}
