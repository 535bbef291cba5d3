//! Points, groups, lists and arguments: everything between brackets.

use super::Parser;
use crate::locale::Locale;
use crate::place::Span;
use crate::problem::{Problem, Sequence};
use crate::token::{Bracket, Kind, Token};
use crate::tree::{Argument, Call, Expression, NodeId};

/// Functions in which `=` after a name compares instead of giving a keyword: `IF(x=1, …)`.
const LOGICAL: [&str; 9] = ["IF", "SI", "AND", "ET", "OR", "OU", "NOT", "NON", "XOR"];

impl Parser<'_> {
    /// `(x, y, z; w)`, or a grouped expression.
    pub(super) fn round(&mut self) -> NodeId {
        let open = self.enter(Bracket::Round);
        let mut coordinates = Vec::new();
        let mut lone = true;
        loop {
            let empty = lone && self.at_closing();
            let missing =
                if empty { Problem::EmptyBrackets } else { Problem::MissingItem(Sequence::Point) };
            coordinates.push(self.item_or(missing));
            if !self.at_separator() {
                break;
            }
            self.advance();
            lone = false;
            if coordinates.len() == 1 && self.at_closing() {
                break;
            }
        }
        let weight = self.weight();
        let problem = self.leave(Bracket::Round);
        let inside = match (weight, coordinates.as_slice()) {
            (None, &[grouped]) if lone => grouped,
            _ => self.push(Expression::Point { coordinates, weight }, open.span.start),
        };
        self.closed(problem, open, inside)
    }

    /// The weight after its mark, if there is one; whatever comes after it is an error.
    fn weight(&mut self) -> Option<NodeId> {
        if self.at_closing() {
            return None;
        }
        self.advance();
        let weight = self.item_or(Problem::MissingItem(Sequence::Weight));
        let extra = self.peek();
        let mut parts = vec![weight];
        while matches!(self.peek().kind, Kind::Comma | Kind::Semicolon | Kind::Bar) {
            self.advance();
            if !self.peek().ends_item() {
                parts.push(self.item());
            }
        }
        if self.peek() == extra {
            return Some(weight);
        }
        Some(self.fault(Problem::AfterWeight, extra.column, extra.span, parts))
    }

    /// `[a, b, …]`.
    pub(super) fn list(&mut self) -> NodeId {
        let open = self.enter(Bracket::Square);
        let mut items = Vec::new();
        self.sequence(|parser| {
            let item = parser.item_or(Problem::MissingItem(Sequence::List));
            items.push(parser.without_weight(item));
        });
        let problem = self.leave(Bracket::Square);
        let list = self.push(Expression::List(items), open.span.start);
        self.closed(problem, open, list)
    }

    /// `NAME(arguments)`.
    pub(super) fn call(&mut self) -> NodeId {
        let head = self.advance();
        let name = self.word(head);
        let open = self.enter(Bracket::Round);
        let logical = is_logical(name);
        let mut arguments = Vec::new();
        self.sequence(|parser| arguments.push(parser.argument(logical)));
        let problem = self.leave(Bracket::Round);
        let call = Call { name: name.into(), name_span: head.span, arguments };
        let mut id = self.push(Expression::Call(call), head.span.start);
        if name.contains('$') {
            id = self.fault(Problem::BadAddress(name.into()), head.column, head.span, vec![id]);
        }
        self.closed(problem, open, id)
    }

    fn argument(&mut self, logical: bool) -> Argument {
        let keyword = self.at_keyword(logical).then(|| self.advance());
        if keyword.is_some() {
            self.advance();
        }
        let value = self.item_or(Problem::MissingItem(Sequence::Call));
        let value = self.without_weight(value);
        let keyword_span = keyword.map_or(Span::default(), |token| token.span);
        Argument { keyword: keyword.map(|token| self.word(token).into()), keyword_span, value }
    }

    fn at_keyword(&self, logical: bool) -> bool {
        let (word, mark) = (self.peek(), self.peek_second());
        let marked = mark.kind == Kind::Colon || (!logical && self.word(mark) == "=");
        word.kind == Kind::Word && marked && is_plain_name(self.word(word))
    }

    /// Elements between separators until the bracket closes; none at all if it closes at once.
    fn sequence(&mut self, mut element: impl FnMut(&mut Self)) {
        if self.at_closing() {
            return;
        }
        element(self);
        while matches!(self.peek().kind, Kind::Comma | Kind::Semicolon) {
            self.advance();
            element(self);
        }
    }

    /// Takes the weight marks that stand where no weight can be, with what follows them.
    fn without_weight(&mut self, item: NodeId) -> NodeId {
        let mark = self.peek();
        if mark.kind != Kind::Bar {
            return item;
        }
        let mut parts = vec![item];
        while self.peek().kind == Kind::Bar {
            self.advance();
            if !self.peek().ends_item() {
                parts.push(self.item());
            }
        }
        self.fault(Problem::MisplacedWeight, mark.column, mark.span, parts)
    }

    fn item_or(&mut self, missing: Problem) -> NodeId {
        if self.peek().ends_item() { self.missing(missing) } else { self.item() }
    }

    /// Whether coordinates go on; in a point, the semicolon separates only where commas mark decimals.
    fn at_separator(&self) -> bool {
        match self.peek().kind {
            Kind::Comma => true,
            Kind::Semicolon => self.locale == Locale::DecimalComma,
            _ => false,
        }
    }

    fn at_closing(&self) -> bool {
        matches!(self.peek().kind, Kind::Close(_) | Kind::End)
    }

    fn enter(&mut self, bracket: Bracket) -> Token {
        self.open[bracket as usize] += 1;
        self.advance()
    }

    /// Takes the closing bracket. A bracket of the other kind is taken too, unless it closes one further out.
    fn leave(&mut self, bracket: Bracket) -> Option<Problem> {
        self.open[bracket as usize] -= 1;
        let expected = bracket.closing();
        match self.peek().kind {
            Kind::Close(found) if found == bracket => {
                self.advance();
                None
            }
            Kind::Close(found) if self.open[found as usize] == 0 => {
                self.advance();
                Some(Problem::Mismatched { expected, found: found.closing() })
            }
            _ => Some(Problem::Unclosed(expected)),
        }
    }

    fn closed(&mut self, problem: Option<Problem>, open: Token, inside: NodeId) -> NodeId {
        match problem {
            Some(problem) => self.fault(problem, open.column, open.span, vec![inside]),
            None => inside,
        }
    }
}

/// Whether `=` after a name compares in the arguments of this function.
pub(crate) fn is_logical(name: &str) -> bool {
    LOGICAL.iter().any(|word| word.eq_ignore_ascii_case(name))
}

/// Whether a word can be a keyword: neither a cell nor a truth value.
pub(crate) fn is_plain_name(word: &str) -> bool {
    let cell = word.contains('$') || crate::address::split(word).is_some();
    !cell && crate::locale::read_boolean(word).is_none()
}
