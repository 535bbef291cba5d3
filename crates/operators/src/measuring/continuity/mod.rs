//! How smoothly forms meet: parametric and geometric continuity (course, "raccordement").

mod contact;
mod side;

use std::iter::zip;

use pforms_kernel::{Error, Result};

use self::contact::{Contact, contacts};
use self::side::{Parts, Side};
use super::scale::{spline_in_units, unit};
use crate::algebra::{Shape, Spline};

/// An end of one axis of a form: a point of a curve, an edge of a surface, a face of a volume.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FormEnd {
    /// The axis.
    pub axis: usize,
    /// The end where its parameter is largest?
    pub far: bool,
}

impl FormEnd {
    /// Where the parameter of `axis` begins.
    pub fn start(axis: usize) -> Self {
        Self { axis, far: false }
    }

    /// Where the parameter of `axis` ends.
    pub fn end(axis: usize) -> Self {
        Self { axis, far: true }
    }
}

/// How smoothly two forms meet.
///
/// A gap is what is left of a difference, the largest along the joint; it counts as none when it is
/// below the accuracy times the derivatives themselves, or times what they are for a curve of the
/// same size that crosses it once.
#[derive(Clone, Debug, PartialEq)]
pub struct Continuity {
    /// The largest `k` for which the forms are `C^k`, as far as was asked; `None` if they do not meet.
    pub parametric: Option<usize>,
    /// The largest `k` for which they are `G^k`; `None` if they do not meet.
    pub geometric: Option<usize>,
    /// The differences of the derivatives of order 0, 1, … by the parameter across the joint.
    pub parametric_gaps: Vec<f64>,
    /// The distance; the angle of the tangents, or tangent planes, in radians; the difference of the
    /// curvature vectors, or of the second fundamental forms; for curves the differences of the
    /// higher derivatives by the length of arc. It ends before what is not defined.
    pub geometric_gaps: Vec<f64>,
}

/// What is asked about a joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContinuityOptions {
    /// The highest order looked at.
    pub order: usize,
    /// How large a gap counts as none, relative to what is compared.
    pub accuracy: f64,
}

/// The highest order that can be asked for.
const HIGHEST: usize = 16;

impl Default for ContinuityOptions {
    /// Up to order 2, to a thousandth of a millionth.
    fn default() -> Self {
        Self { order: 2, accuracy: 1e-9 }
    }
}

/// How smoothly `f` at one of its ends goes on into `g` at one of its own.
///
/// Both are looked at in the direction from `f` to `g`, so that the end of a curve goes on into the
/// start of the next, and two starts are a start and a reversed curve. The edges of surfaces may run
/// either way: the way in which they come nearest to each other is taken. Along an edge the gaps are
/// measured at more parameters than the degree; where a surface has no tangent plane only its points
/// and derivatives are compared. Volumes fill their space: they are compared by derivatives alone.
///
/// Errors: `Shape` when numbers of axes or spaces differ or there is no such axis; `Domain` for an
/// accuracy that is not positive and an order above 16, and where a form goes to infinity.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{ContinuityOptions, FormEnd, continuity};
/// let f: Form = Form::from_points(&[3], 2, &[0., 0., 1., 0., 2., 1.], None)?;
/// let g: Form = Form::from_points(&[3], 2, &[2., 1., 4., 3., 4., 5.], None)?;
/// let at = [FormEnd::end(0), FormEnd::start(0)];
/// let joint = continuity(&f.into(), &g.into(), at, ContinuityOptions::default())?;
/// assert_eq!((joint.parametric, joint.geometric), (Some(0), Some(1)));
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn continuity(
    f: &Shape,
    g: &Shape,
    at: [FormEnd; 2],
    options: ContinuityOptions,
) -> Result<Continuity> {
    check(options)?;
    let [f, g] = [f, g].map(|shape| shape.clone().into_spline());
    if (f.axes(), f.ambient()) != (g.axes(), g.ambient()) {
        return Err(Error::shape(
            "g",
            format!("{} axes in {}D", g.axes(), g.ambient()),
            format!("{} axes in {}D, like f", f.axes(), f.ambient()),
        ));
    }
    let unit = unit([f.net(), g.net()]);
    let (f, g) = (spline_in_units(&f, unit)?, spline_in_units(&g, unit)?);
    let (f, g) = (Parts::of(&f), Parts::of(&g));
    let before = Side::of_end(&f, at[0], true)?;
    let after = Side::of_end(&g, at[1], false)?;
    between(&before, &after, unit, options)
}

