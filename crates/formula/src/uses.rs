//! What a formula depends on.

use crate::address::Address;
use crate::reference::Range;
use crate::tree::{Expression, Tree};
use std::collections::HashSet;

/// The cells, ranges and names a tree mentions, each once, in order of appearance.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct References {
    /// Cells named one by one.
    pub cells: Vec<Address>,
    /// Rectangles of cells; ask for [`Range::len`] before visiting one.
    pub ranges: Vec<Range>,
    /// Names as typed; two that differ only in capitals count as one, see [`crate::same_name`].
    pub names: Vec<String>,
}

/// Collects what a tree depends on, the understood parts of errors included. Linear time.
///
/// ```
/// use pforms_formula::{parse, references, Locale};
/// let found = references(&parse("=MIR(A1, $A$1, B1:B3, Profile)", Locale::DecimalPoint));
/// assert_eq!((found.cells.len(), found.ranges[0].len(), found.names), (1, 3, vec!["Profile".into()]));
/// ```
pub fn references(tree: &Tree) -> References {
    let mut found = References::default();
    let (mut cells, mut ranges, mut names) = (HashSet::new(), HashSet::new(), HashSet::new());
    for node in tree.nodes() {
        match &node.expression {
            Expression::CellRef(cell) if cells.insert(cell.address) => {
                found.cells.push(cell.address);
            }
            Expression::Range(range) if ranges.insert((range.columns(), range.rows())) => {
                found.ranges.push(*range);
            }
            Expression::Name(name) if names.insert(name.to_lowercase()) => {
                found.names.push(name.clone());
            }
            _ => {}
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Locale, parse};

    #[test]
    fn broken_formulas_still_depend_on_what_they_name() {
        let found = references(&parse("=MIR(A1, (B2, name) C3 #, D4:E", Locale::DecimalPoint));
        let cells: Vec<String> = found.cells.iter().map(ToString::to_string).collect();
        assert_eq!(cells, ["A1", "B2", "C3", "D4"]);
        assert_eq!(found.names, ["name", "E"]);
    }

    #[test]
    fn each_once() {
        let found = references(&parse("=a1+A1+A+a+A1:B2+B2:A1", Locale::DecimalPoint));
        assert_eq!((found.cells.len(), found.ranges.len(), found.names.len()), (1, 1, 1));
    }
}
