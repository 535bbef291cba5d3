//! Names that people give to cells, and what a name stands for.

use std::fmt;

use pforms_formula::{Address, Range, Reference};
use pforms_kernel::{Error, Result};

/// What a name stands for: a cell, or a rectangle of cells.
///
/// ```
/// use pforms_sheet::Target;
/// assert_eq!(Target::read("$a$4")?.to_string(), "A4");
/// assert_eq!(Target::read("A1:A3")?.to_string(), "A1:A3");
/// assert!(Target::read("A4 + 1").is_err());
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// One cell.
    Cell(Address),
    /// A rectangle of cells.
    Cells(Range),
}

impl Target {
    /// Reads `A4` or `A1:B3`.
    ///
    /// Errors: `Format` for anything else.
    pub fn read(text: &str) -> Result<Self> {
        let corner = |part: &str| Reference::read(part.trim()).map(|found| found.address);
        let target = match text.split_once(':') {
            None => corner(text).map(Self::Cell),
            Some((first, last)) => corner(first).zip(corner(last)).map(|(first, last)| {
                Self::Cells(Range { first: Reference::from(first), last: Reference::from(last) })
            }),
        };
        target.ok_or_else(|| {
            Error::format("a name's target", None, format!("{text:?} is no cell or range of cells"))
        })
    }
}

impl fmt::Display for Target {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Cell(address) => address.fmt(f),
            Self::Cells(range) => range.fmt(f),
        }
    }
}

/// Names are compared without regard to capitals.
pub(crate) fn folded(name: &str) -> String {
    name.to_lowercase()
}

/// Complains unless a formula can use `name`: letters, digits and `_`, no digit first, and not
/// itself an address or a truth value.
///
/// Errors: `Format`.
pub fn check_name(name: &str) -> Result<()> {
    let tree = pforms_formula::parse(&format!("={name}"), pforms_formula::Locale::DecimalPoint);
    let usable = match &tree[tree.root()].expression {
        pforms_formula::Expression::Name(read) => read == name,
        _ => false,
    };
    if usable {
        return Ok(());
    }
    let message = format!(
        "{name:?} cannot be a name: letters, digits and _ make one, and it is no address, TRUE or FALSE"
    );
    Err(Error::format("a name", None, message))
}
