//! The words of the language, with their places.

use crate::operator::Operator;
use crate::place::Span;

/// Round or square.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Bracket {
    Round,
    Square,
}

impl Bracket {
    pub(crate) fn closing(self) -> char {
        match self {
            Self::Round => ')',
            Self::Square => ']',
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Number,
    Word,
    /// A quoted text, and whether its closing quote was found.
    Text {
        closed: bool,
    },
    Operator(Operator),
    Open(Bracket),
    Close(Bracket),
    Comma,
    Semicolon,
    Bar,
    Colon,
    /// A run of characters that mean nothing here.
    Unknown,
    End,
}

/// One word: what it is, where, and in which character column (counted from 0) it begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Token {
    pub(crate) kind: Kind,
    pub(crate) span: Span,
    pub(crate) column: usize,
}

impl Token {
    /// Whether an element of a point, a list or a call cannot go on here.
    pub(crate) fn ends_item(self) -> bool {
        matches!(self.kind, Kind::Comma | Kind::Semicolon | Kind::Bar | Kind::Close(_) | Kind::End)
    }
}
