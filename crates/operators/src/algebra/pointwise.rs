//! Combinations and products of the points of forms, not of their poles.
//!
//! Where weights differ, `Σ kᵢ·fᵢ` on homogeneous poles is not `Σ kᵢ·pᵢ` of the points: a heavier form
//! counts more. The sum of the points is a form too, over the product of the weights:
//!
//! `Σ kᵢ·xᵢ/wᵢ = (Σ kᵢ·xᵢ·Π_{j≠i} wⱼ) / Π wⱼ`
//!
//! Orders add, but only for weights that differ: polynomial forms have none, and forms whose weights
//! are proportional share theirs.

use pforms_kernel::{Error, Form, Result, Scalar, Scaled};

use super::combine::{require_coefficients, spread};
use super::transform::one_if;
use super::{Spline, combine, raise_together};

/// `Σ kᵢ·pᵢ(t)` of the euclidean points, exactly.
///
/// A form of directions (all weights 0) adds its vectors. Degrees: the largest of the polynomial
/// forms, plus that of each weight function that differs from the others by more than a factor. In
/// `f64` each product of degree `n` costs some `n` roundings.
///
/// Errors: `Shape` when the counts, the axes or the spaces differ; `Domain` when a `k` is not finite;
/// `Limit`. Book 33; catalogue 4.
///
/// ```
/// use pforms_kernel::Form;
/// let heavy: Form = Form::from_points(&[], 1, &[0.], Some(&[3.]))?;
/// let light = Form::from_points(&[], 1, &[4.], None)?;
/// let half = [0.5, 0.5];
/// assert_eq!(pforms_operators::combine(&half, &[&heavy, &light])?.points()?, [1.]);
/// assert_eq!(pforms_operators::combine_pointwise(&half, &[&heavy, &light])?.points()?, [2.]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn combine_pointwise<S: Scalar>(k: &[S], forms: &[&Form<S>]) -> Result<Form<S>> {
    require_coefficients(k, forms.len())?;
    let forms = spread(forms)?;
    raise_together(&forms.iter().collect::<Vec<_>>())?;
    let plan = Plan::of(&forms);
    plan.sum(k, &forms)
}

/// Multiplications that [`combine_pointwise`] takes, more or less: a forecast.
pub fn pointwise_work<S: Scalar>(forms: &[&Form<S>]) -> f64 {
    let Ok(forms) = spread(forms) else { return 0.0 };
    let axes = forms.iter().map(Form::axes).min().unwrap_or(0);
    let plan = Plan::of(&forms);
    let degree = |index: usize, axis: usize| (forms[index].orders()[axis] - 1) as f64;
    let order = |axis: usize| {
        let weights: f64 = plan.owners.iter().map(|&owner| degree(owner, axis)).sum();
        weights + (0..forms.len()).map(|index| degree(index, axis)).fold(0.0, f64::max) + 1.0
    };
    let result: f64 = (0..axes).map(order).product();
    let numbers = forms.iter().map(|form| form.homogeneous().len());
    let (all, widest) = (numbers.clone().sum::<usize>(), numbers.max().unwrap_or(0));
    all as f64 + result * widest as f64 * (plan.owners.len() as f64).powi(2)
}

/// [`combine_pointwise`] of splines, piece by piece on their common knots.
///
/// Errors: as [`combine_pointwise`]; `Shape` when the windows differ.
pub(super) fn combine_spline_points<S: Scalar>(
    k: &[S],
    splines: &[Spline<S>],
) -> Result<Spline<S>> {
    require_coefficients(k, splines.len())?;
    let common = Spline::on_common_knots(splines)?;
    let nets: Vec<Form<S>> = common.iter().map(|spline| spline.net().clone()).collect();
    let plan = Plan::of(&nets);
    let ambient = nets[0].ambient();
    let together = Spline::on(side_by_side(&nets)?, common[0].knots().to_vec())?;
    together.map_pieces(|piece, _| plan.sum(k, &apart(piece, ambient)?))
}

