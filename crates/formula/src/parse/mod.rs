//! Words to tree: operators by strength, everything else by descent, with a limit on depth.

pub(crate) mod brackets;
mod words;

use crate::lex::{is_space, lex};
use crate::locale::Locale;
use crate::operator::{LOOSEST, Operator, SIGN, Sign};
use crate::place::Span;
use crate::problem::Problem;
use crate::token::{Bracket, Kind, Token};
use crate::tree::{Expression, Fault, Node, NodeId, Tree};

/// How deep brackets, calls, signs and right operands may nest.
pub const DEPTH_LIMIT: usize = 256;

/// Parses a formula, with or without its leading `=`. Never fails: see [`Tree::errors`]. Linear time.
pub fn parse(source: &str, locale: Locale) -> Tree {
    Parser::new(source, locale, false).run()
}

/// As [`parse`], where a cell or a name other than π is an error.
pub(crate) fn parse_literal(source: &str, locale: Locale) -> Tree {
    Parser::new(source, locale, true).run()
}

/// Where the expression begins: after space and a leading `=`.
pub(crate) fn body(source: &str) -> usize {
    let trimmed = source.trim_start_matches(is_space);
    source.len() - trimmed.strip_prefix('=').unwrap_or(trimmed).len()
}

struct Parser<'a> {
    source: &'a str,
    locale: Locale,
    literal: bool,
    tokens: Vec<Token>,
    next: usize,
    nodes: Vec<Node>,
    depth: usize,
    /// How many round and square brackets are open.
    open: [usize; 2],
}

impl<'a> Parser<'a> {
    fn new(source: &'a str, locale: Locale, literal: bool) -> Self {
        let tokens = lex(source, body(source), locale);
        Self { source, locale, literal, tokens, next: 0, nodes: Vec::new(), depth: 0, open: [0; 2] }
    }

    fn run(mut self) -> Tree {
        let root =
            if self.peek().kind == Kind::End { self.missing(Problem::Empty) } else { self.whole() };
        Tree { source: self.source.into(), locale: self.locale, nodes: self.nodes, root }
    }

    /// The expression; what is left after it, if anything, is gathered in one error.
    fn whole(&mut self) -> NodeId {
        let first = self.item();
        let stop = self.peek();
        let problem = match stop.kind {
            Kind::End => return first,
            Kind::Close(bracket) => Problem::Unopened(bracket.closing()),
            _ => Problem::LooseSeparator(self.word(stop).chars().next().unwrap_or(',')),
        };
        let mut parts = vec![first];
        while self.peek().kind != Kind::End {
            self.advance();
            if !self.peek().ends_item() {
                parts.push(self.item());
            }
        }
        self.fault(problem, stop.column, stop.span, parts)
    }

    /// One element, up to a separator, a closing bracket or the end. Must not stand at one of these.
    fn item(&mut self) -> NodeId {
        let first = self.expression(LOOSEST);
        let stop = self.peek();
        if stop.ends_item() {
            return first;
        }
        let problem = match stop.kind {
            Kind::Unknown | Kind::Colon => Problem::Unexpected(self.word(stop).into()),
            _ => Problem::MissingOperator,
        };
        let mut parts = vec![first];
        while !self.peek().ends_item() {
            parts.push(self.expression(LOOSEST));
        }
        self.fault(problem, stop.column, stop.span, parts)
    }

    /// An operand and all operators after it that are at least so strong.
    fn expression(&mut self, strength: u8) -> NodeId {
        if self.depth == DEPTH_LIMIT && !self.peek().ends_item() {
            return self.too_deep();
        }
        self.depth += 1;
        let first = self.peek().span.start;
        let mut left = self.operand();
        let start = first.min(self.nodes[left.index()].span.start);
        while let Kind::Operator(operator) = self.peek().kind {
            if operator.strength() < strength {
                break;
            }
            self.advance();
            let right = self.expression(operator.right_strength());
            left = self.push(Expression::Binary { operator, left, right }, start);
        }
        self.depth -= 1;
        left
    }

