//! Texts, cells, ranges, names, and the words that open a call.

use super::Parser;
use crate::address;
use crate::locale::read_boolean;
use crate::place::Span;
use crate::problem::Problem;
use crate::reference::{Range, Reference};
use crate::token::{Bracket, Kind, Token};
use crate::tree::{Expression, NodeId};

impl Parser<'_> {
    pub(super) fn text(&mut self, closed: bool) -> NodeId {
        let token = self.peek();
        let text = self.leaf(|word| Expression::Text(unquoted(word, closed)));
        if closed {
            return text;
        }
        self.fault(Problem::UnclosedText, token.column, token.span, vec![text])
    }

    /// A call, a truth value, a cell, a range or a name.
    pub(super) fn named(&mut self) -> NodeId {
        let word = self.word(self.peek());
        if self.peek_second().kind == Kind::Open(Bracket::Round) {
            return self.call();
        }
        if let Some(value) = read_boolean(word) {
            return self.leaf(|_| Expression::Boolean(value));
        }
        match Reference::read(word) {
            Some(first) if self.peek_second().kind == Kind::Colon => self.range(first),
            Some(cell) => self.reference(Expression::CellRef(cell)),
            None if word.contains('$') => self.refused(Problem::BadAddress(word.into())),
            None if address::split(word).is_some() => {
                self.refused(Problem::OutsideSheet(word.into()))
            }
            None => self.reference(Expression::Name(word.into())),
        }
    }

    fn range(&mut self, first: Reference) -> NodeId {
        let start = self.advance();
        self.advance();
        let last = self.peek();
        let corner = if last.kind == Kind::Word { Reference::read(self.word(last)) } else { None };
        let span = Span::new(start.span.start, self.end());
        let Some(corner) = corner else {
            let cell = self.push_at(Expression::CellRef(first), start.span);
            return self.fault(Problem::RangeEnd, start.column, span, vec![cell]);
        };
        self.advance();
        self.checked(Expression::Range(Range { first, last: corner }), start)
    }

    fn reference(&mut self, expression: Expression) -> NodeId {
        let token = self.advance();
        self.checked(expression, token)
    }

    /// What stands for other cells is refused in a literal, where only π has a name.
    fn checked(&mut self, expression: Expression, start: Token) -> NodeId {
        let span = Span::new(start.span.start, self.end());
        let word = span.of(self.source);
        if self.literal && !is_pi(word) {
            let problem = Problem::ReferenceInLiteral(word.into());
            return self.fault(problem, start.column, span, Vec::new());
        }
        self.push_at(expression, span)
    }

    fn refused(&mut self, problem: Problem) -> NodeId {
        let token = self.advance();
        self.fault(problem, token.column, token.span, Vec::new())
    }
}

fn is_pi(word: &str) -> bool {
    word.eq_ignore_ascii_case("pi") || word == "π"
}

/// The text between quotes: straight ones, where a doubled quote stands for one, or typographic ones.
fn unquoted(word: &str, closed: bool) -> String {
    let mut characters = word.chars();
    let opening = characters.next();
    if closed {
        characters.next_back();
    }
    let inner = characters.as_str();
    match opening {
        Some('"') => inner.replace("\"\"", "\""),
        Some('«') => inner.trim_matches(['\u{a0}', '\u{202f}']).into(),
        _ => inner.into(),
    }
}