/// One form whose poles are those of all, side by side.
fn side_by_side<S: Scalar>(forms: &[Form<S>]) -> Result<Form<S>> {
    let width = forms[0].width();
    let all = (0..forms[0].pole_count()).flat_map(|index| {
        forms.iter().flat_map(move |form| &form.homogeneous()[index * width..][..width])
    });
    Form::from_homogeneous(forms[0].orders(), width * forms.len() - 1, all.cloned().collect())
}

/// The forms that [`side_by_side`] put together.
fn apart<S: Scalar>(form: &Form<S>, ambient: usize) -> Result<Vec<Form<S>>> {
    let width = ambient + 1;
    let poles = form.homogeneous();
    let one = |part: usize| {
        let own = poles.chunks_exact(form.width()).flat_map(|pole| &pole[part * width..][..width]);
        Form::from_homogeneous(form.orders(), ambient, own.cloned().collect())
    };
    (0..form.width() / width).map(one).collect()
}

/// What each form is divided by.
struct Plan<S> {
    shares: Vec<Share<S>>,
    /// A form that has each of the weight functions.
    owners: Vec<usize>,
    /// Is there a form of points, not of directions?
    points: bool,
}

/// The points of a form are `factor` times its coordinates, over a weight function if there is one.
struct Share<S> {
    factor: S,
    weight: Option<usize>,
}

impl<S: Scalar> Plan<S> {
    fn of(forms: &[Form<S>]) -> Self {
        let mut owners: Vec<usize> = Vec::new();
        let mut points = false;
        let mut shares = Vec::with_capacity(forms.len());
        for (index, form) in forms.iter().enumerate() {
            let uniform = form.uniform_weight();
            points |= uniform.is_none_or(|weight| !weight.is_zero());
            shares.push(match uniform {
                Some(weight) if weight.is_zero() => Share { factor: S::one(), weight: None },
                Some(weight) => Share { factor: S::one() / weight.clone(), weight: None },
                None => {
                    let known = owners.iter().enumerate().find_map(|(place, &owner)| {
                        Some((place, proportion(&forms[owner], form)?))
                    });
                    let (place, factor) = known.unwrap_or((owners.len(), S::one()));
                    if place == owners.len() {
                        owners.push(index);
                    }
                    Share { factor, weight: Some(place) }
                }
            });
        }
        Self { shares, owners, points }
    }

    fn sum(&self, k: &[S], forms: &[Form<S>]) -> Result<Form<S>> {
        if self.owners.is_empty() {
            return self.sum_of_polynomials(k, forms);
        }
        let weight_of = |&owner: &usize| {
            let form: &Form<S> = &forms[owner];
            Scaled::from_form(form).component(form.ambient())
        };
        let weights: Vec<Scaled<S>> = self.owners.iter().map(weight_of).collect();
        let polynomial = self.part(None, k, forms)?;
        let mut total = polynomial
            .map(|sum| weights.iter().try_fold(sum, |sum, w| sum.times(w)))
            .transpose()?;
        for place in 0..weights.len() {
            let others = weights.iter().enumerate().filter(|(other, _)| *other != place);
            let part = self.part(Some(place), k, forms)?;
            let part =
                part.map(|part| others.into_iter().try_fold(part, |sum, (_, w)| sum.times(w)));
            total = sum_of(total, part.transpose()?)?;
        }
        let Some(total) = total else { return self.sum_of_polynomials(k, forms) };
        let one = Scaled::constant(forms[0].axes(), &[S::one()]);
        let weight = weights.iter().try_fold(one, |product, weight| product.times(weight))?;
        total.beside(&weight.raised_to(total.degrees())?).into_form()
    }

    /// Weights that are constant divide the coefficients.
    fn sum_of_polynomials(&self, k: &[S], forms: &[Form<S>]) -> Result<Form<S>> {
        let shares = self.shares.iter().zip(k);
        let k: Vec<S> = shares.map(|(share, k)| k.clone() * share.factor.clone()).collect();
        let sum = combine(&k, &forms.iter().collect::<Vec<_>>())?;
        Ok(sum.with_uniform_weight(&one_if(self.points)))
    }

