//! Surfaces whose area is known, and made least.

use pforms_kernel::{Error, Result};

use super::boundary::Frame;
use super::units::Units;
use super::work::Work;
use super::{Functional, MinimalOptions};
use crate::algebra::Shape;

/// A surface on a given boundary and how near it is to a minimal one.
#[derive(Clone, Debug, PartialEq)]
pub struct Minimal {
    /// The surface.
    pub surface: Shape,
    /// Its area.
    pub area: f64,
    /// The true area differs by this much at most.
    pub error: f64,
    /// The area of the Coons patch on the same boundary; none where its weights change sign.
    pub coons_area: Option<f64>,
    /// Its Dirichlet energy `½·∫ |∇S|²`: at least the area, and equal to it if parameters keep angles.
    pub energy: f64,
    /// The root of the mean square of `ΔS`: 0 if the surface is harmonic.
    pub laplacian: f64,
    /// The root of the mean square of its mean curvature: 0 if the surface is minimal.
    pub curvature: f64,
    /// How much the area still falls with the free poles, as a part of it: half the square of this is
    /// the part that one more step would win.
    pub slope: f64,
    /// Steps of a descent.
    pub steps: usize,
}

/// A surface of little area on a given boundary, and what is known about it.
///
/// With a functional as [`extremal`](super::extremal). With `None` the area itself descends, from whichever
/// of the Coons patch and the surfaces of least Dirichlet energy has less area, until its slope is at most
/// `accuracy` or no step lowers it: the result never has more area than any of these. A critical
/// point is found, as films of soap do; that no surface far away has less area is not said. The poles
/// that move keep their weights, and so does the boundary.
///
/// Errors: as [`extremal`](super::extremal); `Shape` for anything but a surface in at least two
/// dimensions; `Domain` for weights that change sign, and for sides with the area, which has none;
/// `Accuracy` when numbers overflow.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{MinimalOptions, minimal};
/// let arch = |y: f64| Form::from_points(&[3], 3, &[0., y, 0., 1., y, 2., 2., y, 0.], None);
/// let side = |x: f64| Form::from_points(&[2], 3, &[x, 0., 0., x, 3., 0.], None);
/// let border = [arch(0.)?, arch(3.)?, side(0.)?, side(2.)?].map(Into::into);
/// let options = MinimalOptions { orders: vec![4, 4], ..Default::default() };
/// let film = minimal(&border, None, &options, 1e-9)?;
/// assert!(Some(film.area) < film.coons_area && film.slope < 1e-9);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn minimal(
    boundary: &[Shape],
    functional: Option<Functional>,
    options: &MinimalOptions,
    accuracy: f64,
) -> Result<Minimal> {
    if !(accuracy.is_finite() && accuracy >= 0.0) {
        return Err(Error::domain("accuracy", accuracy, "a finite number of at least 0"));
    }
    if functional.is_none() && !options.sides.is_empty() {
        let received = format!("{:?}", options.sides);
        return Err(Error::domain("sides", received, "none, as the area has no parameters"));
    }
    let frame = Frame::new(boundary, options)?;
    require_surface(&frame)?;
    let frame = on_coons_weights(frame, &options.keep);
    let units = Units::of(frame.spline.net())?;
    let work = Work::new(&frame, &units, options)?;
    let (poles, steps) = match functional {
        None => {
            let (poles, steps) = work.descend(accuracy)?;
            (work.lowest(poles)?, steps)
        }
        Some(functional) => (work.least(functional)?, 0),
    };
    let found = work.report(&poles, steps)?;
    units.restored(found, &frame)
}

fn require_surface(frame: &Frame<f64>) -> Result<()> {
    let net = frame.spline.net();
    if net.axes() == 2 && net.ambient() >= 2 {
        return Ok(());
    }
    let received = format!("a {} in {}D", net.kind(), net.ambient());
    Err(Error::shape("boundary", received, "that of a surface in at least 2 dimensions"))
}

/// Inner poles that are not kept are not looked at, their weights neither: those of the Coons patch
/// take their place, if it has as many poles and weights of one sign.
fn on_coons_weights(frame: Frame<f64>, keep: &[Vec<usize>]) -> Frame<f64> {
    if frame.spline.net().uniform_weight().is_some() || !keep.is_empty() {
        return frame;
    }
    match frame.coons() {
        Ok(spline) if spline.knots() == frame.spline.knots() && Units::of(spline.net()).is_ok() => {
            Frame { spline, ..frame }
        }
        _ => frame,
    }
}