/// How smoothly the pieces of a spline meet along `axis`: each inner break, and the continuity there.
/// A spline whose ends meet has one joint more, at the end of its window.
///
/// Errors: as [`continuity`].
pub fn joints(
    spline: &Spline,
    axis: usize,
    options: ContinuityOptions,
) -> Result<Vec<(f64, Continuity)>> {
    check(options)?;
    spline.net().require_axis(axis)?;
    let unit = unit([spline.net()]);
    let bezier = spline_in_units(&spline.bezier()?, unit)?;
    let parts = Parts::of(&bezier);
    let breaks = spline.breaks().swap_remove(axis);
    let last = breaks.len() - 1;
    let joint = |before: usize, after: usize| {
        let before = Side::of_piece(&parts, axis, before, true)?;
        let after = Side::of_piece(&parts, axis, after, false)?;
        between(&before, &after, unit, options)
    };
    let mut joints = Vec::with_capacity(last);
    for (before, t) in breaks[1..last].iter().enumerate() {
        joints.push((*t, joint(before, before + 1)?));
    }
    let closing = joint(last - 1, 0)?;
    if closing.parametric.is_some() {
        joints.push((breaks[last], closing));
    }
    Ok(joints)
}

/// The continuity of two sides whose coordinates are counted in `unit`s.
fn between(
    before: &Side,
    after: &Side,
    unit: f64,
    options: ContinuityOptions,
) -> Result<Continuity> {
    let contacts = contacts(before, after, options.order)?;
    let gaps = |of: fn(&Contact) -> &[[f64; 2]]| -> (Option<usize>, Vec<f64>) {
        // What is not defined at one place of an edge says nothing about the others.
        let most = contacts.iter().map(|contact| of(contact).len()).max().unwrap_or(0);
        let mut largest = vec![0.0_f64; most];
        let mut smooth = vec![true; most];
        for contact in &contacts {
            for (k, [gap, size]) in of(contact).iter().enumerate() {
                largest[k] = if gap.is_nan() { f64::NAN } else { largest[k].max(*gap) };
                smooth[k] &= *gap <= options.accuracy * size;
            }
        }
        (smooth.iter().take_while(|ok| **ok).count().checked_sub(1), largest)
    };
    let (parametric, mut parametric_gaps) = gaps(|contact| &contact.parametric);
    let (geometric, mut geometric_gaps) = gaps(|contact| &contact.geometric);
    for gap in &mut parametric_gaps {
        *gap *= unit;
    }
    for (k, gap) in geometric_gaps.iter_mut().enumerate() {
        *gap *= unit.powi(1 - k as i32);
    }
    if !parametric_gaps.iter().chain(&geometric_gaps).all(|gap| gap.is_finite()) {
        return Err(Error::domain(
            "order",
            "derivatives beyond the largest floating number",
            "an order that the sizes of the pieces allow",
        ));
    }
    Ok(Continuity { parametric, geometric, parametric_gaps, geometric_gaps })
}

fn check(options: ContinuityOptions) -> Result<()> {
    if options.order > HIGHEST {
        return Err(Error::domain("order", options.order, format!("at most {HIGHEST}")));
    }
    if options.accuracy > 0.0 && options.accuracy.is_finite() {
        return Ok(());
    }
    Err(Error::domain("accuracy", options.accuracy, "a positive number"))
}

/// The distance of two vectors of any size.
fn apart(a: &[f64], b: &[f64]) -> f64 {
    zip(a, b).fold(0.0_f64, |sum, (x, y)| libm::hypot(sum, x - y))
}
