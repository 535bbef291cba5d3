//! One cell: a part of a piece on which the length of the normals is one polynomial.

use pforms_kernel::{Form, Result, Scalar, Scaled};

use super::distance::Quotient;
use super::{Field, function};
use crate::measuring::guarded::Guarded;
use crate::measuring::vector::norm;
use crate::{Nodes, interpolate, raise_to, stretch, subdivide};

/// A part of a piece, its normals, and a polynomial near their length.
pub(super) struct Cell {
    pub piece: Form,
    pub local: Form<Guarded>,
    pub normal: Form,
    /// In one component.
    pub length: Scaled,
    /// Bound on `||N|/s − 1|`; infinite where `s` is not proved positive.
    pub error: f64,
}

/// Each cell is halved so often along each axis before coefficients are read as bounds.
const HALVINGS: u32 = 2;

impl Cell {
    /// The part of a piece from `a` to `b`, with a length of these orders.
    pub(super) fn new(field: &Field, a: &[f64], b: &[f64], orders: &[usize]) -> Result<Self> {
        let normal = stretch(&field.normal, a, b)?;
        let length = length(&normal, orders)?;
        let error = relative_error(&normal, &length)?;
        let guarded = |list: &[f64]| list.iter().map(|t| Guarded::from(*t)).collect::<Vec<_>>();
        let local = stretch(&field.local, &guarded(a), &guarded(b))?;
        let piece = stretch(&field.piece, a, b)?;
        Ok(Self { piece, local, normal, length: Scaled::from_form(&length).component(0), error })
    }

    /// The part of the original, over the denominators of the parallel.
    pub(super) fn raised(&self, distance: &Quotient) -> Result<Form> {
        let below = self.length.times(&distance.below)?;
        let (point, weight) = (self.point().times(&below)?, self.weight().times(&below)?);
        self.gathered(&point, &weight, distance)
    }

    /// `f + d·N/s`.
    pub(super) fn moved(&self, distance: &Quotient) -> Result<Form> {
        let below = self.length.times(&distance.below)?;
        let (point, weight) = (self.point().times(&below)?, self.weight().times(&below)?);
        let normal = Scaled::from_form(&self.normal).truncated(self.normal.ambient());
        let step = normal.times(&self.weight())?.times(&distance.above)?;
        let degrees = most(point.degrees(), step.degrees());
        let mut point = point.raised_to(&degrees)?;
        point.add_multiple(&1.0, &step.raised_to(&degrees)?);
        self.gathered(&point, &weight, distance)
    }

    /// Point and weight in one form, of the degrees that both parallel and original fit in.
    fn gathered(&self, point: &Scaled, weight: &Scaled, distance: &Quotient) -> Result<Form> {
        let (normal, own) = (self.normal.degrees(), self.weight());
        let step = normal.iter().zip(own.degrees()).zip(distance.above.degrees());
        let step: Vec<usize> = step.map(|((n, w), d)| n + w + d).collect();
        let degrees = most(&most(point.degrees(), weight.degrees()), &step);
        let form = point.raised_to(&degrees)?.beside(&weight.raised_to(&degrees)?).into_form()?;
        // A constant stays one to the bit.
        Ok(match weight.coefficients() {
            [constant] => form.with_uniform_weight(constant),
            _ => form,
        })
    }

    fn point(&self) -> Scaled {
        Scaled::from_form(&self.piece).truncated(self.piece.ambient())
    }

    /// The weight of the piece.
    pub(super) fn weight(&self) -> Scaled {
        weight(&self.piece)
    }
}

/// The weight of a form, of degree 0 when it is the same everywhere.
pub(super) fn weight<S: Scalar>(form: &Form<S>) -> Scaled<S> {
    match form.uniform_weight() {
        Some(weight) => Scaled::constant(form.axes(), std::slice::from_ref(weight)),
        None => Scaled::from_form(form).component(form.ambient()),
    }
}

fn most(a: &[usize], b: &[usize]) -> Vec<usize> {
    a.iter().zip(b).map(|(a, b)| *a.max(b)).collect()
}

/// The polynomial of these orders that meets `|N|` at Lobatto's nodes.
fn length(normal: &Form, orders: &[usize]) -> Result<Form> {
    let nodes = orders.iter().enumerate().map(|(axis, &order)| Nodes::Lobatto.on_axis(axis, order));
    let nodes: Vec<Vec<f64>> = nodes.collect::<Result<_>>()?;
    let lists: Vec<&[f64]> = nodes.iter().map(Vec::as_slice).collect();
    let vectors = normal.grid(&lists)?;
    let values = vectors.chunks_exact(normal.ambient()).map(norm);
    interpolate(&function(&values.collect::<Vec<_>>(), orders)?, &Nodes::Lobatto)
}

/// At most `||N|² − s²| / s(s + |N|)`, part by part.
fn relative_error(normal: &Form, length: &Form) -> Result<f64> {
    let squares = squares(normal, length)?;
    let levels = vec![HALVINGS; normal.axes()];
    let (differences, lengths) = (subdivide(&squares, &levels)?, subdivide(length, &levels)?);
    let mut worst = 0.0_f64;
    for (difference, length) in differences.pieces()?.iter().zip(&lengths.pieces()?) {
        let least = length.points()?.into_iter().fold(f64::INFINITY, f64::min);
        let most = difference.points()?.into_iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        if least <= 0.0 {
            return Ok(f64::INFINITY);
        }
        let other = (least * least - most).max(0.0).sqrt();
        worst = worst.max(most / (least * (least + other)));
    }
    Ok(worst)
}

/// `|N|² − s²`, as a function.
fn squares(normal: &Form, length: &Form) -> Result<Form> {
    let degrees = most(&normal.degrees(), &length.degrees());
    let orders: Vec<usize> = degrees.iter().map(|degree| degree + 1).collect();
    let length = Scaled::from_form(&raise_to(length, &orders)?).component(0);
    valued(&square_of(&raise_to(normal, &orders)?)?.minus(&length.times(&length)?))
}

/// `|N|²`, as a function.
pub(super) fn square(normal: &Form) -> Result<Form> {
    valued(&square_of(normal)?)
}

fn square_of(normal: &Form) -> Result<Scaled> {
    let normal = Scaled::from_form(normal);
    let doubled: Vec<usize> = normal.degrees().iter().map(|degree| 2 * degree).collect();
    let mut sum = Scaled::zero(&doubled, 1)?;
    for k in 0..normal.width() - 1 {
        let x = normal.component(k);
        sum.add_product(&x, &x);
    }
    Ok(sum)
}

fn valued(polynomial: &Scaled) -> Result<Form> {
    let one = Scaled::one(polynomial.degrees())?;
    polynomial.beside(&one).into_form()
}
