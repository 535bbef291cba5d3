//! Minors of the homogeneous Jacobian: what volumes, areas and fluxes are made of.
//!
//! For a form `f = X/W` with parameters `u₁ … u_d` the `(d+1)`-rowed determinants of the matrix with
//! rows `(X, W)`, `∂₁(X, W)` … `∂_d(X, W)` are polynomials. Those with the column `W` are
//! `W^(d+1)·(∂₁f ∧ … ∧ ∂_d f)`, the element of length, area or volume; the one of the columns `X`, where
//! there are `d + 1` of them, is `W^(d+1)·det(f, ∂₁f, …)`, the element of a flux.
//!
//! Along an axis of degree `n` each is of degree `(d+1)·n − 2`: by Euler's theorem the rows `(X, W)` and
//! `∂(X, W)` may be replaced by two of degree `n − 1`, so the highest term cancels.

use pforms_kernel::{Error, Form, Result, Scalar, Scaled};

/// Polynomials over one denominator, all exact.
#[derive(Clone, Debug)]
pub(crate) struct Minors<S> {
    /// The numerators side by side; a single column of zeros where the form has an axis of order 1.
    pub numerators: Scaled<S>,
    /// The power of the weight below them; 0 where all weights are equal.
    pub power: usize,
}

/// The components of `∂₁f ∧ … ∧ ∂_d f`: the choices of `d` coordinates in lexicographic order.
///
/// Errors: `Shape` with more axes than coordinates; `Degenerate` at infinity; `Limit`.
pub(crate) fn tangent_minors<S: Scalar>(form: &Form<S>) -> Result<Minors<S>> {
    let (axes, ambient) = (form.axes(), form.ambient());
    if axes > ambient {
        return Err(Error::shape(
            "form",
            format!("a {} in dimension {ambient}", form.kind()),
            format!("a space of dimension {axes} at least"),
        ));
    }
    let choices = choices(ambient, axes);
    if let Some(weight) = form.uniform_weight() {
        let rows = slopes(&unweighted(form, weight)?);
        return Minors::of(form, &rows, &choices, 0);
    }
    let with_weight = |mut choice: Vec<usize>| {
        choice.push(ambient);
        choice
    };
    let columns: Vec<Vec<usize>> = choices.into_iter().map(with_weight).collect();
    let all = Scaled::from_form(form);
    // The weight stands last in the columns, so its row is put last as well: the signs agree.
    let rows = [slopes(&all), vec![all]].concat();
    Minors::of(form, &rows, &columns, axes + 1)?.reduced(form)
}

/// `det(f, ∂₁f, …, ∂_d f)` of a form with one axis fewer than coordinates.
///
/// Errors: `Shape` with another number of axes; `Degenerate` at infinity; `Limit`.
pub(crate) fn flux_minor<S: Scalar>(form: &Form<S>) -> Result<Minors<S>> {
    let (axes, ambient) = (form.axes(), form.ambient());
    if axes + 1 != ambient {
        return Err(Error::shape(
            "form",
            format!("a {} in dimension {ambient}", form.kind()),
            format!("{} axes, one fewer than coordinates", ambient.saturating_sub(1)),
        ));
    }
    let uniform = form.uniform_weight();
    let all = match uniform {
        Some(weight) => unweighted(form, weight)?,
        None => Scaled::from_form(form),
    };
    let rows = [vec![all.clone()], slopes(&all)].concat();
    let power = if uniform.is_some() { 0 } else { axes + 1 };
    Minors::of(form, &rows, &[(0..ambient).collect()], power)?.reduced(form)
}

impl<S: Scalar> Minors<S> {
    fn of(
        form: &Form<S>,
        rows: &[Scaled<S>],
        choices: &[Vec<usize>],
        power: usize,
    ) -> Result<Self> {
        if form.orders().contains(&1) {
            let zeros = vec![S::zero(); choices.len()];
            return Ok(Self { numerators: Scaled::constant(form.axes(), &zeros), power });
        }
        let mut numerators: Option<Scaled<S>> = None;
        for choice in choices {
            let minor = determinant(rows, choice)?;
            numerators = Some(match numerators {
                None => minor,
                Some(before) => before.beside(&minor),
            });
        }
        let numerators = numerators.unwrap_or(Scaled::one(&vec![0; form.axes()])?);
        Ok(Self { numerators, power })
    }

