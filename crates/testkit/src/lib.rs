//! What tests share: random forms, and the cases of the original system.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::missing_panics_doc,
    reason = "a test that cannot read its data must stop"
)]

mod random;
mod reference;

pub use random::{Random, Weights, relative_error};
pub use reference::{Case, cases, net, numbers};
