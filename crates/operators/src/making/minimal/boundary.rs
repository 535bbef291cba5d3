//! The boundary that is kept, and the poles inside it.

use pforms_kernel::{Error, Form, Result, Scalar};

use super::MinimalOptions;
use super::energy::{is_inside, place};
use crate::algebra::{Shape, Spline, raise_to};
use crate::making::{CoonsOptions, coons, coons_splines};

/// A boundary with some form inside it.
#[derive(Clone)]
pub(super) struct Frame<S> {
    /// The Coons patch on the boundary, or the form that was given, all of its ends poles.
    pub spline: Spline<S>,
    /// Poles that are to be found, in ascending order.
    pub free: Vec<usize>,
    /// Is the answer a form, having one piece?
    pub is_form: bool,
}

impl<S: Scalar> Frame<S> {
    /// From the form whose border is kept, or from the faces of a Coons patch.
    pub(super) fn new(boundary: &[Shape<S>], options: &MinimalOptions<S>) -> Result<Self> {
        let is_form = boundary.iter().all(|shape| matches!(shape, Shape::Form(_)));
        let shape = match boundary {
            [single] => single.clone(),
            faces => spanned(faces, is_form)?,
        };
        let mut spline = shape.into_spline();
        if spline.axes() == 0 {
            return Err(Error::shape("boundary", "a point", "a form with axes, or faces of one"));
        }
        for axis in 0..spline.axes() {
            let (from, to) = spline.window(axis)?;
            let knots = &spline.knots()[axis];
            let ends = [&from, &to].map(|t| knots.multiplicity(t));
            if ends != [knots.degree() + 1; 2] {
                spline = spline.restrict(axis, &from, &to)?;
            }
        }
        spline = raised(spline, &options.orders)?;
        let free = free(spline.net().orders(), &options.keep)?;
        Ok(Self { spline, free, is_form })
    }

    /// The same boundary around other poles.
    pub(super) fn with(&self, net: Form<S>) -> Result<Shape<S>> {
        if self.is_form {
            return Ok(Shape::Form(net));
        }
        Ok(Shape::Spline(Spline::on(net, self.spline.knots().to_vec())?))
    }

    /// The lengths of the sides of the box of parameters.
    pub(super) fn sides(&self, given: &[S]) -> Result<Vec<S>> {
        if given.is_empty() {
            let length = |axis| self.spline.window(axis).map(|(from, to)| to - from);
            return (0..self.spline.axes()).map(length).collect();
        }
        self.spline.net().require_per_axis("sides", given)?;
        match given.iter().find(|side| !(side.is_finite() && **side > S::zero())) {
            Some(side) => {
                Err(Error::domain("sides", format!("{side:?}"), "finite numbers above 0"))
            }
            None => Ok(given.to_vec()),
        }
    }

    /// The Coons patch on the faces of the form.
    pub(super) fn coons(&self) -> Result<Spline<S>> {
        let mut faces = Vec::with_capacity(2 * self.spline.axes());
        for axis in (0..self.spline.axes()).rev() {
            let (from, to) = self.spline.window(axis)?;
            faces.push(Shape::from(self.spline.sub(axis, &from)?));
            faces.push(Shape::from(self.spline.sub(axis, &to)?));
        }
        spanned(&faces, false).map(Shape::into_spline)
    }
}

fn spanned<S: Scalar>(faces: &[Shape<S>], are_forms: bool) -> Result<Shape<S>> {
    let options = CoonsOptions::default();
    let forms = faces.iter().filter_map(|face| match face {
        Shape::Form(form) => Some(form),
        Shape::Spline(_) => None,
    });
    let forms: Vec<&Form<S>> = forms.collect();
    if forms.len() == faces.len() && (are_forms || forms.iter().all(|form| form.axes() == 0)) {
        return coons(&forms, &options).map(Shape::Form);
    }
    let splines: Vec<Spline<S>> = faces.iter().cloned().map(Shape::into_spline).collect();
    coons_splines(&splines.iter().collect::<Vec<_>>(), &options).map(Shape::Spline)
}

/// With the orders of its pieces raised to those asked for.
fn raised<S: Scalar>(spline: Spline<S>, orders: &[usize]) -> Result<Spline<S>> {
    if orders.is_empty() {
        return Ok(spline);
    }
    spline.net().require_per_axis("orders", orders)?;
    let own: Vec<usize> = spline.degrees().iter().map(|degree| degree + 1).collect();
    if orders.iter().zip(&own).any(|(asked, own)| asked < own) {
        let expected = format!("orders of at least {own:?}, those of the boundary");
        return Err(Error::domain("orders", format!("{orders:?}"), expected));
    }
    if spline.counts().iter().all(|&count| count == 1) {
        return Ok(raise_to(spline.net(), orders)?.into());
    }
    let by: Vec<usize> = orders.iter().zip(&own).map(|(asked, own)| asked - own).collect();
    spline.elevate(&by)
}

/// The poles inside that are not kept.
fn free(orders: &[usize], keep: &[Vec<usize>]) -> Result<Vec<usize>> {
    for kept in keep {
        if kept.len() != orders.len() || kept.iter().zip(orders).any(|(at, order)| at >= order) {
            let expected = format!("places in a net of orders {orders:?}");
            return Err(Error::shape("keep", format!("{kept:?}"), expected));
        }
    }
    let count = orders.iter().product();
    let is_free = |index: &usize| {
        let place = place(*index, orders);
        is_inside(&place, orders) && !keep.contains(&place)
    };
    Ok((0..count).filter(is_free).collect())
}
