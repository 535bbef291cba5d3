//! Cells that recalculate, headless.

mod document;
mod edit;
mod graph;
mod history;
mod name;
pub mod pfs;

pub use document::{Document, Settings};
pub use edit::Edit;
pub use history::{Entry, Snapshot, Step};
pub use name::{Target, check_name};
