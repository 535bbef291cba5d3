//! What the native benches share: forms to measure with, and the works that are done natively and in
//! WebAssembly alike.

#![expect(
    clippy::unwrap_used,
    clippy::missing_panics_doc,
    reason = "the data is fixed: a mistake in it should stop the run"
)]

mod data;
pub mod works;

pub use data::{Kind, form, inside, parameters, scattered};
