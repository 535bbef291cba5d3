//! Fewer knots: knot insertion run backwards.

use pforms_kernel::{Error, Result, Scalar};

use super::rows::{Row, Rows};
use super::{Knots, Spline};

/// A spline of fewer knots, and the spline it replaces raised to the same poles.
#[derive(Clone, Debug, PartialEq)]
pub struct Removal<S = f64> {
    /// The spline without the knot.
    pub spline: Spline<S>,
    /// How far a homogeneous pole of the original is from what inserting the knot again gives, at
    /// most: 0 when the knot was not needed. A polynomial spline of weight 1 moves by no more than
    /// the square root of its dimension times this.
    pub defect: S,
}

impl<S: Scalar> Spline<S> {
    /// The spline with the knot `t` of `axis` repeated once less, exact if the spline is smooth
    /// enough there; otherwise near, and `defect` says how near.
    ///
    /// The equations of knot insertion are solved from both ends, where they do not amplify.
    /// *The NURBS Book*, section 5.4.
    ///
    /// Errors: `Shape` when there is no such axis; `Domain` unless `t` is an inner knot.
    ///
    /// ```
    /// use pforms_kernel::Form;
    /// use pforms_operators::Spline;
    /// let line: Spline = Form::from_points(&[3], 1, &[0., 1., 4.], None)?.into();
    /// let cut = line.insert_knots(0, &[0.5])?;
    /// let again = cut.remove_knot(0, &0.5)?;
    /// assert_eq!((again.spline, again.defect), (line, 0.0));
    /// # Ok::<(), pforms_kernel::Error>(())
    /// ```
    pub fn remove_knot(&self, axis: usize, t: &S) -> Result<Removal<S>> {
        self.net.require_axis(axis)?;
        let fewer = self.knots[axis].without(t)?;
        let insertion = fewer.refinement(&self.knots[axis])?;
        let net = removal(&insertion, fewer.order()).act(&self.net, axis)?;
        let again = insertion.act(&net, axis)?;
        let defect = farthest(again.homogeneous(), self.net.homogeneous());
        let mut knots = self.knots.clone();
        knots[axis] = fewer;
        let spline = Self { net, knots };
        Ok(Removal { spline, defect })
    }
}

/// The largest difference of two numbers at one place.
pub(super) fn farthest<S: Scalar>(there: &[S], here: &[S]) -> S {
    let gaps = there.iter().zip(here).map(|(there, here)| {
        let gap = there.clone() - here.clone();
        if gap < S::zero() { -gap } else { gap }
    });
    gaps.fold(S::zero(), |most, gap| if gap > most { gap } else { most })
}

impl<S: Scalar> Knots<S> {
    /// These knots with one `t` less.
    pub(super) fn without(&self, t: &S) -> Result<Self> {
        let (from, to) = self.window();
        if !(from < t && t < to && self.multiplicity(t) > 0) {
            let inner: Vec<S> = self.breaks().into_iter().filter(|b| b > from && b < to).collect();
            return Err(Error::domain(
                "t",
                format!("{t:?}"),
                format!("an inner knot of {inner:?}"),
            ));
        }
        let mut list = self.as_slice().to_vec();
        list.remove(list.partition_point(|knot| knot < t));
        Self::new(self.degree(), list)
    }
}

/// The matrix to the poles over the `few` knots that the `insertion` of one starts from.
///
/// Inserting gives `q_i = a_i·p_i + (1 − a_i)·p_{i−1}` for the poles near the knot: each `p_i` is read
/// from the left while `a_i` is at least a half, else from the right.
pub(super) fn removal<S: Scalar>(insertion: &Rows<S>, few: usize) -> Rows<S> {
    let share = |i: usize| if i < few { insertion.row(i).entry(i) } else { S::zero() };
    let half = S::ratio(1, 2);
    let turn = (0..few).find(|&i| share(i) < half).unwrap_or(few);
    let solved = |i: usize, own: &S, other: Option<&Row<S>>| match other {
        Some(other) if *own != S::one() => {
            Row::unit(i).with_multiple(&(own.clone() - S::one()), other, own)
        }
        _ => Row::unit(i),
    };
    let mut rows: Vec<Row<S>> = Vec::with_capacity(few);
    for i in 0..turn {
        rows.push(solved(i, &share(i), rows.last()));
    }
    let mut rest: Vec<Row<S>> = Vec::with_capacity(few - turn);
    for i in (turn..few).rev() {
        // q_{i+1} = a·p_{i+1} + (1 − a)·p_i
        rest.push(solved(i + 1, &(S::one() - share(i + 1)), rest.last()));
    }
    rows.extend(rest.into_iter().rev());
    Rows::new(rows)
}
