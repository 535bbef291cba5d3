//! The torus: a circle turned about an axis beside it (book 312).

use pforms_kernel::{Form, Result, Scalar};

use super::arc::{quarter, quarters, require_positive, whole_circle};
use super::quadrics::round;
use super::{Part, cross};
use crate::{Poles, Shape, reverse};

/// A torus about Oy: a tube of radius `minor` round a circle of radius `major`. Axis 0 runs round the
/// tube, outwards from the largest radius and then up; axis 1 round Oy from x towards z.
///
/// [`Part::Whole`] is one pS55; [`Part::Pieces`] sixteen pS33; [`Part::Quarter`] a quarter turn of the
/// whole tube, a pS53; [`Part::Outer`] and [`Part::Inner`] the book's sixteenths, each from the
/// equator up to the top of the tube. `minor` above `major` is a torus that meets itself.
///
/// Errors: `Domain` unless both radii are positive; for other parts; for all but the whole in a field
/// without √2.
///
/// ```
/// use pforms_operators::{Part, Poles, torus};
/// let whole = torus(&2.0, &1.0, Part::Whole)?;
/// assert_eq!(whole.net().kind().to_string(), "pS55");
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn torus<S: Scalar>(major: &S, minor: &S, part: Part) -> Result<Shape<S>> {
    require_positive("major", major)?;
    require_positive("minor", minor)?;
    let turn = round(part, &TORUS)?;
    let tube = match part {
        Part::Pieces => quarters(minor, 0, 4, &part.half_root()?)?.into(),
        Part::Outer | Part::Inner => quarter_around(minor, part)?.into(),
        _ => whole_circle(minor)?.into(),
    };
    cross(&shifted(&tube, major)?, &turn)
}

const TORUS: [Part; 5] = [Part::Whole, Part::Pieces, Part::Quarter, Part::Outer, Part::Inner];

/// The outer or inner quarter of a circle, up from Ox.
fn quarter_around<S: Scalar>(radius: &S, part: Part) -> Result<Form<S>> {
    match part {
        Part::Inner => reverse(&quarter(radius, 1, &part.half_root()?)?, 0),
        _ => quarter(radius, 0, &part.half_root()?),
    }
}

/// The shape moved along Ox.
pub(crate) fn shifted<S: Scalar>(shape: &Shape<S>, by: &S) -> Result<Shape<S>> {
    let net = shape.net();
    let mut poles = net.homogeneous().to_vec();
    for pole in poles.chunks_exact_mut(net.width()) {
        let [x, .., weight] = pole else { continue };
        *x += by.clone() * weight.clone();
    }
    shape.with_net(Form::from_homogeneous(net.orders(), net.ambient(), poles)?)
}
