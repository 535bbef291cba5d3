//! Stretching: the same form over another window; splitting is two stretches.

#![allow(clippy::inline_always, reason = "only what is inlined is compiled for the wider vectors")]

use pforms_kernel::vectors::{Job, Simd};
use pforms_kernel::{Error, Form, Matrix, Result, Scalar};

use super::along::act_along;

/// The form on the window `[a, b]`: restricted, extended or reversed along each axis.
///
/// Any reals: `a > b` reverses, values outside `[0, 1]` extrapolate, `a = b` collapses the axis to
/// a point. Pole `i` is the blossom value with `n − i` arguments `a` and `i` arguments `b`, so
/// nothing is divided. Stretches compose. Book 213; Ramshaw 1987.
///
/// In `f64` and for `a`, `b` in `[0, 1]` within `2·degree + 2` roundings for each axis; outside,
/// the same times `((|1−a|+|a|) · (|1−b|+|b|))^degree`, the growth of the extrapolation itself.
///
/// Errors: `Shape` unless there is one `a` and one `b` for each axis; `Domain` when not finite.
///
/// ```
/// use pforms_kernel::Form;
/// let segment: Form = Form::from_points(&[2], 1, &[0., 1.], None)?;
/// assert_eq!(pforms_operators::stretch(&segment, &[3.0], &[-1.0])?.points()?, [3., -1.]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn stretch<S: Scalar>(form: &Form<S>, a: &[S], b: &[S]) -> Result<Form<S>> {
    form.require_per_axis("a", a)?;
    form.require_per_axis("b", b)?;
    require_finite("a", a)?;
    require_finite("b", b)?;
    let axes = (0..form.axes()).filter(|&axis| !(a[axis].is_zero() && b[axis] == S::one()));
    let window = |axis: usize| (form.orders()[axis] - 1, a[axis].clone(), b[axis].clone());
    act_along(form, axes, window, |(degree, from, to)| Ok(stretch_matrix(*degree, from, to)))
}

/// The two parts of a form at parameter `t` of `axis`: the windows `[0, t]` and `[t, 1]`.
///
/// Any real `t`; the first pole of the second part is the last of the first, to the bit.
///
/// Errors: `Shape` when there is no such axis, `Domain` when `t` is not finite.
pub fn split<S: Scalar>(form: &Form<S>, axis: usize, t: &S) -> Result<(Form<S>, Form<S>)> {
    form.require_axis(axis)?;
    require_finite("t", std::slice::from_ref(t))?;
    let inner = form.orders()[axis + 1..].iter().product::<usize>() * form.width();
    let mut low = form.homogeneous().to_vec();
    let mut high = low.clone();
    let (order, complement) = (form.orders()[axis], S::one() - t.clone());
    let (left, right) = (&mut low, &mut high);
    S::in_lanes(Triangle { low: left, high: right, order, inner, weights: [&complement, t] });
    let part = |poles: Vec<S>| -> Result<Form<S>> {
        let part = Form::from_homogeneous(form.orders(), form.ambient(), poles)?;
        Ok(match form.uniform_weight() {
            Some(weight) => part.with_uniform_weight(weight),
            None => part,
        })
    };
    Ok((part(low)?, part(high)?))
}

/// The triangle of de Casteljau, whose two sides are the poles of the parts.
struct Triangle<'a, S> {
    /// The poles, which become those of the first part.
    low: &'a mut [S],
    high: &'a mut [S],
    order: usize,
    inner: usize,
    /// `1 − t` and `t`.
    weights: [&'a S; 2],
}

impl<S: Scalar> Job for Triangle<'_, S> {
    type Output = ();

    #[inline(always)]
    fn run<V: Simd>(self, _: V) {
        let Self { low, high, order, inner, weights: [s, t] } = self;
        let blocks = low.chunks_exact_mut(order * inner).zip(high.chunks_exact_mut(order * inner));
        for (low, high) in blocks {
            for step in 1..order {
                for i in (step..order).rev() {
                    let (before, here) = low.split_at_mut(i * inner);
                    for (x, left) in here[..inner].iter_mut().zip(&before[(i - 1) * inner..]) {
                        *x = s.clone() * left.clone() + t.clone() * x.clone();
                    }
                }
                let end = (order - 1) * inner;
                high[end - step * inner..][..inner].clone_from_slice(&low[end..][..inner]);
            }
        }
    }
}

/// The square matrix that takes the poles of a degree to those on the window `[a, b]`.
pub fn stretch_matrix<S: Scalar>(degree: usize, a: &S, b: &S) -> Matrix<S> {
    let pair = |t: &S| [S::one() - t.clone(), t.clone()];
    let (start, end) = (pair(a), pair(b));
    Matrix::from_writer(degree + 1, degree + 1, |i, row| {
        row[0] = S::one();
        for step in 1..=degree {
            let [s, t] = if step <= degree - i { &start } else { &end };
            for k in (1..=step).rev() {
                row[k] = s.clone() * row[k].clone() + t.clone() * row[k - 1].clone();
            }
            row[0] = s.clone() * row[0].clone();
        }
    })
}

fn require_finite<S: Scalar>(argument: &str, values: &[S]) -> Result<()> {
    match values.iter().find(|value| !value.is_finite()) {
        None => Ok(()),
        Some(value) => Err(Error::domain(
            argument,
            format!("{value:?}"),
            "finite numbers (for a window that reaches infinity see whole_line)",
        )),
    }
}
