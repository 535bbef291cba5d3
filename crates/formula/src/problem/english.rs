//! Messages in English.

use super::{Problem, Sequence, shorten};

pub(super) fn message(problem: &Problem) -> String {
    match problem {
        Problem::Empty => "The formula is empty.".into(),
        Problem::MissingOperand => "A value is missing.".into(),
        Problem::MissingOperator => "An operator is missing between two values.".into(),
        Problem::MissingItem(sequence) => format!("{} is missing.", item(*sequence)),
        Problem::EmptyBrackets => "There is nothing between these brackets.".into(),
        Problem::Unclosed(closing) => {
            format!("This bracket is not closed: “{closing}” is missing.")
        }
        Problem::Mismatched { expected, found } => {
            format!("“{found}” stands where “{expected}” was expected.")
        }
        Problem::Unopened(closing) => format!("“{closing}” closes a bracket that was not opened."),
        Problem::LooseSeparator(mark) => format!("“{mark}” stands outside all brackets."),
        Problem::MisplacedWeight => "There is no point here that could have a weight.".into(),
        Problem::AfterWeight => "Something follows the weight of this point.".into(),
        Problem::Unexpected(word) => format!("“{}” has no meaning here.", shorten(word)),
        Problem::UnclosedText => "This text has no closing quote.".into(),
        Problem::BadAddress(word) => format!("“{}” is not the address of a cell.", shorten(word)),
        Problem::OutsideSheet(word) => {
            format!("The cell “{}” lies outside the sheet.", shorten(word))
        }
        Problem::RangeEnd => "The last cell of this range is missing.".into(),
        Problem::ReferenceInLiteral(word) => {
            format!("“{}” stands for a cell, and this is not a formula.", shorten(word))
        }
        Problem::TooDeep(limit) => format!("This is nested more than {limit} deep."),
    }
}

fn item(sequence: Sequence) -> &'static str {
    match sequence {
        Sequence::Point => "A coordinate",
        Sequence::Weight => "A weight",
        Sequence::List => "An element of the list",
        Sequence::Call => "An argument",
    }
}

pub(super) fn hint(problem: &Problem) -> String {
    match problem {
        Problem::Empty => {
            "Type a number, a point such as (1, 0, 0), a cell or a function after “=”."
        }
        Problem::MissingOperand => "A number, a point, a list, a cell or a function was expected.",
        Problem::MissingOperator => {
            "Put + - * / ^ or a comparison between them, or a separator inside brackets."
        }
        Problem::MissingItem(Sequence::Weight) => "Give the weight, or remove the mark before it.",
        Problem::MissingItem(_) => "Give it, or remove the separator.",
        Problem::EmptyBrackets => "Write a value to group, or the coordinates of a point.",
        Problem::Unclosed(_) => "Close the bracket.",
        Problem::Mismatched { .. } => "Use the closing bracket of the same kind.",
        Problem::Unopened(_) => "Remove it, or open the bracket before.",
        Problem::LooseSeparator(_) => "Put a point between ( ) and a list between [ ].",
        Problem::MisplacedWeight => "A weight ends a point: (x, y, z; w).",
        Problem::AfterWeight => "The weight comes last: (x, y, z; w).",
        Problem::Unexpected(_) => "Remove it, or put text between quotes: \"text\".",
        Problem::UnclosedText => "Add the closing quote; a quote inside a text is doubled.",
        Problem::BadAddress(_) => "Write A1, $A1, A$1 or $A$1.",
        Problem::OutsideSheet(_) => "Rows go up to 1000000, columns up to ZZZ.",
        Problem::RangeEnd => {
            "Write a range as A1:B3, and a keyword that is not the name of a cell."
        }
        Problem::ReferenceInLiteral(_) => {
            "Begin with = to compute with cells and names, or with ' to keep it as text."
        }
        Problem::TooDeep(_) => "Compute a part of it in a cell of its own.",
    }
    .into()
}
