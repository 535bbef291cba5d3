//! Matrices whose columns are forms: what an affine sweep is usually told.

use pforms_kernel::{Error, Form, Result, Scalar, Scaled};

/// The form of matrices whose columns are vectors and, last, an origin: applied to the point
/// `(s₁, …, s_m)` it gives `origin(u) + Σ s_k·vector_k(u)`.
///
/// The vectors are the euclidean values of their forms, as `tangent_form`, `normal_form` and
/// `binormal_form` give them (a form of directions, all weights 0, is taken as it stands). So an
/// unnormalised frame along a path is `affine_matrix(&[&normal, &binormal, &tangent, &path])`, with
/// no root in it. A column without axes is the same everywhere. Degrees are raised to the largest; rational columns are brought to the product of
/// their different weights, to which degrees add. Exact. The matrices have one row more than there
/// are coordinates, the last `0 … 0 w`, and are laid out as [`affine_sweep`](super::affine_sweep)
/// takes them.
///
/// Errors: `Shape` without a column, or when they differ in axes (points aside) or space; `Domain` for an origin
/// of directions and when a number overflows; `Limit`.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{affine_matrix, affine_sweep};
/// let along: Form = Form::from_points(&[2], 2, &[1., 0., 2., 1.], None)?; // a vector that turns
/// let path = Form::from_points(&[2], 2, &[0., 0., 0., 3.], None)?;
/// let matrix = affine_matrix(&[&along, &path])?; // 3×2: a number becomes a point of the plane
/// let ruled = affine_sweep(&matrix, &Form::from_points(&[2], 1, &[-1., 1.], None)?)?;
/// assert_eq!(ruled.points()?, [-1., 0., 1., 0., -2., 2., 2., 4.]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn affine_matrix<S: Scalar>(columns: &[&Form<S>]) -> Result<Form<S>> {
    let columns = spread(columns)?;
    let (Some(first), Some(origin)) = (columns.first(), columns.last()) else {
        return Err(none());
    };
    if is_directions(origin) {
        return Err(Error::domain("columns", "directions as origin", "points last"));
    }
    let parts: Vec<Column<S>> = columns.iter().map(Column::of).collect::<Result<_>>()?;
    let mut weights: Vec<Scaled<S>> = Vec::new();
    for part in &parts {
        if let Some(weight) = part.weight.as_ref().filter(|weight| !weights.contains(weight)) {
            weights.push(weight.clone());
        }
    }
    let one = Scaled::constant(first.axes(), &[S::one()]);
    let whole = weights.iter().try_fold(one, |product, weight| product.times(weight))?;
    let shared: Vec<Scaled<S>> =
        parts.iter().map(|part| part.over(&weights)).collect::<Result<_>>()?;
    assembled(&shared, &whole, first.ambient())
}

/// The columns with the same axes, those without any spread over them.
fn spread<S: Scalar>(columns: &[&Form<S>]) -> Result<Vec<Form<S>>> {
    let Some(widest) = columns.iter().max_by_key(|form| form.axes()) else {
        return Err(none());
    };
    let fits = |form: &Form<S>| {
        form.ambient() == widest.ambient() && [0, widest.axes()].contains(&form.axes())
    };
    if let Some((index, form)) = columns.iter().enumerate().find(|(_, form)| !fits(form)) {
        return Err(Error::shape(
            "columns",
            format!("a {} in {}D as column {index}", form.kind(), form.ambient()),
            format!("a point or a form with {} axes in {}D", widest.axes(), widest.ambient()),
        ));
    }
    let same = |form: &&Form<S>| match form.axes() {
        0 => form.reshape(&vec![1; widest.axes()]),
        _ => Ok((*form).clone()),
    };
    columns.iter().map(same).collect()
}

fn none() -> Error {
    Error::shape("columns", "none", "vectors, and an origin last")
}

fn is_directions<S: Scalar>(form: &Form<S>) -> bool {
    form.uniform_weight().is_some_and(S::is_zero)
}

/// The coordinates of a column and the weight they are to be divided by, if it varies.
struct Column<S> {
    coordinates: Scaled<S>,
    weight: Option<Scaled<S>>,
}

impl<S: Scalar> Column<S> {
    fn of(form: &Form<S>) -> Result<Self> {
        let all = Scaled::from_form(form);
        match form.uniform_weight() {
            None => Ok(Self {
                coordinates: all.truncated(form.ambient()),
                weight: Some(all.component(form.ambient())),
            }),
            Some(weight) if weight.is_zero() || *weight == S::one() => {
                Ok(Self { coordinates: all.truncated(form.ambient()), weight: None })
            }
            Some(weight) => {
                let inverse = Scaled::constant(form.axes(), &[S::one() / weight.clone()]);
                let coordinates = all.truncated(form.ambient()).times(&inverse)?;
                Ok(Self { coordinates, weight: None })
            }
        }
    }

    /// The coordinates over the product of all weights.
    fn over(&self, weights: &[Scaled<S>]) -> Result<Scaled<S>> {
        let others = weights.iter().filter(|weight| self.weight.as_ref() != Some(weight));
        others.into_iter().try_fold(self.coordinates.clone(), |all, weight| all.times(weight))
    }
}

/// Columns and the weight, raised to the same degrees and read row by row.
fn assembled<S: Scalar>(
    columns: &[Scaled<S>],
    weight: &Scaled<S>,
    ambient: usize,
) -> Result<Form<S>> {
    let mut degrees = weight.degrees().to_vec();
    for column in columns {
        for (most, degree) in degrees.iter_mut().zip(column.degrees()) {
            *most = (*most).max(*degree);
        }
    }
    let weight = weight.raised_to(&degrees)?;
    let columns: Vec<Scaled<S>> =
        columns.iter().map(|column| column.raised_to(&degrees)).collect::<Result<_>>()?;
    let rows = (0..ambient).flat_map(|i| columns.iter().map(move |column| column.component(i)));
    let zeros = columns[1..].iter().map(|_| weight.clone().minus(&weight));
    let mut entries = rows.chain(zeros).chain([weight.clone()]);
    let Some(first) = entries.next() else {
        return Err(none());
    };
    entries.fold(first, |all, entry| all.beside(&entry)).into_form()
}
