//! Subdivision: the control nets of the halves of halves.

use pforms_kernel::{Form, Matrix, Result, Scalar, limit};

use super::along::act_along;
use super::partition::parts;
use super::{Piecewise, partition};

/// The form as `2^r` pieces along each axis: the refined net, `(n − 1)·2^r + 1` poles.
///
/// The pieces *are* the form; their poles approach it by a factor 4 with each level. The
/// coefficients are dyadic, so in `f64` each level adds at most `degree` roundings. Book 211.
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
pub fn subdivide<S: Scalar>(form: &Form<S>, r: &[u32]) -> Result<Piecewise<S>> {
    form.require_per_axis("r", r)?;
    let degrees = form.degrees();
    let mut orders = Vec::with_capacity(r.len());
    for (degree, &levels) in degrees.iter().zip(r) {
        orders.push(degree.saturating_mul(parts("r", levels)?).saturating_add(1));
    }
    limit::check::<S>("the refined net", &orders, form.width())?;
    let axes = (0..form.axes()).filter(|&axis| r[axis] > 0);
    let net = act_along(
        form,
        axes,
        |axis| (degrees[axis], r[axis]),
        |&(degree, levels)| subdivision_matrix(degree, levels),
    )?;
    let breaks = r.iter().map(|&levels| partition(&S::zero(), &S::one(), levels));
    Piecewise::new(net, degrees, breaks.collect::<Result<_>>()?)
}

/// The matrix of subdivision at level `r`: `degree·2^r + 1` rows, `degree + 1` columns.
///
/// Made by halving the poles' own indicator functions.
///
/// Errors: `Limit`.
pub fn subdivision_matrix<S: Scalar>(degree: usize, r: u32) -> Result<Matrix<S>> {
    let rows = degree.saturating_mul(parts("r", r)?).saturating_add(1);
    limit::check::<S>("the subdivision matrix", &[rows, degree + 1], 1)?;
    let mut net: Vec<S> = identity(degree + 1);
    for _ in 0..r {
        net = halved(&net, degree);
    }
    Ok(Matrix::from_rule(rows, degree + 1, |i, j| net[i * (degree + 1) + j].clone()))
}

fn identity<S: Scalar>(size: usize) -> Vec<S> {
    let entry = |k| if k / size == k % size { S::one() } else { S::zero() };
    (0..size * size).map(entry).collect()
}

/// The rows of the halves of pieces that share their end rows.
fn halved<S: Scalar>(net: &[S], degree: usize) -> Vec<S> {
    let size = degree + 1;
    let mut halves = Vec::with_capacity(2 * net.len());
    // A constant has a single pole, which no two pieces share.
    for start in (0..(net.len() / size).saturating_sub(1).max(1)).step_by(degree.max(1)) {
        halves.truncate(halves.len().saturating_sub(size));
        push_halves(net[start * size..][..size * size].to_vec(), size, &mut halves);
    }
    halves
}

/// The triangle of de Casteljau at ½: its two sides are the poles of the halves, which meet in one.
fn push_halves<S: Scalar>(mut level: Vec<S>, size: usize, net: &mut Vec<S>) {
    let start = net.len();
    net.resize(start + (2 * size - 1) * size, S::zero());
    let places = &mut net[start..];
    let half = S::ratio(1, 2);
    for step in 0..size {
        let last = size - 1 - step;
        places[step * size..][..size].clone_from_slice(&level[..size]);
        places[(2 * (size - 1) - step) * size..][..size]
            .clone_from_slice(&level[last * size..][..size]);
        for k in 0..last * size {
            level[k] = half.clone() * (level[k].clone() + level[k + size].clone());
        }
    }
}
