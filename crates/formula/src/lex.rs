//! Text to words, in one pass. Every character belongs to a word or to the space between words.

use crate::locale::Locale;
use crate::operator::Operator;
use crate::place::Span;
use crate::token::{Bracket, Kind, Token};

/// The words of `source` from byte `from` on (a place between characters), ended by one [`Kind::End`].
pub(crate) fn lex(source: &str, from: usize, locale: Locale) -> Vec<Token> {
    let (skipped, rest) = source.split_at(from);
    let mut lexer =
        Lexer { source, rest, column: skipped.chars().count(), locale, tokens: Vec::new() };
    while lexer.step() {}
    lexer.tokens
}

struct Lexer<'a> {
    source: &'a str,
    rest: &'a str,
    column: usize,
    locale: Locale,
    tokens: Vec<Token>,
}

impl Lexer<'_> {
    fn step(&mut self) -> bool {
        self.take_while(is_space);
        let (start, column) = (self.offset(), self.column);
        let kind = self.word();
        self.push(kind, start, column);
        kind != Kind::End
    }

    /// Appends a word; unknown characters that touch become one word.
    fn push(&mut self, kind: Kind, start: usize, column: usize) {
        let span = Span::new(start, self.offset());
        match self.tokens.last_mut() {
            Some(last) if kind == Kind::Unknown && last.kind == kind && last.span.end == start => {
                last.span.end = span.end;
            }
            _ => self.tokens.push(Token { kind, span, column }),
        }
    }

    fn word(&mut self) -> Kind {
        let Some(first) = self.peek() else { return Kind::End };
        if self.starts_number() {
            return self.number();
        }
        if starts_word(first) || first == '$' {
            self.take_while(|c| continues_word(c) || c == '$');
            return Kind::Word;
        }
        self.bump();
        match first {
            '(' => Kind::Open(Bracket::Round),
            ')' => Kind::Close(Bracket::Round),
            '[' => Kind::Open(Bracket::Square),
            ']' => Kind::Close(Bracket::Square),
            ',' => Kind::Comma,
            ';' => Kind::Semicolon,
            '|' => Kind::Bar,
            ':' => Kind::Colon,
            '"' => self.text(),
            '“' | '”' | '„' | '‟' => self.quotation(|c| matches!(c, '“' | '”' | '‟' | '"')),
            '«' => self.quotation(|c| c == '»'),
            _ => self.operator(first).map_or(Kind::Unknown, Kind::Operator),
        }
    }

    fn operator(&mut self, first: char) -> Option<Operator> {
        Some(match first {
            '+' => Operator::Add,
            '-' | '−' | '–' => Operator::Subtract,
            '*' if self.take('*') => Operator::Power,
            '*' | '×' | '·' | '⋅' | '∗' => Operator::Multiply,
            '/' | '÷' | '∕' | '⁄' => Operator::Divide,
            '^' => Operator::Power,
            '=' => {
                self.take('=');
                Operator::Equal
            }
            '<' if self.take('=') => Operator::LessEqual,
            '<' if self.take('>') => Operator::NotEqual,
            '<' => Operator::Less,
            '>' if self.take('=') => Operator::GreaterEqual,
            '>' => Operator::Greater,
            '!' if self.take('=') => Operator::NotEqual,
            '≠' => Operator::NotEqual,
            '≤' => Operator::LessEqual,
            '≥' => Operator::GreaterEqual,
            _ => return None,
        })
    }

    /// A text in straight quotes, where a doubled quote stands for one.
    fn text(&mut self) -> Kind {
        while let Some(c) = self.bump() {
            if c == '"' && !self.take('"') {
                return Kind::Text { closed: true };
            }
        }
        Kind::Text { closed: false }
    }

    fn quotation(&mut self, closes: impl Fn(char) -> bool) -> Kind {
        while let Some(c) = self.bump() {
            if closes(c) {
                return Kind::Text { closed: true };
            }
        }
        Kind::Text { closed: false }
    }

    fn starts_number(&self) -> bool {
        let digit = |c: char| c.is_ascii_digit();
        match self.peek() {
            Some('.') => self.rest[1..].starts_with(digit),
            Some(',') => self.comma_is_decimal() && self.rest[1..].starts_with(digit),
            first => first.is_some_and(digit),
        }
    }

    /// Whether a comma here may open a number: `,5` where an operand is due.
    fn comma_is_decimal(&self) -> bool {
        let operand_before =
            |kind| matches!(kind, Kind::Number | Kind::Word | Kind::Text { .. } | Kind::Close(_));
        self.locale == Locale::DecimalComma
            && !self.tokens.last().is_some_and(|t| operand_before(t.kind))
    }

    fn number(&mut self) -> Kind {
        self.take_while(|c| c.is_ascii_digit());
        let comma = self.locale == Locale::DecimalComma
            && self
                .rest
                .strip_prefix(',')
                .is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_digit()));
        if comma || self.peek() == Some('.') {
            self.bump();
            self.take_while(|c| c.is_ascii_digit());
        }
        self.exponent();
        Kind::Number
    }

    /// Takes `e-3`, but leaves an `e` that no digit follows.
    fn exponent(&mut self) {
        let Some(after) = self.rest.strip_prefix(['e', 'E']) else { return };
        let digits = after.strip_prefix(['+', '-', '−']).unwrap_or(after);
        if digits.starts_with(|c: char| c.is_ascii_digit()) {
            self.bump();
            self.bump();
            self.take_while(|c| c.is_ascii_digit());
        }
    }

    fn offset(&self) -> usize {
        self.source.len() - self.rest.len()
    }

    fn peek(&self) -> Option<char> {
        self.rest.chars().next()
    }

    fn bump(&mut self) -> Option<char> {
        let mut characters = self.rest.chars();
        let first = characters.next()?;
        self.rest = characters.as_str();
        self.column += 1;
        Some(first)
    }

    fn take(&mut self, wanted: char) -> bool {
        self.peek() == Some(wanted) && self.bump().is_some()
    }

    fn take_while(&mut self, wanted: impl Fn(char) -> bool) {
        while self.peek().is_some_and(&wanted) {
            self.bump();
        }
    }
}

