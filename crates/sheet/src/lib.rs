//! Cells that recalculate, headless: whatever a studio shows can be asked for here.
//!
//! ```
//! use pforms_catalogue::Value;
//! use pforms_sheet::Sheet;
//!
//! let mut sheet: Sheet = Sheet::open(r#"
//! pfs = 1
//! [cells]
//! A1 = "[(0, 0), (1, 2)]"
//! A2 = "[(2, 0), (3, 2)]"
//! A3 = "=MIR(A1, A2)"
//! [names]
//! facet = "A3"
//! "#)?;
//! sheet.recalculate_all();
//! let Value::Form(facet) = sheet.get("facet")? else { panic!() };
//! assert_eq!(facet.kind().to_string(), "pS22");
//!
//! sheet.move_pole("A1".parse()?, &[1], &[1.0, 5.0])?;
//! assert_eq!(sheet.document().text("A1".parse()?), "[(0, 0), (1, 5)]");
//! assert_eq!(sheet.recalculate_all().changed.len(), 2);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod cancel;
mod cell;
mod document;
mod edit;
mod editing;
mod evaluate;
mod export;
mod graph;
mod history;
mod name;
pub mod pfs;
mod recalculate;
mod settings;
mod sheet;

pub use cancel::{Cancel, Clock};
pub use cell::{Cost, Info};
pub use document::{Document, Settings};
pub use edit::Edit;
pub use editing::Clip;
pub use evaluate::Sensitivities;
pub use history::{Entry, Snapshot, Step};
pub use name::{Target, check_name};
pub use pforms_formula::{Address, Range};
pub use recalculate::Report;
pub use sheet::Sheet;
