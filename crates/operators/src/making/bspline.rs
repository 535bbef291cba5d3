//! B-splines: a window of `degree + 1` poles that slides along the net (book 341, 343).

use pforms_kernel::{Error, Form, Result, Scalar, limit};

use crate::algebra::{Knots, Spline};

/// Which knots a B-spline gets along an axis.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum KnotRule<S = f64> {
    /// The book's sliding window: knots one apart. `n` poles of degree `p` make `n − p` pieces, piece
    /// `i` over `[i, i + 1]`; the ends are not on the spline.
    #[default]
    Uniform,
    /// The same window from 0 to `n − p`, the knots at its ends repeated `p + 1` times: the spline
    /// begins and ends in its first and last pole.
    Clamped,
    /// Given: `poles + degree + 1` knots; for a closed axis `poles + 1`, one turn.
    Given(Vec<S>),
}

/// The B-spline of the given poles: a degree, a rule for the knots, and closed or open, for each axis.
///
/// A closed axis goes on from the last pole to the first, as smooth there as elsewhere. Weights of
/// poles are kept, so this is a NURBS too. Exact.
///
/// Errors: `Shape` unless there is one entry for each axis, when an open axis has no more poles than
/// its degree, for clamped knots on a closed axis, and for a wrong number of given knots; `Domain` for
/// knots that decrease, are not finite, or coincide more than `degree + 1` times; `Limit`.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{KnotRule, bspline};
/// let poles: Form = Form::from_points(&[4], 2, &[0., 0., 0., 2., 2., 2., 2., 0.], None)?;
/// let open = bspline(&poles, &[2], &[KnotRule::Uniform], &[false])?;
/// assert_eq!(open.pieces()?[0].points()?, [0., 1., 0., 2., 1., 2.]);
/// let closed = bspline(&poles, &[2], &[KnotRule::Uniform], &[true])?;
/// assert_eq!(closed.counts(), [4]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn bspline<S: Scalar>(
    poles: &Form<S>,
    degrees: &[usize],
    knots: &[KnotRule<S>],
    closed: &[bool],
) -> Result<Spline<S>> {
    poles.require_per_axis("degrees", degrees)?;
    poles.require_per_axis("knots", knots)?;
    poles.require_per_axis("closed", closed)?;
    let mut net = poles.clone();
    let mut all = Vec::with_capacity(degrees.len());
    for (axis, ((&degree, rule), &closed)) in degrees.iter().zip(knots).zip(closed).enumerate() {
        let count = poles.orders()[axis];
        if closed {
            net = wound(&net, axis, degree)?;
            all.push(turns(rule, degree, count)?);
        } else {
            all.push(once(rule, degree, count)?);
        }
    }
    Spline::on(net, all)
}

/// The NURBS of the given poles and full knot vectors, which say its degrees: an axis of `n` poles
/// and `m` knots has degree `m − n − 1`.
///
/// Errors: `Shape` unless there is one vector for each axis, of more knots than poles and no fewer
/// than `2·degree + 2`; `Domain` for knots that decrease, are not finite, or coincide more than
/// `degree + 1` times.
///
/// ```
/// use pforms_kernel::Form;
/// let w = 0.5_f64.sqrt();
/// let poles = Form::from_points(
///     &[5], 2, &[1., 0., 1., 1., 0., 1., -1., 1., -1., 0.], Some(&[1., w, 1., w, 1.]))?;
/// let half_circle = pforms_operators::nurbs(poles, vec![vec![0., 0., 0., 1., 1., 2., 2., 2.]])?;
/// assert_eq!(half_circle.degrees(), [2]);
/// assert_eq!(half_circle.at(&[1.0])?, [0.0, 1.0]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn nurbs<S: Scalar>(poles: Form<S>, knots: Vec<Vec<S>>) -> Result<Spline<S>> {
    poles.require_per_axis("knots", &knots)?;
    let mut degrees = Vec::with_capacity(knots.len());
    for (axis, (list, &count)) in knots.iter().zip(poles.orders()).enumerate() {
        let degree = list.len().checked_sub(count + 1).ok_or_else(|| {
            Error::shape(
                "knots",
                format!("{} knots for {count} poles along axis {axis}", list.len()),
                "poles + degree + 1",
            )
        })?;
        degrees.push(degree);
    }
    Spline::new(poles, &degrees, knots)
}

fn once<S: Scalar>(rule: &KnotRule<S>, degree: usize, count: usize) -> Result<Knots<S>> {
    if let KnotRule::Given(list) = rule {
        require_count(list.len(), count + degree + 1)?;
        return Knots::new(degree, list.clone());
    }
    let pieces = count.checked_sub(degree).filter(|pieces| *pieces > 0).ok_or_else(|| {
        Error::shape(
            "degree",
            format!("degree {degree} for {count} poles"),
            format!("at most {}, one less than there are poles", count - 1),
        )
    })?;
    let last = pieces as i64;
    let clamp = |i: i64| if matches!(rule, KnotRule::Clamped) { i.clamp(0, last) } else { i };
    let all = -(degree as i64)..=count as i64;
    Knots::new(degree, all.map(|i| S::from_integer(clamp(i))).collect())
}

/// The knots of one turn, wound on at both ends.
fn turns<S: Scalar>(rule: &KnotRule<S>, degree: usize, count: usize) -> Result<Knots<S>> {
    let turn = match rule {
        KnotRule::Uniform => (0..=count as i64).map(S::from_integer).collect(),
        KnotRule::Given(list) => {
            require_count(list.len(), count + 1)?;
            list.clone()
        }
        KnotRule::Clamped => {
            return Err(Error::shape(
                "knots",
                "clamped knots for a closed axis",
                "uniform knots, or one turn of given ones",
            ));
        }
    };
    let period = turn[count].clone() - turn[0].clone();
    let knot = |i: i64| {
        let laps = S::from_integer(i.div_euclid(count as i64));
        turn[i.rem_euclid(count as i64) as usize].clone() + laps * period.clone()
    };
    let all = -(degree as i64)..=(count + degree) as i64;
    Knots::new(degree, all.map(knot).collect())
}

/// The net with `more` poles from its start again at its end, along `axis`.
pub(super) fn wound<S: Scalar>(net: &Form<S>, axis: usize, more: usize) -> Result<Form<S>> {
    let count = net.orders()[axis];
    let mut orders = net.orders().to_vec();
    orders[axis] = count.saturating_add(more);
    let numbers = limit::check::<S>("the closed net", &orders, net.width())?;
    let inner = net.orders()[axis + 1..].iter().product::<usize>() * net.width();
    let mut poles = Vec::with_capacity(numbers);
    for block in net.homogeneous().chunks_exact(count * inner) {
        for i in 0..count + more {
            poles.extend_from_slice(&block[i % count * inner..][..inner]);
        }
    }
    Form::from_homogeneous(&orders, net.ambient(), poles)
}

fn require_count(received: usize, expected: usize) -> Result<()> {
    if received == expected {
        return Ok(());
    }
    Err(Error::shape("knots", format!("{received} knots"), format!("{expected} for these poles")))
}
