//! Reduction: the best form with fewer poles, and how far it is at most.
//!
//! The best polynomial of degree `n − 1` in the mean square over `[0, 1]` is also the one whose
//! poles, raised again, are nearest to the given ones in the euclidean norm (Lutterkort, Peters,
//! Reif, *Polynomial degree reduction in the L₂-norm equals best Euclidean approximation of Bézier
//! coefficients*, 1999). So one step removes from the poles their part along `(−1)^i·C(n, i)`, the
//! only direction that raising cannot reach, and lowers what is left exactly.

use pforms_kernel::{Error, Form, Matrix, Result, Scalar, pascal_row};

use super::elevate;

/// A form of lower orders and a bound on its distance from the original.
#[derive(Clone, Debug, PartialEq)]
pub struct Reduction<S = f64> {
    /// The reduced form.
    pub form: Form<S>,
    /// No point of the window `[0, 1]` moves by more than this.
    pub bound: f64,
}

/// The best form with `by[k]` fewer poles along each axis `k`, and a bound on the error.
///
/// Best in the mean square of the homogeneous coordinates; when the form is degenerate (a raised
/// one) the result is exact and in exact arithmetic the bound is 0. The bound follows from the
/// convex hull of the difference, so it is rigorous over the whole window; in `f64` it is widened
/// by the rounding of its own computation. End points may move, within the bound.
///
/// Errors: `Shape` when an order would fall below 1; `Degenerate` when weights of the form or its
/// reduction are not all of one sign, since then no distance can be promised.
///
/// ```
/// use pforms_kernel::Form;
/// let raised: Form = Form::from_points(&[4], 1, &[0., 2., 2., 0.], None)?;
/// let reduction = pforms_operators::reduce(&raised, &[1])?;
/// assert!((reduction.form.points()?[1] - 3.0).abs() < 1e-14);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn reduce<S: Scalar>(form: &Form<S>, by: &[usize]) -> Result<Reduction<S>> {
    form.require_per_axis("by", by)?;
    if by.iter().zip(form.orders()).any(|(less, order)| less >= order) {
        return Err(Error::shape(
            "by",
            format!("{by:?}"),
            format!("less than the orders {:?}", form.orders()),
        ));
    }
    let mut reduced = form.clone();
    for (axis, &less) in by.iter().enumerate() {
        for _ in 0..less {
            let degree = reduced.orders()[axis] - 1;
            reduced = reduced.along_affine(axis, &reduction_matrix(degree))?;
        }
    }
    let bound = distance_bound(form, &elevate(&reduced, by)?, &reduced)?;
    Ok(Reduction { form: reduced, bound })
}

/// The matrix of one step, from `degree + 1` poles to `degree`.
fn reduction_matrix<S: Scalar>(degree: usize) -> Matrix<S> {
    let direction: Vec<S> = pascal_row::<S>(degree)
        .into_iter()
        .enumerate()
        .map(|(i, c)| if i % 2 == 0 { c } else { -c })
        .collect();
    let mut square = S::zero();
    for d in &direction {
        square += d.clone() * d.clone();
    }
    let columns: Vec<Vec<S>> = (0..=degree)
        .map(|j| {
            let along = direction[j].clone() / square.clone();
            let residue = |i: usize| {
                let unit = if i == j { S::one() } else { S::zero() };
                unit - along.clone() * direction[i].clone()
            };
            lowered(&(0..=degree).map(residue).collect::<Vec<S>>())
        })
        .collect();
    Matrix::from_rule(degree, degree + 1, |i, j| columns[j][i].clone())
}

/// The poles of degree `n − 1` whose elevation is `raised`: the first half is read from the left,
/// the second from the right, where the recurrences do not amplify.
fn lowered<S: Scalar>(raised: &[S]) -> Vec<S> {
    let degree = raised.len() - 1;
    let mut poles = vec![S::zero(); degree];
    let whole = S::from_integer(degree as i64);
    let part = |k: usize| S::from_integer(k as i64);
    let middle = degree.div_ceil(2);
    let mut last = S::zero();
    for i in 0..middle {
        last = (whole.clone() * raised[i].clone() - part(i) * last) / part(degree - i);
        poles[i] = last.clone();
    }
    let mut next = S::zero();
    for i in (middle..degree).rev() {
        let rest = part(degree - i - 1) * next;
        next = (whole.clone() * raised[i + 1].clone() - rest) / part(i + 1);
        poles[i] = next.clone();
    }
    poles
}

/// `|X/W − Y/V| ≤ (max|Xᵢ − Yᵢ| + max|y|·max|Wᵢ − Vᵢ|) / min Wᵢ`, all over the hull of the poles,
/// where `y = Y/V` is a point of the reduced form.
fn distance_bound<S: Scalar>(form: &Form<S>, raised: &Form<S>, reduced: &Form<S>) -> Result<f64> {
    let ambient = form.ambient();
    let (mut shift, mut weight_shift) = (0.0_f64, 0.0_f64);
    let pairs = form.homogeneous().chunks_exact(ambient + 1);
    for (a, b) in pairs.zip(raised.homogeneous().chunks_exact(ambient + 1)) {
        let gaps: Vec<f64> =
            a.iter().zip(b).map(|(x, y)| (x.clone() - y.clone()).to_f64()).collect();
        shift = shift.max(norm(&gaps[..ambient]));
        weight_shift = weight_shift.max(gaps[ambient].abs());
    }
    let reach = largest_coordinates(reduced) / least_weight(reduced)?;
    let bound = (shift + reach * weight_shift) / least_weight(form)?;
    Ok(bound * (1.0 + 8.0 * f64::EPSILON) + rounding_of(form))
}

/// What the rounding of the raised poles can hide: nothing in exact arithmetic.
fn rounding_of<S: Scalar>(form: &Form<S>) -> f64 {
    if S::EXACT {
        return 0.0;
    }
    let steps: usize = form.orders().iter().map(|order| 8 * order).sum();
    f64::EPSILON * steps as f64 * largest_coordinates(form)
}

fn largest_coordinates<S: Scalar>(form: &Form<S>) -> f64 {
    let poles = form.homogeneous().chunks_exact(form.width());
    let lengths = poles.map(|pole| {
        let coordinates: Vec<f64> = pole[..form.ambient()].iter().map(S::to_f64).collect();
        norm(&coordinates)
    });
    lengths.fold(0.0, f64::max)
}

/// The smallest weight in absolute value, when all have one sign.
fn least_weight<S: Scalar>(form: &Form<S>) -> Result<f64> {
    let weights: Vec<f64> = form.weights().iter().map(S::to_f64).collect();
    let positive = weights.iter().all(|w| *w > 0.0);
    if positive || weights.iter().all(|w| *w < 0.0) {
        return Ok(weights.iter().fold(f64::INFINITY, |least, w| least.min(w.abs())));
    }
    Err(Error::degenerate(
        "form",
        format!("weights of both signs or 0: {weights:?}"),
        "weights of one sign, without which no distance can be promised",
    ))
}

fn norm(vector: &[f64]) -> f64 {
    vector.iter().map(|x| x * x).sum::<f64>().sqrt()
}
