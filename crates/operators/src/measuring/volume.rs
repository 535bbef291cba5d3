//! Volumes: of forms that fill space, and of what closed shells enclose.

use pforms_kernel::{Error, Form, Result, Scalar, Scaled};

use super::integral::{Element, Integral, heaviest, infinite, integrate, least_weight, seen_from};
use super::measure::{Measure, in_units, measure, pieces, require_alike};
use super::shell::Shell;
use super::vector::norm;
use crate::algebra::{Minors, Poles, Shape, flux_minor, reverse, split, tangent_minors};

/// The volume of forms or splines, added up.
///
/// * As many axes as coordinates, or more than two axes: what they fill, `∫ √det(JᵀJ)`. Without sign:
///   where a form folds over it counts as often as it covers.
/// * One axis fewer than coordinates (curves in the plane, surfaces in space): what they enclose. They
///   have to close up, each border meeting that of one other patch, in any order and either way round;
///   the result has no sign, but a shell that hangs together with the rest only by lying inside it
///   counts with the sign of its own first patch: turned inwards it is a hollow.
///
/// With `signed` the integral of the determinant of the derivatives, positive for a right-handed form;
/// of a shell, positive where the normal of the first patch, the product of the derivatives in the order
/// of the axes, points outwards.
///
/// The error is bounded, to `accuracy` times the volume without sign; see [`area`](super::area).
///
/// Errors: `Shape` for other numbers of axes; `Degenerate` for a shell that is open, naming a border, or
/// one-sided; `Domain`; `Accuracy`.
///
/// ```
/// use pforms_operators::{Part, sphere, volume};
/// let octants = sphere(&1.0, Part::Pieces)?; // one spline of eight octants
/// let ball = volume(&[octants], false, 1e-12)?;
/// assert!((ball.value - 4.0 / 3.0 * std::f64::consts::PI).abs() <= ball.error);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn volume(shapes: &[Shape], signed: bool, accuracy: f64) -> Result<Measure> {
    match Kind::of(shapes)? {
        Kind::Shell => enclosed(shapes, signed, accuracy),
        Kind::Solid if signed => {
            let pieces = pieces(shapes)?;
            let axes = pieces.first().map_or(0, Form::axes);
            let integral = integrate(&pieces, Element::Signed, 0, accuracy)?;
            in_units(integral.values[0], integral.error, integral.unit, axes)
        }
        Kind::Solid => measure(shapes, accuracy),
    }
}

/// The same for polynomial forms in the field of their poles, without rounding where that has none.
///
/// Errors: as [`volume`]; `Shape` for a rational form; `Domain` when the sign of the determinant is not
/// the same all over and no `signed` volume is asked for.
///
/// ```
/// use pforms_kernel::{Form, Rational, Scalar};
/// use pforms_operators::volume_exact;
/// // The square with one corner drawn out to (2, 2).
/// let corners = [0, 0, 0, 1, 1, 0, 2, 2].map(<Rational as Scalar>::from_integer);
/// let square = Form::from_points(&[2, 2], 2, &corners, None)?;
/// assert_eq!(volume_exact(&[square.into()], true)?, Rational::ratio(2, 1));
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn volume_exact<S: Scalar>(shapes: &[Shape<S>], signed: bool) -> Result<S> {
    let kind = Kind::of(shapes)?;
    if let Some(shape) = shapes.iter().find(|shape| shape.net().is_rational()) {
        return Err(Error::shape(
            "shapes",
            format!("a rational {}", shape.net().kind()),
            "polynomial forms, for an exact volume",
        ));
    }
    let signs = match kind {
        Kind::Shell => Shell::closed(shapes, 1.0, 0.0)?.signs,
        Kind::Solid => vec![1; shapes.len()],
    };
    let mut sum = S::zero();
    for (shape, sign) in shapes.iter().zip(signs) {
        for piece in shape.pieces()? {
            let part = match kind {
                Kind::Shell => mean(&flux_minor(&piece)?)?,
                Kind::Solid => mean(&of_one_sign(tangent_minors(&piece)?, signed)?)?,
            };
            let part = if kind == Kind::Solid && !signed { magnitude(part) } else { part };
            sum += if sign < 0 { -part } else { part };
        }
    }
    if kind == Kind::Shell {
        sum = sum / S::from_integer(shapes[0].net().ambient() as i64);
    }
    Ok(if signed { sum } else { magnitude(sum) })
}

/// What the volume of shapes is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Solid,
    Shell,
}

impl Kind {
    fn of<S: Scalar>(shapes: &[Shape<S>]) -> Result<Self> {
        let (axes, ambient) = require_alike(shapes)?;
        match axes {
            0 => {}
            _ if axes == ambient || axes > 2 => return Ok(Self::Solid),
            _ if axes + 1 == ambient => return Ok(Self::Shell),
            _ => {}
        }
        Err(Error::shape(
            "shapes",
            format!("{axes} axes in dimension {ambient}"),
            "as many axes as coordinates or three, or one axis fewer and closed",
        ))
    }
}

