//! Splines through points (book 342): the book's chains, and the cubics that are smooth throughout.

mod chain;
mod system;

use pforms_kernel::{Error, Form, Result, Scalar, limit};

pub use self::chain::{cubic_chain, quadratic_chain};
use self::system::slopes;
use super::bspline::wound;
use super::fit_parameters::{Grid, Parameters};
use crate::algebra::{Knots, Spline};

/// What an interpolating cubic does at the ends of an axis.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum SplineEnds<S = f64> {
    /// No curvature at the ends: the shape of a thin rod.
    #[default]
    Natural,
    /// These derivatives at the first and the last point, homogeneous: `ambient + 1` numbers each,
    /// the last of them 0 unless the weight is to change.
    Clamped(Vec<S>, Vec<S>),
    /// The first two pieces are one cubic, and the last two: nothing is assumed about the ends, and a
    /// cubic is reproduced.
    NotAKnot,
    /// Closed, and as smooth where it closes as elsewhere: after the last point comes the first, at
    /// one parameter more. It need not be, but may be given again as the last point.
    Periodic,
}

/// The cubic spline through a net of points, twice continuously differentiable: along each axis its
/// parameters and what happens at its ends.
///
/// All homogeneous coordinates are interpolated, so points of weight 1 give a polynomial spline. One
/// system with three diagonals is solved for each axis; it does not amplify what it is given, while
/// [`cubic_chain`] multiplies it by 3.73 from piece to piece. Exact in exact arithmetic.
/// *The NURBS Book*, section 9.2; de Boor, *A Practical Guide to Splines*, chapter IV.
///
/// Errors: `Shape` unless there is one list and one choice for each axis, and one parameter for each
/// point; for fewer than two points; for clamped ends of anything but a curve, or of another width.
/// `Domain` for parameters that are not finite or do not grow, and for a periodic axis of as many
/// parameters as points whose last point is not the first.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{SplineEnds, interpolating_spline};
/// let points: Form = Form::from_points(&[4], 1, &[0., 1., 8., 27.], None)?; // t³ at 0, 1, 2, 3
/// let spline = interpolating_spline(&points, &[vec![0., 1., 2., 3.]], &[SplineEnds::NotAKnot])?;
/// assert!((spline.at(&[1.5])?[0] - 3.375).abs() < 1e-14);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn interpolating_spline<S: Scalar>(
    points: &Form<S>,
    parameters: &[Vec<S>],
    ends: &[SplineEnds<S>],
) -> Result<Spline<S>> {
    points.require_per_axis("parameters", parameters)?;
    points.require_per_axis("ends", ends)?;
    if points.axes() == 0 {
        return Err(Error::shape("points", "a single point", "a row or a net of points"));
    }
    let mut net = points.clone();
    let mut knots = Vec::with_capacity(ends.len());
    for (axis, (list, ends)) in parameters.iter().zip(ends).enumerate() {
        if *ends == SplineEnds::Periodic && list.len() == net.orders()[axis] + 1 {
            net = wound(&net, axis, 1)?;
        }
        require_growing(list, net.orders()[axis])?;
        if let SplineEnds::Clamped(start, end) = ends {
            require_vectors(points, start, end)?;
        }
        net = through(&net, axis, list, ends)?;
        let last = list.len() - 1;
        let mut vector = vec![list[0].clone(); 4];
        vector.extend_from_slice(&list[1..last]);
        vector.extend(vec![list[last].clone(); 4]);
        knots.push(Knots::new(3, vector)?);
    }
    let net = match points.uniform_weight() {
        Some(weight) if !moves_weights(ends) => net.with_uniform_weight(weight),
        _ => net,
    };
    Spline::on(net, knots)
}

/// Parameters for [`interpolating_spline`]: from the distances between points, say. A periodic axis
/// that does not end where it begins gets one more, for the way back.
///
/// Errors: `Shape` unless there is one truth for each axis, and for given lists of other lengths;
/// `Domain` for points at infinity; `Degenerate` for points that all coincide.
pub fn spline_parameters(
    points: &Form,
    rule: &Parameters,
    periodic: &[bool],
) -> Result<Vec<Vec<f64>>> {
    points.require_per_axis("periodic", periodic)?;
    let mut net = points.clone();
    for (axis, &periodic) in periodic.iter().enumerate() {
        if periodic && !returns(&net, axis) {
            net = wound(&net, axis, 1)?;
        }
    }
    rule.of_grid(&Grid { points: &net.points()?, counts: net.orders(), ambient: net.ambient() })
}

