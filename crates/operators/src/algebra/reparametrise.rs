//! Projective changes of parameter: the same points, other weights; and the whole line.

use pforms_kernel::{Error, Form, Matrix, Result, Scalar, projective_blossom_row};

/// The form with parameter `axis` replaced by `c·s / ((1 − s) + c·s)`: the same set of points, the
/// same ends, other weights (pole `i` is multiplied by `cⁱ`).
///
/// `c > 0` keeps the window; `c < 0` runs from the first end to the last *through infinity*: the
/// complementary arc of a conic. Exact. Book 311; Farin, section 13.6.
///
/// Errors: `Shape` when there is no such axis; `Degenerate` when `c` is 0; `Domain` when not finite.
pub fn reparametrise<S: Scalar>(form: &Form<S>, axis: usize, c: &S) -> Result<Form<S>> {
    form.require_axis(axis)?;
    if !c.is_finite() {
        return Err(Error::domain("c", format!("{c:?}"), "a finite number"));
    }
    if c.is_zero() {
        return Err(Error::degenerate(
            "c",
            "0",
            "a number other than 0 (0 would keep only the first pole)",
        ));
    }
    let order = form.orders()[axis];
    let diagonal =
        Matrix::from_rule(order, order, |i, j| if i == j { c.power(i) } else { S::zero() });
    form.along(axis, &diagonal)
}

/// The form over the whole projective line of parameter `axis`, as three forms on finite windows:
/// `[−∞, 0]`, `[0, 1]` and `[1, +∞]`.
///
/// Put end to end they close, even or odd degree, since −∞ and +∞ are one parameter: the quarter
/// circle of three poles gives the full circle, and the diagonal of an octant of sphere the whole
/// curve of Viviani, where the window `[−k, 1+k]` of the book gives half of it (book 311).
///
/// Errors: `Shape` when there is no such axis.
pub fn whole_line<S: Scalar>(form: &Form<S>, axis: usize) -> Result<Vec<Form<S>>> {
    form.require_axis(axis)?;
    let [zero, one] = [[S::one(), S::zero()], [S::zero(), S::one()]];
    let [below, above] = [[S::one(), -S::one()], [-S::one(), S::one()]];
    Ok(vec![
        on_window(form, axis, &below, &zero)?,
        form.clone(),
        on_window(form, axis, &one, &above)?,
    ])
}

/// The form between two homogeneous parameters `[s, t]`, each standing for `t / (s + t)`.
fn on_window<S: Scalar>(
    form: &Form<S>,
    axis: usize,
    from: &[S; 2],
    to: &[S; 2],
) -> Result<Form<S>> {
    let degree = form.orders()[axis] - 1;
    let rows: Vec<Vec<S>> = (0..=degree)
        .map(|i| {
            let mut arguments = vec![from.clone(); degree - i];
            arguments.resize(degree, to.clone());
            projective_blossom_row(&arguments)
        })
        .collect();
    form.along(axis, &Matrix::from_rows(rows)?)
}
