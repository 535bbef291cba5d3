//! Reduction: the best form with fewer poles, and how far it is at most.
//!
//! The best polynomial of degree `n − 1` in the mean square over `[0, 1]` is also the one whose
//! poles, raised again, are nearest to the given ones in the euclidean norm (Lutterkort, Peters,
//! Reif, *Polynomial degree reduction in the L₂-norm equals best Euclidean approximation of Bézier
//! coefficients*, 1999). So one step removes from the poles their part along `(−1)^i·C(n, i)`, the
//! only direction that raising cannot reach, and lowers what is left exactly.

use pforms_kernel::{Error, Form, Matrix, Result, Scalar, pascal_row};

use super::{elevate, subdivide};

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
/// Errors: `Shape` when an order would fall below 1; `Degenerate` when the weight of the form or of
/// its reduction vanishes in the window, since then no distance can be promised.
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

/// `|X/W − Y/V| ≤ (max|Xᵢ − Yᵢ| + max|y|·max|Wᵢ − Vᵢ|) / min|W|`, all over the hull of the poles,
/// where `y = Y/V` is a point of the reduced form.
///
/// Numerator and denominator are homogeneous: scaling all poles and weights changes nothing.
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
    let (rounding, largest) = (rounding_of(form), largest_coordinates(reduced));
    shift += rounding * largest;
    if form.is_rational() {
        weight_shift += rounding * largest_weight(reduced);
    }
    if shift == 0.0 && weight_shift == 0.0 {
        return Ok(0.0);
    }
    let reach = largest / least_weight(reduced)?;
    Ok((shift + reach * weight_shift) / least_weight(form)? * (1.0 + 8.0 * f64::EPSILON))
}

/// What the rounding of the raised poles can hide, of the largest pole: nothing in exact arithmetic.
fn rounding_of<S: Scalar>(form: &Form<S>) -> f64 {
    if S::EXACT {
        return 0.0;
    }
    let steps: usize = form.orders().iter().map(|order| 8 * order).sum();
    f64::EPSILON * steps as f64
}

fn largest_coordinates<S: Scalar>(form: &Form<S>) -> f64 {
    let poles = form.homogeneous().chunks_exact(form.width());
    let lengths = poles.map(|pole| {
        let coordinates: Vec<f64> = pole[..form.ambient()].iter().map(S::to_f64).collect();
        norm(&coordinates)
    });
    lengths.fold(0.0, f64::max)
}

fn largest_weight<S: Scalar>(form: &Form<S>) -> f64 {
    form.weights().iter().map(|weight| weight.to_f64().abs()).fold(0.0, f64::max)
}

/// How often the weight is halved in search of a bound away from 0, and the poles this may make.
const HALVINGS: u32 = 6;
const MOST_POLES: usize = 1 << 18;

/// A number above 0 that the weight nowhere in the window falls below in absolute value.
///
/// The least of its poles will do when all have one sign; else those of its parts.
fn least_weight<S: Scalar>(form: &Form<S>) -> Result<f64> {
    let weights: Vec<f64> = form.weights().iter().map(S::to_f64).collect();
    let slack = f64::EPSILON * largest_weight(form) * rounding_steps(form);
    let weight = Form::from_points(form.orders(), 1, &weights, None)?;
    for halvings in 0..=HALVINGS {
        let parts = 1_usize.checked_shl(halvings * form.axes() as u32).unwrap_or(usize::MAX);
        if parts.saturating_mul(weights.len()) > MOST_POLES {
            break;
        }
        let net = subdivide(&weight, &vec![halvings; form.axes()])?;
        let poles = net.net().homogeneous().chunks_exact(2).map(|pole| pole[0]);
        let (low, high) = poles
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), w| (low.min(w), high.max(w)));
        let least = low.max(-high);
        if halvings == 0 && least > 0.0 {
            return Ok(least);
        }
        if least > slack {
            return Ok(least - slack);
        }
    }
    Err(Error::degenerate(
        "form",
        "a weight that vanishes in the window, or nearly",
        "a weight without a zero there: across it no distance can be promised",
    ))
}

/// Roundings that a pole of a part may have seen, with room to spare.
fn rounding_steps<S: Scalar>(form: &Form<S>) -> f64 {
    let degrees: usize = form.orders().iter().sum();
    (HALVINGS as usize * degrees) as f64
}

/// The length of a vector, whatever its scale.
fn norm(vector: &[f64]) -> f64 {
    let largest = vector.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    if largest == 0.0 || !largest.is_finite() {
        return largest;
    }
    largest * vector.iter().map(|x| (x / largest).powi(2)).sum::<f64>().sqrt()
}
