//! The entries, one file for each chapter.

mod numbers;

use crate::Operator;

/// Every entry, in the order of the book.
pub(crate) fn all() -> Vec<Operator> {
    numbers::ENTRIES.to_vec()
}
