//! Products of a profile and a section, pole by pole.

use pforms_kernel::{Error, Form, Result, Scalar, limit};

use crate::{Knots, Poles, Shape, Spline};

/// The product of a profile and a section about Oy (book 322): axes of the profile first.
///
/// The section says what becomes of the direction Ox: its point `(a, b)` turns and stretches the
/// horizontal plane as the complex number `a + i·b` does, `x + i·z` to `(a + i·b)(x + i·z)`, and its
/// third coordinate, if any, lifts. So
///
/// `(px, py, pz; pw) × (sx, sy, sz; sw) = (px·sx − pz·sy, py·sw + pw·sz, px·sy + pz·sx; pw·sw)`.
///
/// For a profile in the plane Oxy and a flat section this is the book's product; the book leaves
/// other profiles open. The unit circle for a section turns the profile about Oy, whatever its
/// shape, from x towards z. Exact for rational profiles and sections of any number of axes, forms
/// or splines.
///
/// Errors: `Shape` unless both lie in two or three dimensions; `Limit`.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{Part, Poles, circle, cross};
/// let segment = Form::from_points(&[2], 2, &[1., 0., 1., 3.], None)?;
/// let cylinder = cross(&segment.into(), &circle(&1.0, Part::Whole)?)?;
/// assert_eq!(cylinder.net().kind().to_string(), "pS25");
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn cross<S: Scalar>(profile: &Shape<S>, section: &Shape<S>) -> Result<Shape<S>> {
    require_space("profile", profile)?;
    require_space("section", section)?;
    product(profile, section, |p, s| {
        let ([px, py, pz, pw], [sx, sy, sz, sw]) = (p, s);
        let times = |a: &S, b: &S| a.clone() * b.clone();
        [
            times(px, sx) - times(pz, sy),
            times(py, sw) + times(pw, sz),
            times(px, sy) + times(pz, sx),
            times(pw, sw),
        ]
    })
}

pub(super) fn require_space<S: Scalar>(argument: &str, shape: &Shape<S>) -> Result<()> {
    match shape.net().ambient() {
        2 | 3 => Ok(()),
        other => Err(Error::shape(
            argument,
            format!("a {} in {other}D", shape.net().kind()),
            "a form in two or three dimensions",
        )),
    }
}

/// Every pole of `a` with every pole of `b`; what lies in the plane has the third coordinate 0.
pub(super) fn product<S: Scalar>(
    a: &Shape<S>,
    b: &Shape<S>,
    pole: impl Fn(&[S; 4], &[S; 4]) -> [S; 4],
) -> Result<Shape<S>> {
    let orders = [a.net().orders(), b.net().orders()].concat();
    let count = limit::check::<S>("the product", &orders, 4)?;
    let mut poles = Vec::with_capacity(count);
    let sections = spatial(b.net());
    for p in &spatial(a.net()) {
        for s in &sections {
            poles.extend(pole(p, s));
        }
    }
    let net = Form::from_homogeneous(&orders, 3, poles)?;
    if let (Shape::Form(_), Shape::Form(_)) = (a, b) {
        return Ok(Shape::Form(net));
    }
    let knots: Vec<Knots<S>> =
        [a, b].map(|shape| shape.clone().into_spline().knots().to_vec()).concat();
    Spline::on(net, knots).map(Shape::Spline)
}

/// The poles of a form in the plane or in space, as poles in space.
fn spatial<S: Scalar>(net: &Form<S>) -> Vec<[S; 4]> {
    let width = net.width();
    let poles = net.homogeneous().chunks_exact(width);
    poles
        .map(|pole| {
            let z = if width == 4 { pole[2].clone() } else { S::zero() };
            [pole[0].clone(), pole[1].clone(), z, pole[width - 1].clone()]
        })
        .collect()
}
