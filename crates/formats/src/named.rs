//! A form and what it is called.

use pforms_kernel::Form;

/// A form of a file, with its name if it has one.
#[derive(Clone, Debug, PartialEq)]
pub struct Named<S = f64> {
    /// What it is called.
    pub name: Option<String>,
    /// The form.
    pub form: Form<S>,
}

impl<S> From<Form<S>> for Named<S> {
    fn from(form: Form<S>) -> Self {
        Self { name: None, form }
    }
}
