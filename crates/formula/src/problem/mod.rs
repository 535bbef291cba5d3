//! What can be wrong in a formula, and how to tell it to people.

mod english;
mod french;

use crate::locale::Language;

/// What can be wrong at a place of a formula.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Problem {
    /// There is nothing to read.
    Empty,
    /// An operator or a sign lacks what it works on.
    MissingOperand,
    /// Two values touch without an operator between them.
    MissingOperator,
    /// An element is missing between two separators, or after the last.
    MissingItem(Sequence),
    /// `()` holds nothing.
    EmptyBrackets,
    /// A bracket opened here is never closed; the bracket that is awaited.
    Unclosed(char),
    /// A bracket is closed by one of the other kind.
    Mismatched {
        /// The bracket that would close it.
        expected: char,
        /// The bracket found.
        found: char,
    },
    /// A bracket is closed that was not opened.
    Unopened(char),
    /// A separator outside all brackets.
    LooseSeparator(char),
    /// A weight mark where no weight can be.
    MisplacedWeight,
    /// Something follows the weight of a point.
    AfterWeight,
    /// A word or sign that means nothing here.
    Unexpected(String),
    /// The closing quote of a text is missing.
    UnclosedText,
    /// A `$` in something that is not the address of a cell.
    BadAddress(String),
    /// An address beyond the last row of a sheet.
    OutsideSheet(String),
    /// A range without its last cell.
    RangeEnd,
    /// A cell or a name in a value that is not a formula.
    ReferenceInLiteral(String),
    /// Nested deeper than allowed; the limit.
    TooDeep(usize),
}

/// What an element belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sequence {
    /// The coordinates of a point.
    Point,
    /// The weight of a point.
    Weight,
    /// The elements of a list.
    List,
    /// The arguments of a call.
    Call,
}

impl Problem {
    /// What is wrong, in a sentence.
    pub fn message(&self, language: Language) -> String {
        match language {
            Language::English => english::message(self),
            Language::French => french::message(self),
        }
    }

    /// What was expected, or what to do, in a sentence.
    pub fn hint(&self, language: Language) -> String {
        match language {
            Language::English => english::hint(self),
            Language::French => french::hint(self),
        }
    }
}

/// At most 20 characters of a text, for messages.
fn shorten(text: &str) -> String {
    let mut short: String = text.chars().take(20).collect();
    if short.len() < text.len() {
        short.push('…');
    }
    short
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_words_are_cut_in_messages() {
        let problem = Problem::Unexpected("é".repeat(100_000));
        for language in [Language::English, Language::French] {
            assert!(problem.message(language).chars().count() < 80);
        }
    }
}