    fn operand(&mut self) -> NodeId {
        let token = self.peek();
        match token.kind {
            Kind::Number => self.leaf(|word| Expression::Number(number(word))),
            Kind::Text { closed } => self.text(closed),
            Kind::Word => self.named(),
            Kind::Open(Bracket::Round) => self.round(),
            Kind::Open(Bracket::Square) => self.list(),
            Kind::Operator(Operator::Add) => self.signed(Sign::Plus),
            Kind::Operator(Operator::Subtract) => self.signed(Sign::Minus),
            Kind::Unknown | Kind::Colon => {
                self.advance();
                let problem = Problem::Unexpected(self.word(token).into());
                self.fault(problem, token.column, token.span, Vec::new())
            }
            _ => self.missing(Problem::MissingOperand),
        }
    }

    fn signed(&mut self, sign: Sign) -> NodeId {
        let start = self.advance().span.start;
        let operand = self.expression(SIGN);
        self.push(Expression::Unary { sign, operand }, start)
    }

    /// Skips the element, brackets and all, without recursion.
    fn too_deep(&mut self) -> NodeId {
        let start = self.peek();
        let mut level = 0_usize;
        loop {
            let token = self.peek();
            match token.kind {
                Kind::End => break,
                _ if level == 0 && token.ends_item() => break,
                Kind::Open(_) => level += 1,
                Kind::Close(_) => level -= 1,
                _ => {}
            }
            self.advance();
        }
        let place = Span::new(start.span.start, self.end());
        self.fault(Problem::TooDeep(DEPTH_LIMIT), start.column, place, Vec::new())
    }

    fn peek(&self) -> Token {
        self.tokens[self.next]
    }

    fn peek_second(&self) -> Token {
        self.tokens[(self.next + 1).min(self.tokens.len() - 1)]
    }

    /// Takes a word; the end is never passed.
    fn advance(&mut self) -> Token {
        let token = self.peek();
        self.next = (self.next + 1).min(self.tokens.len() - 1);
        token
    }

    fn word(&self, token: Token) -> &'a str {
        token.span.of(self.source)
    }

    /// Where the last word taken ends.
    fn end(&self) -> usize {
        let last = self.next.checked_sub(1).map(|index| self.tokens[index]);
        last.map_or(self.peek().span.start, |token| token.span.end)
    }

    fn leaf(&mut self, make: impl FnOnce(&str) -> Expression) -> NodeId {
        let token = self.advance();
        let expression = make(self.word(token));
        self.push_at(expression, token.span)
    }

    /// Adds a node that reaches from byte `start` to the last word taken.
    fn push(&mut self, expression: Expression, start: usize) -> NodeId {
        let end = self.end().max(start);
        self.push_at(expression, Span::new(start, end))
    }

    fn push_at(&mut self, expression: Expression, span: Span) -> NodeId {
        self.nodes.push(Node { expression, span });
        Tree::id(self.nodes.len() - 1)
    }

    /// An error for something that should stand after the last word taken.
    fn missing(&mut self, problem: Problem) -> NodeId {
        let end = self.end();
        let last = self.next.checked_sub(1).map(|index| self.tokens[index]);
        let after = |token: Token| token.column + self.word(token).chars().count();
        let column = last.map_or(self.peek().column, after);
        self.fault(problem, column, Span::new(end, end), Vec::new())
    }

    /// An error at `place`, which begins in that column, holding the parts that were understood.
    fn fault(
        &mut self,
        problem: Problem,
        column: usize,
        place: Span,
        parts: Vec<NodeId>,
    ) -> NodeId {
        let held = |id: &NodeId| self.nodes[id.index()].span.start;
        let start = parts.first().map_or(place.start, held).min(place.start);
        let end = if parts.is_empty() { place.end } else { self.end().max(place.end) };
        let fault = Fault { problem, place, column, parts };
        self.push_at(Expression::Error(fault), Span::new(start, end))
    }
}

/// A number with a decimal point and plain signs, without a mark that no digit follows.
fn number(word: &str) -> String {
    let plain = word.replace(',', ".").replace('−', "-");
    match plain.split_once('.') {
        Some((whole, rest)) if !rest.starts_with(|c: char| c.is_ascii_digit()) => {
            format!("{whole}{rest}")
        }
        _ => plain,
    }
}
