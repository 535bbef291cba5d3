//! Acting along several axes: equal matrices are made once.

use pforms_kernel::{Form, Matrix, Result, Scalar};

/// The form after the matrix `make(key(axis))` has acted along each of the axes, which ascend.
///
/// Axes of the same key share one matrix.
pub(super) fn act_along<S: Scalar, K: PartialEq>(
    form: &Form<S>,
    axes: impl Iterator<Item = usize>,
    key: impl Fn(usize) -> K,
    make: impl Fn(&K) -> Result<Matrix<S>>,
) -> Result<Form<S>> {
    let mut made: Vec<(K, Matrix<S>)> = Vec::new();
    let mut which = Vec::with_capacity(form.axes());
    for axis in axes {
        let key = key(axis);
        let known = made.iter().position(|(other, _)| *other == key);
        which.push((axis, known.unwrap_or(made.len())));
        if known.is_none() {
            let matrix = make(&key)?;
            made.push((key, matrix));
        }
    }
    let acts: Vec<(usize, &Matrix<S>)> =
        which.into_iter().map(|(axis, k)| (axis, &made[k].1)).collect();
    form.along_all_affine(&acts)
}
