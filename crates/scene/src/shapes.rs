//! The forms in a value.

use pforms_catalogue::{Arithmetic, Value};
use pforms_kernel::{Error, Form, Result, Scalar};
use pforms_operators::{Poles, Shape};

/// The forms and splines of a value that can be drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Shapes(Vec<Shape>);

impl Shapes {
    /// Forms.
    pub fn of(forms: Vec<Form>) -> Self {
        Self(forms.into_iter().map(Shape::Form).collect())
    }

    /// Forms and splines.
    pub fn of_all(shapes: Vec<Shape>) -> Self {
        Self(shapes)
    }

    /// All forms in a value: its own, those of a list and of the lists inside it.
    ///
    /// Numbers, texts and the like in a list are passed over.
    ///
    /// Errors: `Shape` when the value holds no form at all; `Limit` when an immersed form is too
    /// large to be expanded.
    pub fn in_value<S: Arithmetic>(value: &Value<S>) -> Result<Self> {
        let mut shapes = Self(Vec::new());
        shapes.gather(value)?;
        if shapes.0.is_empty() {
            let kind = value.kind(pforms_catalogue::Language::English);
            return Err(Error::shape("value", format!("a value of kind {kind}"), "a form to draw"));
        }
        Ok(shapes)
    }

    fn gather<S: Arithmetic>(&mut self, value: &Value<S>) -> Result<()> {
        match value {
            Value::Form(form) => self.0.push(floating(form)?.into()),
            Value::Immersed(lazy) => self.0.push(floating(&lazy.expand()?)?.into()),
            Value::Spline(spline) => self.0.push(spline.map_scalar(S::to_f64)?.into()),
            Value::List(items) => items.iter().try_for_each(|item| self.gather(item))?,
            Value::Empty
            | Value::Number(_)
            | Value::Boolean(_)
            | Value::Text(_)
            | Value::Record(_)
            | Value::Error(_) => {}
        }
        Ok(())
    }

    /// What is drawn.
    pub fn as_slice(&self) -> &[Shape] {
        &self.0
    }

    /// What carries the poles: forms, and the nets of splines.
    pub fn nets(&self) -> Vec<&Form> {
        self.0.iter().map(Poles::net).collect()
    }

    /// The forms, and the pieces of the splines.
    ///
    /// Errors: `Limit`.
    pub fn pieces(&self) -> Result<Vec<Form>> {
        Ok(self.0.iter().map(Shape::pieces).collect::<Result<Vec<_>>>()?.concat())
    }
}

fn floating<S: Scalar>(form: &Form<S>) -> Result<Form> {
    form.map_scalar(S::to_f64)
}