/// Space, non-breaking and zero-width ones included.
pub(crate) fn is_space(c: char) -> bool {
    c.is_whitespace() || matches!(c, '\u{200b}' | '\u{2060}' | '\u{feff}')
}

fn starts_word(c: char) -> bool {
    c.is_alphabetic() || c == '_'
}

fn continues_word(c: char) -> bool {
    let combining_accent = matches!(c, '\u{300}'..='\u{36f}');
    starts_word(c) || c.is_ascii_digit() || combining_accent
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(source: &str, locale: Locale) -> Vec<&str> {
        let tokens = lex(source, 0, locale);
        tokens.iter().map(|t| t.span.of(source)).filter(|t| !t.is_empty()).collect()
    }

    #[test]
    fn decimal_commas_are_told_from_separators() {
        let words = |source| words(source, Locale::DecimalComma);
        assert_eq!(words("1,5"), ["1,5"]);
        assert_eq!(words("(1, 5)"), ["(", "1", ",", "5", ")"]);
        assert_eq!(words("F(A1,5;,5)"), ["F", "(", "A1", ",", "5", ";", ",5", ")"]);
        assert_eq!(words("1.5,2"), ["1.5", ",", "2"]);
        assert_eq!(words("1,5e−3"), ["1,5e−3"]);
    }

    #[test]
    fn numbers_end_where_they_should() {
        let words = |source| words(source, Locale::DecimalPoint);
        assert_eq!(words("1.e5 1e .5 . 2E+x"), ["1.e5", "1", "e", ".5", ".", "2", "E", "+", "x"]);
        assert_eq!(words("1,5"), ["1", ",", "5"]);
        assert_eq!(words("x² #!?"), ["x", "²", "#!?"]);
    }

    #[test]
    fn typographic_signs_and_columns() {
        let tokens = lex("=é\u{a0}≤ “a”×", 1, Locale::DecimalPoint);
        let kinds: Vec<Kind> = tokens.iter().map(|t| t.kind).collect();
        let text = Kind::Text { closed: true };
        let expected = [
            Kind::Word,
            Kind::Operator(Operator::LessEqual),
            text,
            Kind::Operator(Operator::Multiply),
            Kind::End,
        ];
        assert_eq!(kinds, expected);
        assert_eq!(tokens.iter().map(|t| t.column).collect::<Vec<_>>(), [1, 3, 5, 8, 9]);
    }
}
