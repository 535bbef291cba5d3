//! Diagonalisation: two parameters become one.
//!
//! `q_k = Σ_{i+j=k} C(m−1,i)·C(n−1,j)/C(m+n−2,k) · p_ij` (book 12 and 13): sums along the antidiagonals.

use pforms_kernel::{Error, Form, Result, Scalar, limit, pascal_row};

/// The form on the diagonal of axes `first` and `second`: orders `m` and `n` give `m + n − 1`.
///
/// The new axis stands where the lower of the two stood. In `f64` every pole is a mean of old
/// ones with positive weights, within `order + 5` roundings of the exact one.
///
/// Errors: `Shape` when the axes are the same or not there; `Limit`.
///
/// ```
/// use pforms_kernel::Form;
/// let facet: Form = Form::from_points(&[2, 2], 1, &[0., 1., 3., 4.], None)?;
/// assert_eq!(pforms_operators::diagonal(&facet, 0, 1)?.points()?, [0., 2., 4.]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn diagonal<S: Scalar>(form: &Form<S>, first: usize, second: usize) -> Result<Form<S>> {
    require_two_axes(form)?;
    if first == second {
        return Err(Error::shape("axes", format!("({first}, {second})"), "two different axes"));
    }
    form.require_axis(first)?;
    form.require_axis(second)?;
    let (low, high) = (first.min(second), first.max(second));
    let mut orders = form.orders().to_vec();
    orders[low] += orders.remove(high) - 1;
    let poles = vec![S::zero(); limit::check::<S>("the diagonal", &orders, form.width())?];
    limit::check_degree::<S>(orders[low] - 1)?;
    let merged = Form::from_homogeneous(&orders, form.ambient(), merged(form, low, high, poles))?;
    Ok(match form.uniform_weight() {
        Some(weight) => merged.with_uniform_weight(weight),
        None => merged,
    })
}

/// The sums along the antidiagonals of two axes, added to `sums`; all other axes are left alone.
fn merged<S: Scalar>(form: &Form<S>, low: usize, high: usize, mut sums: Vec<S>) -> Vec<S> {
    let orders = form.orders();
    let (m, n) = (orders[low], orders[high]);
    let (rows, columns) = (pascal_row::<S>(m - 1), pascal_row::<S>(n - 1));
    let binomials = pascal_row::<S>(m + n - 2);
    let inner = orders[high + 1..].iter().product::<usize>() * form.width();
    let share = orders[low + 1..high].iter().product::<usize>() * inner;
    let blocks = form.homogeneous().chunks_exact(m * n * share);
    for (block, part) in blocks.zip(sums.chunks_exact_mut((m + n - 1) * share)) {
        for (i, (row, own)) in block.chunks_exact(n * share).zip(&rows).enumerate() {
            for (place, lines) in row.chunks_exact(n * inner).enumerate() {
                for (j, (line, other)) in lines.chunks_exact(inner).zip(&columns).enumerate() {
                    let target = &mut part[(i + j) * share + place * inner..][..inner];
                    S::add_multiple(target, &(own.clone() * other.clone()), line);
                }
            }
        }
        // The outermost binomials are 1.
        let inside = part.chunks_exact_mut(share).zip(&binomials).skip(1).take((m + n).max(3) - 3);
        for (sums, binomial) in inside {
            for sum in sums {
                *sum = sum.clone() / binomial.clone();
            }
        }
    }
    sums
}

/// The curve on the diagonal of all axes: the last two are merged until one is left.
///
/// Errors: as [`diagonal`]; a form of fewer than two axes has no diagonal.
pub fn diagonal_all<S: Scalar>(form: &Form<S>) -> Result<Form<S>> {
    require_two_axes(form)?;
    let mut curve = form.clone();
    while curve.axes() > 1 {
        curve = diagonal(&curve, curve.axes() - 2, curve.axes() - 1)?;
    }
    Ok(curve)
}

fn require_two_axes<S: Scalar>(form: &Form<S>) -> Result<()> {
    if form.axes() >= 2 {
        return Ok(());
    }
    Err(Error::shape("form", format!("a {}", form.kind()), "a form with at least two axes"))
}
