//! The book's chains: each piece is found from the one before it, no system is solved (section 342).

use pforms_kernel::{Error, Form, Result, Scalar};

use crate::algebra::Spline;

/// Parabolas through points, one after another: piece `i` is `[b_i, 2·b_i − m, b_{i+1}]` with the
/// middle pole `m` of the piece before it; `before` stands for the first `m`.
///
/// In the homogeneous coordinates the pieces meet once continuously differentiable. The middle poles
/// swing about the points and what is wrong with `before` stays as large as it is. `factor`
/// multiplies the middle pole of each piece after the chain has been run: with `√½` and points at
/// right angles around a centre the parabolas become arcs of a circle. The window is `[0, 1]`. Exact.
///
/// Errors: `Shape` unless the points are a row of at least two and `before` is a homogeneous pole;
/// `Domain` when a number is not finite.
///
/// ```
/// use pforms_kernel::Form;
/// let points: Form =
///     Form::from_points(&[5], 2, &[1., 0., 0., 1., -1., 0., 0., -1., 1., 0.], None)?;
/// let circle = pforms_operators::quadratic_chain(&points, &[1., -1., 1.], &0.5_f64.sqrt())?;
/// let point = circle.at(&[0.3])?;
/// assert!((point[0].hypot(point[1]) - 1.0).abs() < 1e-15);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn quadratic_chain<S: Scalar>(points: &Form<S>, before: &[S], factor: &S) -> Result<Spline<S>> {
    let rows = rows(points, &[before])?;
    let mut middle = before.to_vec();
    let mut pieces = Vec::with_capacity(rows.len());
    for pair in rows.windows(2) {
        middle = sum(&[(2, pair[0]), (-1, &middle)]);
        let weighted: Vec<S> = middle.iter().map(|x| factor.clone() * x.clone()).collect();
        let poles = [pair[0], &weighted, pair[1]].concat();
        pieces.push(Form::from_homogeneous(&[3], points.ambient(), poles)?);
    }
    end_to_end(&pieces)
}

/// Cubics through points, one after another: piece `i` is `[b_i, 2·b_i − q, 4·b_i − 4·q + p, b_{i+1}]`
/// with the inner poles `p`, `q` of the piece before it; `before` stands for the first two.
///
/// The pieces meet twice continuously differentiable in the homogeneous coordinates. What is wrong
/// with the start, be it a rounding, grows by `2 + √3 = 3.73` from piece to piece: after 28 pieces
/// nothing of an `f64` is left. [`interpolating_spline`](super::interpolating_spline) gives the
/// smooth cubic that does not. The window is `[0, 1]`. Exact.
///
/// Errors: as [`quadratic_chain`]; `Domain` when the poles have run out of range.
///
/// ```
/// use pforms_kernel::Form;
/// let points: Form = Form::from_points(&[3], 1, &[0., 1., 8.], None)?; // t³ goes on as it began
/// let chain = pforms_operators::cubic_chain(&points, [&[0., 1.], &[0., 1.]])?;
/// assert_eq!(chain.at(&[0.75])?, [3.375]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn cubic_chain<S: Scalar>(points: &Form<S>, before: [&[S]; 2]) -> Result<Spline<S>> {
    let rows = rows(points, &before)?;
    let [mut p, mut q] = before.map(<[S]>::to_vec);
    let mut pieces = Vec::with_capacity(rows.len());
    for pair in rows.windows(2) {
        let first = sum(&[(2, pair[0]), (-1, &q)]);
        let second = sum(&[(4, pair[0]), (-4, &q), (1, &p)]);
        let poles = [pair[0], &first, &second, pair[1]].concat();
        pieces.push(Form::from_homogeneous(&[4], points.ambient(), poles)?);
        (p, q) = (first, second);
    }
    end_to_end(&pieces)
}

/// The homogeneous points, once all is there that a chain needs.
fn rows<'a, S: Scalar>(points: &'a Form<S>, before: &[&[S]]) -> Result<Vec<&'a [S]>> {
    if points.axes() != 1 || points.orders()[0] < 2 {
        return Err(Error::shape(
            "points",
            format!("a {}", points.kind()),
            "a row of at least two",
        ));
    }
    for pole in before {
        if pole.len() != points.width() {
            return Err(Error::shape(
                "start",
                format!("{} numbers", pole.len()),
                format!("{}, as the points have with their weight", points.width()),
            ));
        }
        if let Some(x) = pole.iter().find(|x| !x.is_finite()) {
            return Err(Error::domain("start", format!("{x:?}"), "finite numbers"));
        }
    }
    Ok(points.homogeneous().chunks_exact(points.width()).collect())
}

fn sum<S: Scalar>(terms: &[(i64, &[S])]) -> Vec<S> {
    let mut sum = vec![S::zero(); terms[0].1.len()];
    for (factor, line) in terms {
        S::add_multiple(&mut sum, &S::from_integer(*factor), line);
    }
    sum
}

fn end_to_end<S: Scalar>(pieces: &[Form<S>]) -> Result<Spline<S>> {
    let count = pieces.len() as i64;
    let breaks: Vec<S> = (0..=count).map(|i| S::ratio(i, count)).collect();
    Spline::end_to_end(pieces, 0, &breaks)
}
