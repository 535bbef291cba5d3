//! Where a cell is: a column of letters and a row number, `A1`.

use std::fmt;
use std::str::FromStr;

/// Place of a cell. Column and row are counted from 1, as they are shown: `A1` is column 1, row 1.
///
/// Addresses sort by column, then by row: `A1, A2, …, B1`.
///
/// ```
/// use pforms_formula::Address;
/// let address: Address = "AA10".parse().unwrap();
/// assert_eq!((address.column(), address.row()), (27, 10));
/// assert_eq!(address.to_string(), "AA10");
/// assert!("A0".parse::<Address>().is_err());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Address {
    column: u32,
    row: u32,
}

/// The text is not the address of a cell within the limits of a sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotAnAddress;

impl fmt::Display for NotAnAddress {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("expected a cell between A1 and ZZZ1000000")
    }
}

impl std::error::Error for NotAnAddress {}

impl Address {
    /// The last column, `ZZZ`.
    pub const LAST_COLUMN: u32 = 26 + 26 * 26 + 26 * 26 * 26;
    /// The last row.
    pub const LAST_ROW: u32 = 1_000_000;

    /// The address at `column` and `row`, both counted from 1; `None` outside the sheet.
    pub fn new(column: u32, row: u32) -> Option<Self> {
        let inside =
            (1..=Self::LAST_COLUMN).contains(&column) && (1..=Self::LAST_ROW).contains(&row);
        inside.then_some(Self { column, row })
    }

    /// Column, counted from 1.
    pub fn column(self) -> u32 {
        self.column
    }

    /// Row, counted from 1.
    pub fn row(self) -> u32 {
        self.row
    }

    /// Letters of the column: `A`, `Z`, `AA`.
    pub fn letters(self) -> String {
        let mut letters = Vec::new();
        let mut rest = self.column;
        while rest > 0 {
            letters.push(char::from(b'A' + ((rest - 1) % 26) as u8));
            rest = (rest - 1) / 26;
        }
        letters.iter().rev().collect()
    }

    /// The address moved by so many columns and rows; `None` if that leaves the sheet.
    pub fn moved(self, columns: i64, rows: i64) -> Option<Self> {
        let column = i64::from(self.column).checked_add(columns)?;
        let row = i64::from(self.row).checked_add(rows)?;
        Self::new(u32::try_from(column).ok()?, u32::try_from(row).ok()?)
    }
}

impl fmt::Display for Address {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.letters(), self.row)
    }
}

impl FromStr for Address {
    type Err = NotAnAddress;

    fn from_str(text: &str) -> Result<Self, NotAnAddress> {
        let (letters, digits) = split(text).ok_or(NotAnAddress)?;
        let column = column_number(letters);
        let row = digits.parse().map_err(|_| NotAnAddress)?;
        Self::new(column, row).ok_or(NotAnAddress)
    }
}

/// One to three letters, then a number without leading zero; says nothing about the limits of the sheet.
pub(crate) fn split(text: &str) -> Option<(&str, &str)> {
    let cut = text.find(|c: char| !c.is_ascii_alphabetic())?;
    let (letters, digits) = text.split_at(cut);
    let plausible = (1..=3).contains(&letters.len()) && digits.bytes().all(|b| b.is_ascii_digit());
    (plausible && !digits.starts_with('0')).then_some((letters, digits))
}

fn column_number(letters: &str) -> u32 {
    let value = |b: u8| u32::from(b.to_ascii_uppercase() - b'A') + 1;
    letters.bytes().fold(0, |sum, b| sum * 26 + value(b))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_count_without_a_zero() {
        for (column, letters) in [
            (1, "A"),
            (26, "Z"),
            (27, "AA"),
            (702, "ZZ"),
            (703, "AAA"),
            (Address::LAST_COLUMN, "ZZZ"),
        ] {
            let address = Address::new(column, 7).unwrap();
            assert_eq!(address.letters(), letters);
            assert_eq!(format!("{letters}7").parse(), Ok(address));
        }
    }

    #[test]
    fn limits_hold() {
        assert!("ZZZ1000000".parse::<Address>().is_ok());
        for text in
            ["", "A", "1", "A0", "A01", "A1000001", "AAAA1", "A-1", "é1", "A1B", "A99999999999"]
        {
            assert_eq!(text.parse::<Address>(), Err(NotAnAddress), "{text}");
        }
        assert_eq!(Address::new(1, 1).unwrap().moved(-1, 0), None);
        assert_eq!(Address::new(1, 1).unwrap().moved(i64::MAX, i64::MIN), None);
    }

    #[test]
    fn addresses_sort_by_column_then_row() {
        let mut addresses: Vec<Address> =
            ["B1", "AA1", "A10", "A2"].iter().map(|t| t.parse().unwrap()).collect();
        addresses.sort();
        let text: Vec<String> = addresses.iter().map(ToString::to_string).collect();
        assert_eq!(text, ["A2", "A10", "B1", "AA1"]);
    }
}