/// Is the last line of poles along `axis` the first again?
fn returns(net: &Form, axis: usize) -> bool {
    let inner = net.orders()[axis + 1..].iter().product::<usize>() * net.width();
    let count = net.orders()[axis];
    count > 1
        && net
            .homogeneous()
            .chunks_exact(count * inner)
            .all(|block| block[..inner] == block[(count - 1) * inner..])
}

/// The lines of poles of the spline along `axis`, two more than points.
///
/// A pole is the blossom at three knots in a row, `y + m(b − a)/3 − s·ab/6` from the value, slope and
/// second derivative at the middle one, with the neighbours `a` before and `b` after it.
fn through<S: Scalar>(
    net: &Form<S>,
    axis: usize,
    list: &[S],
    ends: &SplineEnds<S>,
) -> Result<Form<S>> {
    let inner = net.orders()[axis + 1..].iter().product::<usize>() * net.width();
    let count = list.len();
    let mut orders = net.orders().to_vec();
    orders[axis] = count + 2;
    let mut poles = Vec::with_capacity(limit::check::<S>("the spline", &orders, net.width())?);
    let steps: Vec<S> = list.windows(2).map(|pair| pair[1].clone() - pair[0].clone()).collect();
    let (third, sixth) = (S::ratio(1, 3), S::ratio(1, 6));
    for block in net.homogeneous().chunks_exact(count * inner) {
        let values: Vec<&[S]> = block.chunks_exact(inner).collect();
        let slopes = slopes(&values, &steps, ends)?;
        let last = count - 1;
        poles.extend_from_slice(values[0]);
        poles.extend((0..inner).map(|k| {
            values[0][k].clone() + third.clone() * steps[0].clone() * slopes[0][k].clone()
        }));
        for i in 1..last {
            let (a, b) = (&steps[i - 1], &steps[i]);
            poles.extend((0..inner).map(|k| {
                let rise = (values[i + 1][k].clone() - values[i][k].clone()) / b.clone();
                // b·s, from the piece that begins here.
                let bend = S::from_integer(6) * rise
                    - S::from_integer(4) * slopes[i][k].clone()
                    - S::from_integer(2) * slopes[i + 1][k].clone();
                values[i][k].clone()
                    + third.clone() * (b.clone() - a.clone()) * slopes[i][k].clone()
                    - sixth.clone() * a.clone() * bend
            }));
        }
        poles.extend((0..inner).map(|k| {
            values[last][k].clone()
                - third.clone() * steps[last - 1].clone() * slopes[last][k].clone()
        }));
        poles.extend_from_slice(values[last]);
    }
    Form::from_homogeneous(&orders, net.ambient(), poles)
}

fn moves_weights<S: Scalar>(ends: &[SplineEnds<S>]) -> bool {
    ends.iter().any(|ends| match ends {
        SplineEnds::Clamped(start, end) => {
            [start, end].iter().any(|vector| vector.last().is_some_and(|w| !w.is_zero()))
        }
        _ => false,
    })
}

fn require_growing<S: Scalar>(list: &[S], count: usize) -> Result<()> {
    if list.len() != count || count < 2 {
        return Err(Error::shape(
            "parameters",
            format!("{} parameters for {count} points", list.len()),
            "one for each point, and at least two",
        ));
    }
    if let Some(t) = list.iter().find(|t| !t.is_finite()) {
        return Err(Error::domain("parameters", format!("{t:?}"), "finite numbers"));
    }
    match list.windows(2).find(|pair| pair[1] <= pair[0]) {
        None => Ok(()),
        Some(pair) => {
            let received = format!("{:?}, then {:?}", pair[0], pair[1]);
            Err(Error::domain("parameters", received, "parameters that grow"))
        }
    }
}

fn require_vectors<S: Scalar>(points: &Form<S>, start: &[S], end: &[S]) -> Result<()> {
    let width = points.width();
    if points.axes() != 1 || start.len() != width || end.len() != width {
        return Err(Error::shape(
            "ends",
            format!("vectors of {} and {} numbers for a {}", start.len(), end.len(), points.kind()),
            format!("{width} numbers each, for a curve"),
        ));
    }
    match start.iter().chain(end).find(|x| !x.is_finite()) {
        None => Ok(()),
        Some(x) => Err(Error::domain("ends", format!("{x:?}"), "finite numbers")),
    }
}
