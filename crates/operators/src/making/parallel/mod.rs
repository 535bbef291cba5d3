//! Curves and surfaces at a distance from others (book, section 325).
//!
//! With `N` the polynomial that has the direction of the normal, the parallel is `f + d·N/|N|`.
//! Only the length `|N|` is no polynomial: it alone is approximated, by a polynomial `s` on each of
//! as many cells as the tolerance needs, and the result `f + d·N/s` is a rational spline. It lies on
//! the true normals, so its error is the scalar `|d|·||N|/s − 1|`, and that is at most
//! `|d|·max||N|² − s²| / min s(s + |N|)`, read from Bernstein coefficients over the whole cell.
//! Where `|N|` is a polynomial (Pythagorean hodographs and normals: Farouki and Sakkalis 1990,
//! Pottmann 1995; among them planes, spheres, cylinders, cones and tori) `s` meets it, and the
//! result is exact.

mod cell;
mod distance;
mod field;
mod fold;
mod interval;
mod net;
mod positive;
mod refine;

use pforms_kernel::{Error, Form, Result};

use crate::Spline;
use cell::Cell;
pub use distance::Distance;
use field::Field;
pub(super) use interval::Interval;
pub(super) use net::joined;
use refine::Division;

/// On which side of a form its parallel lies.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Side {
    /// Of a surface in space the side of `f_u × f_v`; of a curve in the plane its left.
    #[default]
    Natural,
    /// Of a curve in space: left of it, seen from the tip of this vector (`vector × tangent`).
    Across([f64; 3]),
    /// Of a curve in space: the inside of its bend, along the principal normal.
    Principal,
}

/// What a parallel form is asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct ParallelOptions {
    /// How far any point of the result may be from its true place, in the unit of the form.
    pub tolerance: f64,
    /// The side of positive distances.
    pub side: Side,
    /// Accept a result that turns back on itself, beyond the radius of curvature?
    pub folds: bool,
}

impl ParallelOptions {
    /// A tolerance alone: the natural side, no folds.
    pub fn new(tolerance: f64) -> Self {
        Self { tolerance, side: Side::Natural, folds: false }
    }
}

/// A parallel form and how near it is to the true one.
#[derive(Clone, Debug, PartialEq)]
pub struct Parallel {
    /// The parallel, with the parameters of the original; all on its normals.
    pub spline: Spline,
    /// No point of the window is farther than this from its true place: a bound, not a sample.
    pub error: f64,
    /// Largest distance between pieces that met before: 0 unless the original has a corner or an
    /// edge there.
    pub gap: f64,
}

/// The curve or surface at a signed distance from another, within a tolerance.
///
/// A surface in space, a curve in the plane, or a curve in space with [`Side::Across`] or
/// [`Side::Principal`]. The distance is a number, or a form in dimension 1 over the window of the
/// original taken from 0 to 1. The result has the weights of the original times those of the
/// approximated length, and every point of it lies on the normal at the same parameters. Collapsed
/// edges, as of a sphere, keep the normals that they have next to them.
///
/// Errors: `Degenerate` where the distance reaches the radius of curvature (unless folds are
/// accepted) and where there is no normal, naming the place; `Shape` for other forms; `Domain` for a
/// tolerance that is not positive, and where the weight vanishes; `Accuracy` for a tolerance below
/// rounding or one that takes too many pieces.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{ParallelOptions, parallel};
/// let parabola: Form = Form::from_points(&[3], 2, &[0., 0., 1., 2., 2., 0.], None)?;
/// let near = parallel(parabola, 0.5, &ParallelOptions::new(1e-6))?; // left of it: above
/// let top = near.spline.at(&[0.5])?;
/// assert!((top[1] - 1.5).abs() <= near.error && near.error < 1e-6);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn parallel(
    form: impl Into<Spline>,
    distance: impl Into<Distance>,
    options: &ParallelOptions,
) -> Result<Parallel> {
    let (form, distance) = (form.into(), distance.into());
    if distance.is_zero() {
        check_options(options)?;
        return Ok(Parallel { spline: form, error: 0.0, gap: 0.0 });
    }
    let cells = Division::new(&form, &distance, options)?;
    let forms = cells.each(Cell::moved)?;
    let (spline, gap) = cells.joined(&forms, 0)?;
    Ok(Parallel { spline, error: cells.error, gap })
}

/// What lies between a form and its parallel: a volume for a surface, a strip for a curve.
///
/// Axis 0 goes from the form to the parallel, at constant speed along each normal; the others are
/// those of the form. The side at 0 is the form itself, exactly, the side at 1 the [`parallel`].
///
/// Errors: as [`parallel`], and `Degenerate` for the distance 0.
pub fn shell(
    form: impl Into<Spline>,
    distance: impl Into<Distance>,
    options: &ParallelOptions,
) -> Result<Parallel> {
    let (form, distance) = (form.into(), distance.into());
    if distance.is_zero() {
        return Err(Error::degenerate("distance", 0, "a distance that leaves room between"));
    }
    let cells = Division::new(&form, &distance, options)?;
    let forms = cells
        .each(|cell, distance| crate::stack(&[&cell.raised(distance)?, &cell.moved(distance)?]))?;
    let (spline, gap) = cells.joined(&forms, 1)?;
    Ok(Parallel { spline, error: cells.error, gap })
}

fn check_options(options: &ParallelOptions) -> Result<()> {
    if options.tolerance > 0.0 && options.tolerance.is_finite() {
        return Ok(());
    }
    Err(Error::domain("tolerance", options.tolerance, "a length above 0"))
}

/// A function on the window: a form in dimension 1.
fn function(poles: &[f64], orders: &[usize]) -> Result<Form> {
    Form::from_points(orders, 1, poles, None)
}
