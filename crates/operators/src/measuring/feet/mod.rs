//! All feet of a point on a form or spline: where the distance does not fall at first order.

mod field;
mod kind;
mod search;

use pforms_kernel::{Error, Form, Result, limit, threads};

use super::invert::Doubt;
use super::patches::{is_closed, patches};
use super::project::positive_weights;
use super::scale::{in_units, unit};
use super::system::Limits;
use crate::{Poles, Shape};

pub use kind::FootKind;
use search::Search;

/// A place of a form that is a foot of a point.
#[derive(Clone, Debug, PartialEq)]
pub struct Foot {
    /// The parameters, one for each axis.
    pub parameters: Vec<f64>,
    /// The point of the form.
    pub point: Vec<f64>,
    /// Its distance from the point.
    pub distance: f64,
    /// The parameters are wrong by no more than this, if `proved`; otherwise the widest side of the
    /// box they were found in.
    pub error: f64,
    /// How the distance changes around it.
    pub kind: FootKind,
    /// Is it shown that there is a foot within the error, and no other? Otherwise it is a place in
    /// a [`Doubt`].
    pub proved: bool,
}

/// All feet of one point.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Feet {
    /// In the order of their parameters.
    pub feet: Vec<Foot>,
    /// What is not decided. Every foot is a proved one or in one of these.
    pub doubts: Vec<Doubt>,
}

impl Feet {
    /// Are the feet all there are, each proved?
    pub fn complete(&self) -> bool {
        self.doubts.is_empty()
    }
}

/// All feet of points, `ambient` numbers each, on a form or spline.
///
/// A foot is a place from which no way within the window leads nearer at first order: along each axis
/// the distance does not change, or at the lower (upper) end of the window does not fall when the
/// parameter grows (falls). So all local nearest points are among the feet, and besides them the
/// inner places of greatest distance and the saddles; [`Foot::kind`] tells them apart. At a kink
/// of a spline the rule holds for the pieces on either side, and where a shape ends as it begins along
/// an axis it is taken to go on; such a foot has the first parameters.
///
/// All of them are found, each proved to be alone within its error. What cannot be shown is a
/// [`Doubt`]: where feet fill a curve or more (the centre of a sphere), where two are about to
/// become one (the centre of curvature), at collapsed edges. Boxes of doubt are cut no finer than
/// `accuracy`, in windows of a piece. Work on each piece is bounded.
///
/// Errors: `Shape` for a shape without axes or with more than four, or when the count of `points`
/// does not fit; `Domain` for points that are not finite or out of all proportion, for a weight that
/// vanishes or changes sign in the window, for an accuracy not between 0 and 1; `Limit`.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{FootKind, project_all};
/// let parabola: Form = Form::from_points(&[3], 2, &[-1., 1., 0., -1., 1., 1.], None)?;
/// let feet = &project_all(&parabola.into(), &[0., 0.75], 1e-12)?[0];
/// // Two nearest points at x² = 1/4, and the vertex, where the distance is greatest between them.
/// let kinds: Vec<FootKind> = feet.feet.iter().map(|foot| foot.kind).collect();
/// assert_eq!(kinds, [FootKind::Minimum, FootKind::Maximum, FootKind::Minimum]);
/// assert!(feet.complete());
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn project_all(shape: &Shape, points: &[f64], accuracy: f64) -> Result<Vec<Feet>> {
    let net = shape.net();
    let (axes, ambient) = (net.axes(), net.ambient());
    if !(0.0..=1.0).contains(&accuracy) {
        return Err(Error::domain("accuracy", accuracy, "a number from 0 to 1"));
    }
    if axes == 0 || axes > 4 {
        return Err(Error::shape("form", format!("{axes} axes"), "1 to 4 axes"));
    }
    if !points.len().is_multiple_of(ambient) {
        let expected = format!("{ambient} for each point");
        return Err(Error::shape("points", format!("{} numbers", points.len()), expected));
    }
    let unit = unit([net]);
    let mut all = patches(&shape.with_net(in_units(net, unit)?)?)?;
    for patch in &mut all {
        let sign = positive_weights(&patch.form)?.sign;
        patch.form = normalised(&patch.form, sign)?;
    }
    let most = MOST_WORK / (axes * axes);
    let limits = Limits { finest: accuracy.max(FINEST), most, ..Limits::default() };
    let counts = counts(shape);
    let closed = (0..axes).map(|axis| is_closed(&all, &counts, axis)).collect();
    let search = Search { patches: all, counts, closed, unit, limits };
    let count = points.len() / ambient;
    limit::check::<Feet>("the feet", &[count], 1)?;
    let mut answers = vec![Feet::default(); count];
    threads::fill_parts(&mut answers, 1, COST, |range, out| {
        let part = &points[range.start * ambient..range.end * ambient];
        for (point, answer) in part.chunks_exact(ambient).zip(out) {
            *answer = search.feet(point)?;
        }
        Ok(())
    })?;
    Ok(answers)
}

/// No box is cut finer.
const FINEST: f64 = 1e-13;

/// Cells of one face, at most, for one axis.
const MOST_WORK: usize = 1 << 14;

/// Arithmetic for one point, about.
const COST: usize = 1 << 16;

/// Pieces along each axis.
fn counts(shape: &Shape) -> Vec<usize> {
    match shape {
        Shape::Form(form) => vec![1; form.axes()],
        Shape::Spline(spline) => spline.counts(),
    }
}

/// Positive weights; exactly 1 if they are all the same.
fn normalised(form: &Form, sign: f64) -> Result<Form> {
    let unit = form.uniform_weight().copied().unwrap_or(sign);
    let poles = form.homogeneous().iter().map(|x| x / unit).collect();
    Form::from_homogeneous(form.orders(), form.ambient(), poles)
}
