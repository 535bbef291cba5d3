//! Peano's curve: one axis that comes by everywhere.

use pforms_kernel::{Error, Form, Result, Scalar, limit};

use super::Spline;

/// Generation `n` of Peano's curve in the unit square, or the unit cube of `axes` dimensions.
///
/// A line through the middles of all `3ⁿ` cells along each axis, from cell to neighbouring cell, as
/// a spline of degree 1 at equal steps of its parameter. Immersed in a form it runs all over it.
/// Exact. G. Peano, *Sur une courbe, qui remplit toute une aire plane*, 1890: the digits of the
/// parameter to the base 3 are those of the coordinates in turn, each counted backwards where the
/// digits of the others before it add up to an odd number. Book 37, remark 1.
///
/// Errors: `Shape` for no axis; `Limit`.
///
/// ```
/// let curve = pforms_operators::peano::<f64>(1, 2)?;
/// let middles: Vec<f64> = curve.net().points()?.iter().map(|x| (6.0 * x).round()).collect();
/// assert_eq!(middles[..8], [1., 1., 1., 3., 1., 5., 3., 5.]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn peano<S: Scalar>(n: usize, axes: usize) -> Result<Spline<S>> {
    if axes == 0 || n == 0 {
        return Err(Error::shape("axes", axes.min(n), "one axis and one generation at least"));
    }
    let digits = n.saturating_mul(axes);
    limit::check::<S>("Peano's curve", &vec![3; digits.min(256)], axes)?;
    let (count, side) = (3_usize.pow(digits as u32), 3_i64.pow(n as u32));
    let mut poles = Vec::with_capacity(count * (axes + 1));
    for number in 0..count {
        for cell in cell(number, n, axes) {
            poles.push(S::ratio(2 * cell + 1, 2 * side));
        }
        poles.push(S::one());
    }
    let last = count as i64 - 1;
    let mut knots = vec![S::zero()];
    knots.extend((0..=last).map(|k| S::ratio(k, last)));
    knots.push(S::one());
    Spline::new(Form::from_homogeneous(&[count], axes, poles)?, &[1], vec![knots])
}

/// The place along each axis of the cell of this number.
fn cell(number: usize, n: usize, axes: usize) -> Vec<i64> {
    let mut place = vec![0; axes];
    let mut sums = vec![0; axes];
    for step in 0..n * axes {
        let digit = (number / 3_usize.pow((n * axes - 1 - step) as u32) % 3) as i64;
        let axis = step % axes;
        let others: i64 = (0..axes).filter(|k| *k != axis).map(|k| sums[k]).sum();
        let turned = if others % 2 == 1 { 2 - digit } else { digit };
        place[axis] = 3 * place[axis] + turned;
        sums[axis] += digit;
    }
    place
}
