//! The forms in a value.

use pforms_catalogue::{Arithmetic, Value};
use pforms_kernel::{Error, Form, Result, Scalar};

/// The forms of a value that can be drawn, and the net its poles are taken from.
#[derive(Clone, Debug, PartialEq)]
pub struct Shapes {
    /// What is drawn.
    pub forms: Vec<Form>,
    /// What carries the poles: of a form in pieces, the refined net they share.
    pub nets: Vec<Form>,
}

impl Shapes {
    /// Forms that carry their own poles.
    pub fn of(forms: Vec<Form>) -> Self {
        Self { nets: forms.clone(), forms }
    }

    /// All forms in a value: its own, its pieces, those of a list and of the lists inside it.
    ///
    /// Numbers, texts and the like in a list are passed over.
    ///
    /// Errors: `Shape` when the value holds no form at all; `Limit` when an immersed form is too
    /// large to be expanded.
    pub fn in_value<S: Arithmetic>(value: &Value<S>) -> Result<Self> {
        let mut shapes = Self { forms: Vec::new(), nets: Vec::new() };
        shapes.gather(value)?;
        if shapes.forms.is_empty() {
            let kind = value.kind(pforms_catalogue::Language::English);
            return Err(Error::shape("value", format!("a value of kind {kind}"), "a form to draw"));
        }
        Ok(shapes)
    }

    fn gather<S: Arithmetic>(&mut self, value: &Value<S>) -> Result<()> {
        match value {
            Value::Form(form) => self.push(floating(form)?),
            Value::Immersed(lazy) => self.push(floating(&lazy.expand()?)?),
            Value::Spline(pieces) => {
                for piece in pieces.pieces()? {
                    self.forms.push(floating(&piece)?);
                }
                self.nets.push(floating(pieces.net())?);
            }
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

    fn push(&mut self, form: Form) {
        self.nets.push(form.clone());
        self.forms.push(form);
    }
}

fn floating<S: Scalar>(form: &Form<S>) -> Result<Form> {
    form.map_scalar(S::to_f64)
}
