//! Stand-ins until the operators crate holds these types.
#![allow(missing_docs, clippy::missing_panics_doc)]
use pforms_kernel::Form;
#[derive(Clone, Debug)]
pub struct Piecewise<S>(Form<S>);
impl<S> Piecewise<S> {
    pub fn net(&self) -> &Form<S> {
        &self.0
    }
    pub fn degrees(&self) -> &[usize] {
        &[]
    }
}
#[derive(Clone, Debug)]
pub struct Immersed<S>(Form<S>, String);
pub struct Forecast {
    pub orders: Vec<usize>,
}
impl<S: pforms_kernel::Scalar> Immersed<S> {
    pub fn inner(&self) -> &Form<S> {
        &self.0
    }
    pub fn host(&self) -> &Form<S> {
        &self.0
    }
    pub fn forecast(&self) -> Forecast {
        Forecast { orders: Vec::new() }
    }
    pub fn kind(&self) -> String {
        self.1.clone()
    }
    pub fn expand(&self) -> pforms_kernel::Result<Form<S>> {
        Ok(self.0.clone())
    }
}