    /// `Σ k·factor·coordinates` over the forms with this weight function, without its denominator.
    fn part(&self, weight: Option<usize>, k: &[S], forms: &[Form<S>]) -> Result<Option<Scaled<S>>> {
        let mut sum: Option<Scaled<S>> = None;
        for ((share, k), form) in self.shares.iter().zip(k).zip(forms) {
            if share.weight != weight {
                continue;
            }
            let coordinates = Scaled::from_form(form).truncated(form.ambient());
            let mut term = Scaled::zero(coordinates.degrees(), form.ambient())?;
            term.add_multiple(&(k.clone() * share.factor.clone()), &coordinates);
            sum = sum_of(sum, Some(term))?;
        }
        Ok(sum)
    }
}

/// `a + b`, the lower degrees raised.
fn sum_of<S: Scalar>(a: Option<Scaled<S>>, b: Option<Scaled<S>>) -> Result<Option<Scaled<S>>> {
    let (a, b) = match (a, b) {
        (Some(a), Some(b)) => (a, b),
        (one, other) => return Ok(one.or(other)),
    };
    let degrees: Vec<usize> = a.degrees().iter().zip(b.degrees()).map(|(a, b)| *a.max(b)).collect();
    let (mut sum, other) = (a.raised_to(&degrees)?, b.raised_to(&degrees)?);
    sum.add_multiple(&S::one(), &other);
    Ok(Some(sum))
}

/// `a / b`, if the weights of two forms of the same orders have one ratio.
fn proportion<S: Scalar>(a: &Form<S>, b: &Form<S>) -> Option<S> {
    if a.orders() != b.orders() {
        return None;
    }
    let (a, b) = (a.weights(), b.weights());
    let first = b.iter().position(|weight| !weight.is_zero())?;
    let (top, under) = (a[first].clone(), b[first].clone());
    let same = |(x, y): (&S, &S)| x.clone() * under.clone() == y.clone() * top.clone();
    (!top.is_zero() && a.iter().zip(&b).all(same)).then(|| top / under)
}

/// `f(t)·g(t)`, of which one is a function: a form in one dimension. Orders add.
///
/// Exact: coordinates and weights are multiplied. A point counts the same everywhere.
///
/// Errors: `Shape` unless one of the two lies in one dimension, and when the axes differ; `Limit`.
///
/// ```
/// use pforms_kernel::Form;
/// let ramp: Form = Form::from_points(&[2], 1, &[0., 1.], None)?;
/// let segment = Form::from_points(&[2], 2, &[1., 0., 1., 4.], None)?;
/// let spiral = pforms_operators::multiply(&ramp, &segment)?;
/// assert_eq!(spiral.at(&[0.5])?, [0.5, 1.]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn multiply<S: Scalar>(f: &Form<S>, g: &Form<S>) -> Result<Form<S>> {
    let forms = spread(&[f, g])?;
    let (function, form) = match (forms[0].ambient(), forms[1].ambient()) {
        (1, _) => (&forms[0], &forms[1]),
        (_, 1) => (&forms[1], &forms[0]),
        (c, d) => {
            let expected = "at least one form in 1D: a function";
            return Err(Error::shape("factors", format!("forms in {c}D and {d}D"), expected));
        }
    };
    let (factor, scaled) = (Scaled::from_form(function), Scaled::from_form(form));
    let points = scaled.truncated(form.ambient()).times(&factor.component(0))?;
    let weights = scaled.component(form.ambient()).times(&factor.component(1))?;
    let product = points.beside(&weights).into_form()?;
    Ok(match (function.uniform_weight(), form.uniform_weight()) {
        (Some(a), Some(b)) => product.with_uniform_weight(&(a.clone() * b.clone())),
        _ => product,
    })
}
