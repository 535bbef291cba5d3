//! The formula language of a sheet: text to syntax tree and back.
//!
//! Parsing never fails. What cannot be understood becomes an error node with a place and a hint, and everything
//! around it is kept. Nothing here computes: names and operators get their meaning elsewhere.
//!
//! ```
//! use pforms_formula::{parse, print, Language, Locale};
//!
//! let tree = parse("=mir( A1,(1 , 0,0;.5) )", Locale::DecimalPoint);
//! assert!(!tree.has_errors());
//! assert_eq!(print(&tree, Locale::DecimalPoint, Language::English), "mir(A1, (1, 0, 0; .5))");
//! assert_eq!(print(&tree, Locale::DecimalComma, Language::French), "mir(A1; (1; 0; 0 | ,5))");
//!
//! let broken = parse("=MIR(A1, ", Locale::DecimalPoint);
//! let (_, fault) = broken.errors().next().unwrap();
//! assert_eq!(fault.problem.message(Language::English), "An argument is missing.");
//! assert_eq!(fault.column, 8);
//! ```

mod address;
mod caret;
mod cell;
mod convert;
mod lex;
mod locale;
mod number;
mod operator;
mod parse;
mod place;
mod points;
mod print;
mod problem;
mod reference;
mod rewrite;
mod token;
mod tree;
mod uses;

pub use address::{Address, NotAnAddress};
pub use caret::{CallContext, Context, at};
pub use cell::{Content, classify};
pub use convert::convert;
pub use locale::{Language, Locale};
pub use number::{decimal, digits_and_exponent};
pub use operator::{Operator, Sign};
pub use parse::{DEPTH_LIMIT, parse};
pub use place::{Span, byte_from_utf16, utf16_from_byte};
pub use points::{point_spans, replace_point};
pub use print::print;
pub use problem::{Problem, Sequence};
pub use reference::{Cells, Range, Reference};
pub use rewrite::{map_references, rename_reference, same_name, shift};
pub use tree::{Argument, Call, Expression, Fault, Link, Node, NodeId, Tree};
pub use uses::{References, references};
