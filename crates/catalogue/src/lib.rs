//! Every operator once, and `Value`: what flows from cell to cell.
//!
//! ```
//! use pforms_catalogue::{Arguments, Language, Value, find};
//!
//! let sqrt = find("racine").unwrap();
//! assert_eq!(sqrt.signature(Language::French), "RACINE(x)");
//! let root = sqrt.call(Arguments::new([Value::Number(0.25)]));
//! assert_eq!(root.display(Language::English), "0.5");
//! ```

mod arguments;
mod arithmetic;
mod bound;
mod catalogue;
mod cost;
mod display;
mod elementary;
mod entries;
mod exact;
mod failure;
mod french;
mod infix;
mod json;
mod net;
mod operator;
mod parameter;
mod traced;
mod value;
mod words;

pub use arguments::Arguments;
pub use arithmetic::Arithmetic;
pub use bound::Bound;
pub use catalogue::{Completion, catalogue, complete, find, unknown};
pub use elementary::Elementary;
pub use exact::BITS_CAP;
pub use failure::Failure;
pub use infix::{Infix, binary, negate};
#[doc(hidden)]
pub use operator::{Call, Routine};
pub use operator::{Group, Operator};
pub use parameter::{Fallback, Parameter, Range, Takes};
pub use traced::{numbers, sources, traced};
pub use value::{DEPTH_CAP, LIST_CAP, Value};
pub use words::{Language, Message, Words, fold};
