//! Surfaces of little area on a given boundary.
//!
//! A surface is minimal where its mean curvature vanishes. Within the forms of some orders on a given
//! boundary, three linear conditions come near, and descent on the area itself comes nearest.

mod area;
mod boundary;
mod descent;
mod energy;
mod gauss;
mod history;
mod metric;
mod patch;
mod system;
mod units;
mod work;

use pforms_kernel::{Error, Form, Result, Scalar};

use boundary::Frame;
use energy::Energy;

pub use area::{Minimal, minimal};

use crate::algebra::Shape;
use crate::measuring::twofold::Twofold;

/// What the poles inside a boundary make least.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Functional {
    /// `½·∫ |∇S|²`: the form of least Dirichlet energy, after Plateau and Bézier. It is at least the
    /// area, and equal to it where parameters keep angles, so it has its minimum at minimal surfaces
    /// in such parameters.
    #[default]
    Dirichlet,
    /// `½·∫ |ΔS|²`: the form nearest to harmonic; 0, and harmonic, if the boundary allows.
    Harmonic,
    /// `½·Σ |P_i − P_j|²` over neighbours in the net: every pole is the mean of its neighbours, as
    /// in a soap film of threads.
    Laplace,
}

/// What a form of little area is asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct MinimalOptions<S = f64> {
    /// Orders of its pieces, at least those of the boundary; none: those of the boundary.
    pub orders: Vec<usize>,
    /// Lengths of the sides of the box of parameters; none: those of the window, 1 for forms.
    pub sides: Vec<S>,
    /// Places of poles inside that are kept.
    pub keep: Vec<Vec<usize>>,
}

impl<S> Default for MinimalOptions<S> {
    fn default() -> Self {
        Self { orders: Vec::new(), sides: Vec::new(), keep: Vec::new() }
    }
}

/// The form on a given boundary that makes a functional least: one linear system for its inner poles.
///
/// The boundary is that of a single form or spline, whose inner poles are not looked at unless they are
/// kept; or it is given by the faces of a [`coons`](crate::coons) patch, in the same order. Exact in
/// exact arithmetic, where a harmonic form is recovered from its boundary with `==`. Any number of
/// axes in any dimension; of one axis all functionals give the segment. In `f64` systems are solved with
/// twice the precision, which adds nothing to what the rounding of the boundary does up to degree 20 or
/// so; above 24 or so they are refused.
///
/// Of a form that makes the Dirichlet energy least in its space see J. Monterde, *Bézier surfaces of minimal
/// area: the Dirichlet approach* (2004); of harmonic forms J. Monterde and H. Ugail (2004); of
/// the net book 0233.
///
/// Errors: those of [`coons`](crate::coons), among them `Domain` that names corner and gap where faces
/// do not meet; `Domain` for weights that are not all equal, for orders below those of the boundary
/// and sides that are not positive; `Shape` for places that are not in the net; `Accuracy` for
/// degrees that rounding does not allow; `Limit`.
///
/// ```
/// use pforms_kernel::{Form, Rational, Scalar};
/// use pforms_operators::{Functional, MinimalOptions, extremal};
/// let frame = [0, 1, 0, 1, 9, 1, 0, 1, 0].map(<Rational as Scalar>::from_integer);
/// let frame: Form<Rational> = Form::from_points(&[3, 3], 1, &frame, None)?;
/// let film = extremal(&[frame.into()], Functional::Laplace, &MinimalOptions::default())?;
/// assert_eq!(film.net().pole(&[1, 1])?[0], Rational::ratio(1, 1));
/// # use pforms_operators::Poles;
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn extremal<S: Scalar>(
    boundary: &[Shape<S>],
    functional: Functional,
    options: &MinimalOptions<S>,
) -> Result<Shape<S>> {
    let frame = Frame::new(boundary, options)?;
    if frame.spline.net().uniform_weight().is_none() {
        return Err(Error::domain(
            "boundary",
            "weights that are not equal",
            "one weight for all poles, or the true area made least",
        ));
    }
    frame.with(least(&frame, functional, &options.sides)?)
}

/// The net of the frame with its free poles where the functional is least.
///
/// Bernstein's polynomials make systems whose condition grows by fourteen with each degree; numbers of
/// twice the precision leave nothing of that up to degree 24 or so.
fn least<S: Scalar>(frame: &Frame<S>, functional: Functional, sides: &[S]) -> Result<Form<S>> {
    let net = frame.spline.net();
    if functional == Functional::Laplace {
        if let Some(side) = sides.first() {
            let expected = "no sides, as the net alone counts";
            return Err(Error::domain("sides", format!("{side:?}, …"), expected));
        }
        return system::least(net, &Energy::net(net.orders()), &frame.free);
    }
    let twofold = |x: &S| Twofold::from_plain(x.clone());
    let sides: Vec<Twofold<S>> = frame.sides(sides)?.iter().map(twofold).collect();
    let spline = frame.spline.map_scalar(twofold)?;
    let energy = match functional {
        Functional::Harmonic => Energy::laplacian(spline.knots(), &sides)?,
        _ => Energy::dirichlet(spline.knots(), &sides)?,
    };
    let found = system::least(spline.net(), &energy, &frame.free)?;
    found.map_scalar(Twofold::to_plain)
}
