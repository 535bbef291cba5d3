//! A form and what it is called.

use pforms_kernel::{Form, Scalar};
use pforms_operators::{Poles, Shape, Spline};

/// A form or a spline of a file, with its name if it has one.
#[derive(Clone, Debug, PartialEq)]
pub struct Named<S = f64> {
    /// What it is called.
    pub name: Option<String>,
    /// The form or spline.
    pub shape: Shape<S>,
}

impl<S: Scalar> Named<S> {
    /// The poles: the form itself, or the net of the spline.
    pub fn net(&self) -> &Form<S> {
        self.shape.net()
    }
}

impl<S> From<Form<S>> for Named<S> {
    fn from(form: Form<S>) -> Self {
        Self { name: None, shape: Shape::Form(form) }
    }
}

impl<S: Scalar> From<Spline<S>> for Named<S> {
    fn from(spline: Spline<S>) -> Self {
        Self { name: None, shape: spline.into() }
    }
}

impl<S> From<Shape<S>> for Named<S> {
    fn from(shape: Shape<S>) -> Self {
        Self { name: None, shape }
    }
}