/// The volume that patches enclose: the flux of the position through them, over the dimension.
fn enclosed(patches: &[Shape], signed: bool, accuracy: f64) -> Result<Measure> {
    let dimension = patches[0].net().ambient();
    // Fluxes may outweigh their sum: then they have to be known better.
    let mut finer = accuracy;
    for last in [false, true] {
        let (integral, through) = flux(patches, 0, finer)?;
        let (flux, error) = (integral.values[0], integral.error + through);
        let wanted = accuracy * flux.abs();
        if error > wanted && flux.abs() > error {
            if last {
                let reached =
                    format!("a coarser one: the bound got down to {:.1e}", error / flux.abs());
                return Err(Error::accuracy("accuracy", accuracy, reached));
            }
            finer *= 0.5 * wanted / error;
            continue;
        }
        let value = if signed { flux } else { flux.abs() };
        let parts = dimension as f64;
        return in_units(value / parts, error / parts, integral.unit, dimension);
    }
    Err(Error::accuracy("accuracy", accuracy, "a coarser one"))
}

/// In sizes of the shell, how far borders may be apart that are meant to be one.
const CRACKS: f64 = 1e-9;

/// The flux of the position through a closed shell, with moments; and how much cracks may let through.
pub(super) fn flux(patches: &[Shape], moments: usize, accuracy: f64) -> Result<(Integral, f64)> {
    let size = extent(&pieces(patches)?)?;
    let shell = Shell::closed(patches, size, CRACKS)?;
    let mut turned = Vec::new();
    for (patch, sign) in patches.iter().zip(&shell.signs) {
        for piece in patch.pieces()? {
            turned.push(if *sign < 0 { reverse(&piece, 0)? } else { piece });
        }
    }
    let integral = integrate(&turned, Element::Flux, moments, accuracy)?;
    // Through a crack goes its area times its distance from the origin, which is a pole.
    let axes = turned.first().map_or(0, Form::axes);
    let area = (0..axes).fold(shell.cracks, |area, _| area / integral.unit);
    let through = area * (size / integral.unit);
    Ok((integral, through))
}

/// At least the diameter of all pieces.
fn extent(pieces: &[Form]) -> Result<f64> {
    let Some(first) = pieces.first() else { return Ok(0.0) };
    let centre = heaviest(first);
    let mut far = 0.0_f64;
    for piece in pieces {
        let seen = seen_from(piece, &centre)?;
        let least = least_weight(&seen)?;
        if least <= 0.0 {
            return Err(infinite());
        }
        let rational = seen.is_rational();
        for pole in seen.homogeneous().chunks_exact(seen.width()) {
            let (point, weight) = pole.split_at(seen.ambient());
            // A pole lighter than the form anywhere counts as if it were as heavy, and twice.
            let light = rational && weight[0] < least;
            far = far.max(norm(point) / if light { 0.5 * least } else { weight[0] });
        }
    }
    Ok(2.0 * far)
}

/// The mean of the Bernstein coefficients of a polynomial, which is its integral.
fn mean<S: Scalar>(minors: &Minors<S>) -> Result<S> {
    let form = minors.clone().into_vectors()?;
    let mut sum = S::zero();
    for pole in form.homogeneous().chunks_exact(form.width()) {
        sum += pole[0].clone();
    }
    Ok(sum / S::from_integer(form.pole_count() as i64))
}

/// The minors, if they have a sign or need none.
fn of_one_sign<S: Scalar>(minors: Minors<S>, signed: bool) -> Result<Minors<S>> {
    if minors.numerators.width() != 1 {
        return Err(Error::shape(
            "shapes",
            "fewer axes than coordinates",
            "as many axes as coordinates, for an exact volume",
        ));
    }
    if signed || has_one_sign(&minors.numerators)? {
        return Ok(minors);
    }
    Err(Error::domain(
        "shapes",
        "a form that folds, or may do so",
        "one whose Jacobian has one sign, or a signed volume",
    ))
}

/// Has a polynomial one sign? Some halvings are tried before the answer is no.
fn has_one_sign<S: Scalar>(polynomial: &Scaled<S>) -> Result<bool> {
    /// Halvings along each axis.
    const HALVINGS: usize = 4;
    let form = polynomial.beside(&Scaled::one(polynomial.degrees())?).into_form()?;
    let axes = form.axes();
    let (mut parts, mut positive, mut negative) = (vec![(form, 0)], false, false);
    while let Some((part, depth)) = parts.pop() {
        let signs = part.homogeneous().iter().step_by(2).filter(|x| !x.is_zero());
        let (above, below) =
            signs.fold(
                (false, false),
                |(above, below), x| {
                    if *x > S::zero() { (true, below) } else { (above, true) }
                },
            );
        if above && below {
            if depth == HALVINGS * axes {
                return Ok(false);
            }
            let (low, high) = split(&part, depth % axes, &S::ratio(1, 2))?;
            parts.extend([(high, depth + 1), (low, depth + 1)]);
        } else {
            positive |= above;
            negative |= below;
        }
    }
    Ok(!(positive && negative))
}

fn magnitude<S: Scalar>(x: S) -> S {
    if x < S::zero() { -x } else { x }
}
