//! Cells as a formula names them: one cell, or a rectangle of cells.

use crate::address::Address;
use std::fmt;

/// A cell named in a formula. A `$` fixes the column or the row when the formula is copied elsewhere.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Reference {
    /// The cell.
    pub address: Address,
    /// `$A1`: the column stays when the formula is copied.
    pub column_fixed: bool,
    /// `A$1`: the row stays when the formula is copied.
    pub row_fixed: bool,
}

impl Reference {
    /// Reads `A1`, `$A1`, `A$1` or `$A$1`, in capitals or not.
    pub fn read(text: &str) -> Option<Self> {
        let (column_fixed, rest) = strip_dollar(text);
        let cut = rest.find(|c: char| !c.is_ascii_alphabetic())?;
        let (letters, rest) = rest.split_at(cut);
        let (row_fixed, digits) = strip_dollar(rest);
        let plain = digits.starts_with(|c: char| c.is_ascii_digit());
        let address = plain.then(|| format!("{letters}{digits}").parse().ok())??;
        Some(Self { address, column_fixed, row_fixed })
    }

    /// The reference as it reads in a copy made so many columns and rows further; `None` if it leaves the sheet.
    pub fn shifted(self, columns: i64, rows: i64) -> Option<Self> {
        let columns = if self.column_fixed { 0 } else { columns };
        let rows = if self.row_fixed { 0 } else { rows };
        let address = self.address.moved(columns, rows)?;
        Some(Self { address, ..self })
    }
}

fn strip_dollar(text: &str) -> (bool, &str) {
    text.strip_prefix('$').map_or((false, text), |rest| (true, rest))
}

impl From<Address> for Reference {
    fn from(address: Address) -> Self {
        Self { address, column_fixed: false, row_fixed: false }
    }
}

impl fmt::Display for Reference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mark = |fixed| if fixed { "$" } else { "" };
        let (column, row) = (mark(self.column_fixed), mark(self.row_fixed));
        write!(f, "{column}{}{row}{}", self.address.letters(), self.address.row())
    }
}

/// A rectangle of cells, `A1:B3`. The corners are kept as written, in any order.
///
/// ```
/// use pforms_formula::{Range, Reference};
/// let corner = |text| Reference::read(text).unwrap();
/// let range = Range { first: corner("B2"), last: corner("A1") };
/// let cells: Vec<String> = range.cells().map(|cell| cell.to_string()).collect();
/// assert_eq!(cells, ["A1", "B1", "A2", "B2"]);
/// assert_eq!(range.len(), 4);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Range {
    /// Corner written first.
    pub first: Reference,
    /// Corner written last.
    pub last: Reference,
}

impl Range {
    /// First and last column, smaller one first.
    pub fn columns(&self) -> (u32, u32) {
        ordered(self.first.address.column(), self.last.address.column())
    }

    /// First and last row, smaller one first.
    pub fn rows(&self) -> (u32, u32) {
        ordered(self.first.address.row(), self.last.address.row())
    }

    /// How many cells there are: at least 1, up to 18,278,000,000. Check it before visiting them.
    #[allow(clippy::len_without_is_empty, reason = "a range holds at least one cell")]
    pub fn len(&self) -> u64 {
        let extent = |(low, high): (u32, u32)| u64::from(high - low) + 1;
        extent(self.columns()) * extent(self.rows())
    }

    /// Whether the cell lies in the rectangle.
    pub fn contains(&self, cell: Address) -> bool {
        let within = |(low, high): (u32, u32), value| (low..=high).contains(&value);
        within(self.columns(), cell.column()) && within(self.rows(), cell.row())
    }

    /// The cells row by row, made one at a time.
    pub fn cells(&self) -> Cells {
        let (columns, rows) = (self.columns(), self.rows());
        Cells { columns, last_row: rows.1, next: Some((columns.0, rows.0)) }
    }
}

fn ordered(a: u32, b: u32) -> (u32, u32) {
    (a.min(b), a.max(b))
}

impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}", self.first, self.last)
    }
}

/// The cells of a range, row by row.
#[derive(Clone, Debug)]
pub struct Cells {
    columns: (u32, u32),
    last_row: u32,
    next: Option<(u32, u32)>,
}

impl Iterator for Cells {
    type Item = Address;

    fn next(&mut self) -> Option<Address> {
        let (column, row) = self.next?;
        self.next = match (column < self.columns.1, row < self.last_row) {
            (true, _) => Some((column + 1, row)),
            (false, true) => Some((self.columns.0, row + 1)),
            (false, false) => None,
        };
        Address::new(column, row)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dollars_are_read_written_and_respected() {
        for text in ["A1", "$A1", "A$1", "$ZZ$12"] {
            assert_eq!(Reference::read(text).unwrap().to_string(), text);
        }
        for text in ["$", "$$A1", "A$$1", "A1$", "$A", "A$", "1$A", "A$é"] {
            assert_eq!(Reference::read(text), None, "{text}");
        }
        let shifted =
            |text, c, r| Reference::read(text).unwrap().shifted(c, r).map(|x| x.to_string());
        assert_eq!(shifted("A1", 2, 3).as_deref(), Some("C4"));
        assert_eq!(shifted("$A1", 2, 3).as_deref(), Some("$A4"));
        assert_eq!(shifted("A$1", 2, -3).as_deref(), Some("C$1"));
        assert_eq!(shifted("A1", -1, 0), None);
    }

    #[test]
    fn the_whole_sheet_is_counted_without_being_visited() {
        let corner = |text| Reference::read(text).unwrap();
        let all = Range { first: corner("ZZZ1000000"), last: corner("A1") };
        assert_eq!(all.len(), 18_278_000_000);
        assert_eq!(all.cells().take(2).last(), Address::new(2, 1));
        assert!(all.contains(Address::new(300, 300).unwrap()));
    }
}
