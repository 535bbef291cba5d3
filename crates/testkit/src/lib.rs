//! What tests share: random forms, known shapes, the cases of the original system, and models of
//! other programs.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::missing_panics_doc,
    reason = "a test that cannot read its data must stop"
)]

pub mod memory;
pub mod models;
mod random;
mod reference;
mod root2;
mod shapes;
mod truth;

pub use random::{ROUNDS, Random, Weights, exact_forms, relative_error};
pub use reference::{Case, cases, net, numbers};
pub use root2::Root2;
pub use shapes::{octant, whole_sphere};
pub use truth::{Truth, truth, truths};
