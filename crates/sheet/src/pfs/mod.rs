//! The file format of a sheet: TOML that a person can read, compare and merge.
//!
//! ```toml
//! pfs = 1
//! title = "Octant of sphere"
//!
//! [cells]
//! A4 = "=MIR(A1, A2, A3)"
//!
//! [names]
//! sphere = "A4"
//!
//! [show.A4]
//! draw = ["surface"]
//!
//! [camera]
//! view = "AXO"
//!
//! [[notes]]
//! text = "…"
//! ```
//!
//! Cells are written column by column, names by the alphabet, and the keys of a style, the camera
//! or a note in the order they had. What we wrote reads and writes back byte for byte. A comment
//! stays above or behind its line; when the line is gone it moves to the end.

mod read;
mod remarks;
mod write;

pub(crate) use read::is_title;
pub use read::{read, read_bytes};
pub use remarks::{Remark, Remarks};
pub use write::write;

/// The version of the format that is written, and the last one that is read.
pub const VERSION: i64 = 1;
