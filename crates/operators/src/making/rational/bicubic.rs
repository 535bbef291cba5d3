//! Polynomial bicubic patches near cylinder, cone, sphere and torus (page on bicubic patches).
//!
//! All are products of a profile and one cubic, whose greatest distance to the unit circle is
//! `2.7253·10⁻⁴`; the errors reported are those of the surface itself, measured.

use pforms_kernel::{Error, Form, Result};

use super::deviation::largest;
use crate::algebra::{quarter_cubic, require_positive, shifted};
use crate::{Part, Poles, Shape, cross};

/// A polynomial patch and how far it is from the surface it stands for.
#[derive(Clone, Debug, PartialEq)]
pub struct Bicubic {
    /// The patch, a pS44.
    pub form: Form,
    /// How far it goes outside, as a length.
    pub outside: f64,
    /// How far it goes inside, as a length.
    pub inside: f64,
}

impl Bicubic {
    /// The largest distance, outside or inside.
    pub fn error(&self) -> f64 {
        self.outside.max(self.inside)
    }
}

/// A quarter of a cylinder about Oy, from `y = 0` to `y = height`.
///
/// Errors: `Domain` unless radius and height are positive.
///
/// ```
/// let patch = pforms_operators::bezier_cylinder(1.0, 2.0)?;
/// assert!((patch.error() - 2.7253e-4).abs() < 1e-8);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn bezier_cylinder(radius: f64, height: f64) -> Result<Bicubic> {
    require_positive("radius", &radius)?;
    patch(&line([radius, radius], height)?, radius * excess()?, 0.0)
}

/// A quarter of a cone about Oy, of this radius at `y = 0` and with its apex at `y = height`; its error
/// is that of the radius at one height.
///
/// Errors: `Domain` unless radius and height are positive.
pub fn bezier_cone(radius: f64, height: f64) -> Result<Bicubic> {
    require_positive("radius", &radius)?;
    patch(&line([radius, 0.0], height)?, radius * excess()?, 0.0)
}

/// An octant of the sphere round the origin.
///
/// Errors: `Domain` unless the radius is positive.
pub fn bezier_sphere(radius: f64) -> Result<Bicubic> {
    require_positive("radius", &radius)?;
    let (unit, excess) = (quarter()?, excess()?);
    let outside = largest(|v| {
        let [a, b] = on(&unit, v);
        libm::hypot(a * (1.0 + excess), b) - 1.0
    });
    patch(&scaled(&unit, radius)?, radius * outside.max(0.0), 0.0)
}

/// Above this ratio of the radii the error would be one of rounding.
const LARGEST_RATIO: f64 = 1e12;

/// A quarter turn of the upper outer ([`Part::Outer`]) or upper inner ([`Part::Inner`]) quarter of the
/// [`torus`](crate::torus), from the equator up. The error is the distance to the tube's surface.
///
/// Errors: `Domain` unless the radii are positive and `major` at most 10¹² times `minor`, and for other
/// parts; `Degenerate` unless `minor` is below `major` for the inner part.
pub fn bezier_torus(major: f64, minor: f64, part: Part) -> Result<Bicubic> {
    require_positive("major", &major)?;
    require_positive("minor", &minor)?;
    let (unit, excess) = (quarter()?, excess()?);
    let side = match part {
        Part::Outer => 1.0,
        Part::Inner if minor < major => -1.0,
        Part::Inner => {
            let received = format!("{minor:?} round a circle of radius {major:?}");
            return Err(Error::degenerate("minor", received, "a tube thinner than its circle"));
        }
        _ => return Err(part.absent(&[Part::Outer, Part::Inner])),
    };
    // Lengths in units of the tube's radius.
    let reach = major / minor;
    if reach > LARGEST_RATIO {
        let received = format!("{major:?}, {reach:?} times minor");
        return Err(Error::domain("major", received, "at most 1e12 times minor"));
    }
    let off = |v: f64, excess: f64| {
        let [a, b] = on(&unit, v);
        libm::hypot((reach + side * a) * (1.0 + excess) - reach, b) - 1.0
    };
    // As a function of the distance from the axis this is convex, with its least value above the
    // circle of the tube's centres: largest at an end of the range, least at an end or there.
    let least = |v: f64| {
        let [a, b] = on(&unit, v);
        let over = reach + side * a <= reach && (reach + side * a) * (1.0 + excess) >= reach;
        if over { b - 1.0 } else { off(v, 0.0).min(off(v, excess)) }
    };
    let outside = largest(|v| off(v, 0.0).max(off(v, excess)));
    let inside = largest(|v| -least(v));
    let profile = scaled(&unit, minor)?;
    let mut poles = profile.homogeneous().to_vec();
    poles.chunks_exact_mut(3).for_each(|pole| pole[0] *= side);
    let profile = Form::from_homogeneous(&[4], 2, poles)?;
    let profile = shifted(&Shape::Form(profile), &major)?;
    patch(profile.net(), minor * outside.max(0.0), minor * inside.max(0.0))
}

fn patch(profile: &Form, outside: f64, inside: f64) -> Result<Bicubic> {
    let surface = cross(&profile.clone().into(), &quarter()?.into())?;
    Ok(Bicubic { form: surface.net().clone(), outside, inside })
}

fn quarter() -> Result<Form> {
    quarter_cubic(&std::f64::consts::FRAC_1_SQRT_2)
}

/// How far the cubic goes outside the unit circle: most at `(3 ± √3)/6`.
fn excess() -> Result<f64> {
    let [x, y] = on(&quarter()?, (3.0 - 3.0_f64.sqrt()) / 6.0);
    Ok(libm::hypot(x, y) - 1.0)
}

/// A point of a polynomial plane cubic.
fn on(cubic: &Form, t: f64) -> [f64; 2] {
    let poles = cubic.homogeneous();
    let row = pforms_kernel::bernstein_row(3, &t);
    [0, 1].map(|k| row.iter().enumerate().map(|(i, share)| share * poles[3 * i + k]).sum())
}

fn scaled(unit: &Form, radius: f64) -> Result<Form> {
    let points: Vec<f64> = unit.points()?.iter().map(|x| x * radius).collect();
    Form::from_points(unit.orders(), 2, &points, None)
}

/// The straight profile of four poles from `(low, 0)` to `(high, height)`.
fn line([low, high]: [f64; 2], height: f64) -> Result<Form> {
    require_positive("height", &height)?;
    let third = |i: f64| [low + (high - low) * (i / 3.0), height * (i / 3.0)];
    let points = [0.0, 1.0, 2.0, 3.0].map(third).concat();
    Form::from_points(&[4], 2, &points, None)
}