    /// Takes one off each degree: the highest term is known to vanish.
    fn reduced(mut self, form: &Form<S>) -> Result<Self> {
        if !form.orders().contains(&1) {
            for axis in 0..form.axes() {
                self.numerators = lowered(&self.numerators, axis)?;
            }
        }
        Ok(self)
    }

    /// The numerators as the coordinates of a form, over its poles as they are: weights 1.
    ///
    /// Errors: `Domain` when a number overflowed.
    pub(crate) fn into_vectors(self) -> Result<Form<S>> {
        let one = Scaled::one(self.numerators.degrees())?;
        self.numerators.beside(&one).into_form()
    }
}

/// Choices of `count` numbers below `of`, each in order, lexicographic.
fn choices(of: usize, count: usize) -> Vec<Vec<usize>> {
    let mut all = vec![Vec::new()];
    for place in 0..count {
        let longer = |choice: &Vec<usize>| {
            let first = choice.last().map_or(0, |last| last + 1);
            let choice = choice.clone();
            (first..=of + place - count).map(move |next| [choice.clone(), vec![next]].concat())
        };
        all = all.iter().flat_map(longer).collect();
    }
    all
}

/// The coordinates over the weight that all poles have.
fn unweighted<S: Scalar>(form: &Form<S>, weight: &S) -> Result<Scaled<S>> {
    if weight.is_zero() {
        return Err(Error::degenerate("form", "a form at infinity", "a weight that is not 0"));
    }
    let all = Scaled::from_form(form).truncated(form.ambient());
    if *weight == S::one() {
        return Ok(all);
    }
    all.times(&Scaled::constant(form.axes(), &[S::one() / weight.clone()]))
}

fn slopes<S: Scalar>(all: &Scaled<S>) -> Vec<Scaled<S>> {
    (0..all.degrees().len()).map(|axis| all.derivative(axis)).collect()
}

/// The determinant of these columns of the rows, along the last row.
fn determinant<S: Scalar>(rows: &[Scaled<S>], columns: &[usize]) -> Result<Scaled<S>> {
    let Some((last, others)) = rows.split_last() else {
        return Scaled::one(&[]);
    };
    if others.is_empty() {
        return Ok(last.component(columns[0]));
    }
    let mut sum: Option<Scaled<S>> = None;
    for (place, &column) in columns.iter().enumerate() {
        let rest: Vec<usize> = columns.iter().copied().filter(|other| *other != column).collect();
        let term = determinant(others, &rest)?.times(&last.component(column))?;
        let sign = if (columns.len() - place).is_multiple_of(2) { -S::one() } else { S::one() };
        let sum = sum.get_or_insert(Scaled::zero(term.degrees(), 1)?);
        sum.add_multiple(&sign, &term);
    }
    sum.map_or_else(|| Scaled::one(&[]), Ok)
}

/// The same polynomial with one degree less along an axis along which its highest term vanishes.
///
/// In the scaled basis raising is `c_i = b_i + b_{i−1}`; it is undone from both ends to the middle,
/// where the coefficients grow, so that roundings stay relatively small.
fn lowered<S: Scalar>(polynomial: &Scaled<S>, axis: usize) -> Result<Scaled<S>> {
    let mut degrees = polynomial.degrees().to_vec();
    let degree = degrees[axis];
    degrees[axis] = degree - 1;
    let width = polynomial.width();
    let inner: usize = degrees[axis + 1..].iter().map(|d| d + 1).product::<usize>() * width;
    let mut low: Scaled<S> = Scaled::zero(&degrees, width)?;
    let blocks = polynomial.coefficients().chunks_exact(inner * (degree + 1));
    for (source, target) in blocks.zip(low.coefficients_mut().chunks_exact_mut(inner * degree)) {
        let middle = degree.div_ceil(2);
        for i in 0..middle {
            for k in i * inner..(i + 1) * inner {
                let before = if i == 0 { S::zero() } else { target[k - inner].clone() };
                target[k] = source[k].clone() - before;
            }
        }
        for i in (middle..degree).rev() {
            for k in i * inner..(i + 1) * inner {
                let after = if i + 1 == degree { S::zero() } else { target[k + inner].clone() };
                target[k] = source[k + inner].clone() - after;
            }
        }
    }
    Ok(low)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn choices_in_order() {
        assert_eq!(choices(3, 2), [[0, 1], [0, 2], [1, 2]]);
        assert_eq!(choices(4, 4), [[0, 1, 2, 3]]);
        assert_eq!(choices(2, 0), [Vec::<usize>::new()]);
    }
}
