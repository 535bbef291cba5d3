//! Subdivision: the control nets of the halves of halves.

use pforms_kernel::{Form, Matrix, Result, Scalar, limit};

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
    let mut net = form.clone();
    let mut breaks = Vec::with_capacity(r.len());
    for (axis, &levels) in r.iter().enumerate() {
        if levels > 0 {
            net = net.along_affine(axis, &subdivision_matrix(degrees[axis], levels)?)?;
        }
        breaks.push(partition(&S::zero(), &S::one(), levels)?);
    }
    Piecewise::new(net, degrees, breaks)
}

/// The matrix of subdivision at level `r`: `degree·2^r + 1` rows, `degree + 1` columns.
///
/// Made by halving the poles' own indicator functions.
///
/// Errors: `Limit`.
pub fn subdivision_matrix<S: Scalar>(degree: usize, r: u32) -> Result<Matrix<S>> {
    let rows = degree.saturating_mul(parts("r", r)?).saturating_add(1);
    limit::check::<S>("the subdivision matrix", &[rows, degree + 1], 1)?;
    let mut pieces = vec![identity::<S>(degree + 1)];
    for _ in 0..r {
        pieces = pieces.into_iter().flat_map(halves).collect();
    }
    let mut net = Vec::with_capacity(rows);
    for piece in pieces {
        net.pop();
        net.extend(piece);
    }
    net.truncate(rows);
    Matrix::from_rows(net)
}

type Rows<S> = Vec<Vec<S>>;

fn identity<S: Scalar>(size: usize) -> Rows<S> {
    let entry = |i, j| if i == j { S::one() } else { S::zero() };
    (0..size).map(|i| (0..size).map(|j| entry(i, j)).collect()).collect()
}

/// The triangle of de Casteljau at ½: its two sides are the poles of the halves.
fn halves<S: Scalar>(poles: Rows<S>) -> [Rows<S>; 2] {
    let mut left = Vec::with_capacity(poles.len());
    let mut right = Vec::with_capacity(poles.len());
    let mut level = poles;
    while let (Some(first), Some(last)) = (level.first(), level.last()) {
        left.push(first.clone());
        right.push(last.clone());
        level = level.windows(2).map(|pair| middle(&pair[0], &pair[1])).collect();
    }
    right.reverse();
    [left, right]
}

fn middle<S: Scalar>(a: &[S], b: &[S]) -> Vec<S> {
    let half = S::ratio(1, 2);
    let pairs = a.iter().zip(b);
    pairs.map(|(x, y)| half.clone() * (x.clone() + y.clone())).collect()
}
