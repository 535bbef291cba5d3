//! Regular nets: straight, flat and square to begin with, and ready to be bent.

use pforms_kernel::{Error, Form, Result, Scalar, limit};

/// A net of poles at equal steps in a box about the origin: coordinate `k` runs with axis `k` from
/// `−sizes[k]/2` to `sizes[k]/2`, the other coordinates are 0.
///
/// With one axis this is the book's line, with two its facet, with three its cube; any number will do.
/// An axis of a single pole stays in the middle. Parameters and coordinates are proportional, so the
/// form is the identity up to scale. Exact; in `f64` one rounding a coordinate.
///
/// Errors: `Shape` when the sizes are not as many as the axes, or the space has fewer coordinates than
/// axes; `Domain` when a size is not finite; `Limit`. Book 321.
///
/// ```
/// let line = pforms_operators::regular::<f64>(&[3], &[2.0], 3)?;
/// assert_eq!(line.points()?, [-1., 0., 0., 0., 0., 0., 1., 0., 0.]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn regular<S: Scalar>(orders: &[usize], sizes: &[S], ambient: usize) -> Result<Form<S>> {
    if sizes.len() != orders.len() {
        let expected = format!("{}, one for each axis", orders.len());
        return Err(Error::shape("sizes", format!("{} numbers", sizes.len()), expected));
    }
    if ambient < orders.len() {
        let expected = format!("at least {}, one for each axis", orders.len());
        return Err(Error::shape("ambient", ambient, expected));
    }
    if let Some(bad) = sizes.iter().find(|size| !size.is_finite()) {
        return Err(Error::domain("sizes", format!("{bad:?}"), "finite numbers"));
    }
    let count = limit::check::<S>("the net", orders, ambient + 1)?;
    let rows: Vec<Vec<S>> = orders.iter().zip(sizes).map(|(&n, size)| steps(n, size)).collect();
    let mut poles = Vec::with_capacity(count);
    for index in 0..orders.iter().product() {
        poles.extend(place(index, &rows));
        poles.extend((orders.len()..ambient).map(|_| S::zero()));
        poles.push(S::one());
    }
    Form::from_homogeneous(orders, ambient, poles)
}

/// Numbers at equal steps from `−size/2` to `size/2`.
fn steps<S: Scalar>(count: usize, size: &S) -> Vec<S> {
    let last = count.saturating_sub(1) as i64;
    let share = |i: i64| if last == 0 { S::zero() } else { S::ratio(2 * i - last, 2 * last) };
    (0..=last).map(|i| share(i) * size.clone()).collect()
}

/// The coordinates of a pole, given its number in C order.
fn place<S: Scalar>(index: usize, rows: &[Vec<S>]) -> Vec<S> {
    let mut rest = index;
    let mut coordinates: Vec<S> = Vec::with_capacity(rows.len());
    for row in rows.iter().rev() {
        coordinates.push(row[rest % row.len()].clone());
        rest /= row.len();
    }
    coordinates.reverse();
    coordinates
}
