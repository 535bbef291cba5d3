//! From one way of writing decimals to the other, word by word, so that spacing stays.

use crate::cell::{Content, classify};
use crate::lex::lex;
use crate::locale::Locale;
use crate::token::{Bracket, Kind, Token};

/// Rewrites the source of a cell from one locale to another. Spacing, texts and broken parts stay as they are.
///
/// Text stays text: where it would become a number by the change of locale, a `'` is put before it.
///
/// ```
/// use pforms_formula::{convert, Locale::{DecimalComma, DecimalPoint}};
/// assert_eq!(convert("=MI( (1,5; 2 | 0,5) ; A1)", DecimalComma, DecimalPoint), "=MI( (1.5, 2 ; 0.5) , A1)");
/// assert_eq!(convert("=MI((1.5,2;0.5), A1)", DecimalPoint, DecimalComma), "=MI((1,5;2|0,5); A1)");
/// assert_eq!(convert("see 1.5", DecimalPoint, DecimalComma), "see 1.5");
/// ```
pub fn convert(source: &str, from: Locale, to: Locale) -> String {
    match classify(source, from) {
        _ if from == to => source.into(),
        Content::Formula(_) | Content::Literal(_) => convert_words(source, from, to),
        Content::Text(_) if !matches!(classify(source, to), Content::Text(_)) => {
            format!("'{source}")
        }
        Content::Text(_) | Content::Empty => source.into(),
    }
}

/// Rewrites an expression, whatever it is.
pub(crate) fn convert_words(source: &str, from: Locale, to: Locale) -> String {
    if from == to {
        return source.into();
    }
    let mut text = String::with_capacity(source.len());
    let mut brackets = Brackets::default();
    let mut end = 0;
    for token in lex(source, 0, from) {
        text.push_str(&source[end..token.span.start]);
        let word = token.span.of(source);
        match replacement(token, brackets.in_point(), to) {
            _ if token.kind == Kind::Number => push_number(&mut text, word, to),
            Some(mark) => text.push(mark),
            None => text.push_str(word),
        }
        brackets.follow(token.kind);
        end = token.span.end;
    }
    text
}

/// The mark that stands for a separator in the other locale.
fn replacement(token: Token, in_point: bool, to: Locale) -> Option<char> {
    match (token.kind, to) {
        (Kind::Comma | Kind::Semicolon, Locale::DecimalPoint) => Some(','),
        (Kind::Bar, Locale::DecimalPoint) if in_point => Some(';'),
        (Kind::Semicolon, Locale::DecimalComma) if in_point => Some('|'),
        (Kind::Comma, Locale::DecimalComma) => Some(';'),
        _ => None,
    }
}

fn push_number(text: &mut String, word: &str, to: Locale) {
    let Some(mark) = word.find(['.', ',']) else {
        return text.push_str(word);
    };
    let (whole, fraction) = (&word[..mark], &word[mark + 1..]);
    text.push_str(whole);
    if fraction.starts_with(|c: char| c.is_ascii_digit()) {
        text.push(to.mark());
    }
    text.push_str(fraction);
}

/// The brackets open at a place, and whether the innermost may hold a point.
#[derive(Default)]
struct Brackets {
    points: Vec<bool>,
    after_word: bool,
}

impl Brackets {
    fn in_point(&self) -> bool {
        self.points.last().is_some_and(|point| *point)
    }

    fn follow(&mut self, kind: Kind) {
        match kind {
            Kind::Open(bracket) => self.points.push(bracket == Bracket::Round && !self.after_word),
            Kind::Close(_) => {
                self.points.pop();
            }
            _ => {}
        }
        self.after_word = kind == Kind::Word;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Locale::{DecimalComma, DecimalPoint};

    #[test]
    fn there_and_back() {
        for source in [
            "=(1.5, 2; 0.5)",
            "[(0,),(.5,)]",
            "=IF(A1>1.5, \"1.5, 2\", -1e-3)",
            "'1.5",
            "",
            "=F((x; 2), 3",
        ] {
            let comma = convert(source, DecimalPoint, DecimalComma);
            assert_eq!(convert(&comma, DecimalComma, DecimalPoint), source);
        }
        assert_eq!(convert("[1.,2]", DecimalPoint, DecimalComma), "[1;2]");
    }

    #[test]
    fn text_stays_text() {
        assert_eq!(convert("1,5", DecimalPoint, DecimalComma), "'1,5");
        assert_eq!(convert("1,5 m", DecimalPoint, DecimalComma), "1,5 m");
    }
}
