//! Subdivision: the control nets of the halves of halves.

#![allow(clippy::inline_always, reason = "only what is inlined is compiled for the wider vectors")]

use pforms_kernel::vectors::{Job, Simd};
use pforms_kernel::{Form, Matrix, Result, Scalar, limit};

use super::partition::parts;
use super::{Spline, partition};

/// The form as `2^r` pieces along each axis: the refined net, `(n − 1)·2^r + 1` poles.
///
/// The pieces *are* the form; their poles approach it by a factor 4 with each level. The
/// coefficients are dyadic, so in `f64` each level adds at most `degree` roundings. An axis of a
/// single pole stays in one piece: all its parts are the same. Book 211.
///
/// Errors: `Shape` unless there is one level for each axis; `Limit`.
///
/// ```
/// use pforms_kernel::Form;
/// let parabola: Form = Form::from_points(&[3], 1, &[0., 2., 0.], None)?;
/// let halves = pforms_operators::subdivide(&parabola, &[1])?;
/// assert_eq!(halves.net().points()?, [0., 1., 1., 1., 0.]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn subdivide<S: Scalar>(form: &Form<S>, r: &[u32]) -> Result<Spline<S>> {
    form.require_per_axis("r", r)?;
    let degrees = form.degrees();
    let mut orders = Vec::with_capacity(r.len());
    for (degree, &levels) in degrees.iter().zip(r) {
        orders.push(degree.saturating_mul(parts("r", levels)?).saturating_add(1));
    }
    limit::check::<S>("the refined net", &orders, form.width())?;
    let mut poles = form.homogeneous().to_vec();
    let mut breaks = Vec::with_capacity(r.len());
    let mut inner = form.width() * form.orders().iter().product::<usize>();
    for (axis, &levels) in r.iter().enumerate() {
        inner /= form.orders()[axis];
        if levels > 0 {
            poles = halved(&poles, degrees[axis], orders[axis], inner);
        }
        breaks.push(partition(&S::zero(), &S::one(), levels)?);
    }
    Spline::joined(Form::from_homogeneous(&orders, form.ambient(), poles)?, &degrees, &breaks)
}

/// The matrix of subdivision at level `r`: `degree·2^r + 1` rows, `degree + 1` columns.
///
/// Made by halving the poles' own indicator functions.
///
/// Errors: `Limit`.
pub fn subdivision_matrix<S: Scalar>(degree: usize, r: u32) -> Result<Matrix<S>> {
    let (rows, columns) = (degree.saturating_mul(parts("r", r)?).saturating_add(1), degree + 1);
    limit::check::<S>("the subdivision matrix", &[rows, columns], 1)?;
    let unit = |k: usize| if k.is_multiple_of(columns + 1) { S::one() } else { S::zero() };
    let identity: Vec<S> = (0..columns * columns).map(unit).collect();
    let net = halved(&identity, degree, rows, columns);
    Ok(Matrix::from_rule(rows, columns, |i, j| net[i * columns + j].clone()))
}

/// The poles of lines of the given degree, halved until there are `order` of them.
fn halved<S: Scalar>(poles: &[S], degree: usize, order: usize, inner: usize) -> Vec<S> {
    let line = (degree + 1) * inner;
    let mut net = vec![S::zero(); poles.len() / line * order * inner];
    for (target, source) in net.chunks_exact_mut(order * inner).zip(poles.chunks_exact(line)) {
        target[..line].clone_from_slice(source);
    }
    S::in_lanes(Halving { net: &mut net, degree, order, inner });
    net
}

/// Halves each piece of a net in its place, until the pieces lie end to end.
struct Halving<'a, S> {
    net: &'a mut [S],
    degree: usize,
    order: usize,
    inner: usize,
}

impl<S: Scalar> Job for Halving<'_, S> {
    type Output = ();

    #[inline(always)]
    fn run<V: Simd>(self, _: V) {
        let Self { net, degree, order, inner } = self;
        for block in net.chunks_exact_mut(order * inner) {
            let mut span = order - 1;
            while span > degree {
                for start in (0..order - 1).step_by(span) {
                    split(&mut block[start * inner..], degree, span / 2, inner);
                }
                span /= 2;
            }
        }
    }
}

/// The triangle of de Casteljau at ½: the first poles of `lines` become those of the first half;
/// those of the second begin `half` lines on.
#[inline(always)]
fn split<S: Scalar>(lines: &mut [S], degree: usize, half: usize, inner: usize) {
    let middle = S::ratio(1, 2);
    for step in 1..=degree {
        copy_line(lines, degree, half + degree - step + 1, inner);
        for i in (step..=degree).rev() {
            let (before, here) = lines.split_at_mut(i * inner);
            for (x, left) in here[..inner].iter_mut().zip(&before[(i - 1) * inner..]) {
                *x = middle.clone() * (left.clone() + x.clone());
            }
        }
    }
    copy_line(lines, degree, half, inner);
}

/// Copies a line over one that is not before it.
#[inline(always)]
fn copy_line<S: Scalar>(lines: &mut [S], from: usize, to: usize, inner: usize) {
    if from < to {
        let (before, after) = lines.split_at_mut(to * inner);
        after[..inner].clone_from_slice(&before[from * inner..][..inner]);
    }
}
