//! What is being typed at the caret: for completion and help, in broken text too.

use crate::cell::computes;
use crate::lex::lex;
use crate::locale::Locale;
use crate::parse::body;
use crate::parse::brackets::{is_logical, is_plain_name};
use crate::place::Span;
use crate::token::{Bracket, Kind, Token};

/// What is being typed.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct Context {
    /// The part of a word before the caret; empty where no word is being typed.
    pub prefix: String,
    /// The whole word under the caret, which a completion replaces.
    pub word: Span,
    /// Whether a keyword may be typed here: at the start of an argument.
    pub starts_argument: bool,
    /// The innermost call around the caret, points and lists notwithstanding.
    pub call: Option<CallContext>,
}

/// The call around the caret.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CallContext {
    /// Its name as typed.
    pub name: String,
    /// Where the name stands.
    pub name_span: Span,
    /// Which argument the caret is in, counted from 0.
    pub argument: usize,
    /// The keyword of that argument, if it has one.
    pub keyword: Option<String>,
}

/// Tells what is being typed at a caret, a byte offset in the source of a cell. Nothing inside texts.
///
/// ```
/// use pforms_formula::{at, Locale};
/// let source = "=MIR(A1, frame(A2, kind: ro";
/// let context = at(source, source.len(), Locale::DecimalPoint);
/// assert_eq!(context.prefix, "ro");
/// let call = context.call.unwrap();
/// assert_eq!((call.name.as_str(), call.argument, call.keyword.as_deref()), ("frame", 1, Some("kind")));
/// ```
pub fn at(source: &str, caret: usize, locale: Locale) -> Context {
    let caret = floor_boundary(source, caret);
    if !computes(source, locale) || caret < body(source) {
        return Context { word: Span::new(caret, caret), ..Context::default() };
    }
    let tokens = lex(source, body(source), locale);
    let before: Vec<Token> = tokens.into_iter().take_while(|t| t.span.start < caret).collect();
    let (typed, before) = match before.split_last() {
        Some((last, rest)) if last.kind == Kind::Word && last.span.end >= caret => {
            (Some(*last), rest)
        }
        _ => (None, before.as_slice()),
    };
    let frames = frames(before);
    let word = typed.map_or(Span::new(caret, caret), |token| token.span);
    let in_text = before.last().is_some_and(|t| is_text_around(*t, caret));
    Context {
        prefix: Span::new(word.start, caret).of(source).into(),
        word,
        starts_argument: !in_text
            && frames.last().is_some_and(|f| f.name.is_some() && f.item.is_empty()),
        call: frames.iter().rev().find_map(|frame| frame.context(source)),
    }
}

/// A bracket that is open at the caret.
struct Frame {
    name: Option<Token>,
    argument: usize,
    /// The first two words of the current argument.
    item: Vec<Token>,
}

impl Frame {
    fn context(&self, source: &str) -> Option<CallContext> {
        let name_span = self.name?.span;
        let name = name_span.of(source).to_owned();
        let keyword = self.keyword(source, is_logical(&name));
        Some(CallContext { name, name_span, argument: self.argument, keyword })
    }

    fn keyword(&self, source: &str, logical: bool) -> Option<String> {
        let [word, mark] = self.item.as_slice() else { return None };
        let marked = mark.kind == Kind::Colon || (!logical && mark.span.of(source) == "=");
        let text = word.span.of(source);
        (word.kind == Kind::Word && marked && is_plain_name(text)).then(|| text.into())
    }
}

/// The brackets left open by these words, innermost last.
fn frames(tokens: &[Token]) -> Vec<Frame> {
    let mut frames: Vec<Frame> = Vec::new();
    let mut last: Option<Token> = None;
    for token in tokens {
        if let Some(frame) = frames.last_mut().filter(|f| f.item.len() < 2 && !token.ends_item()) {
            frame.item.push(*token);
        }
        match token.kind {
            Kind::Open(bracket) => {
                let name = last.filter(|t| bracket == Bracket::Round && t.kind == Kind::Word);
                frames.push(Frame { name, argument: 0, item: Vec::new() });
            }
            Kind::Close(_) => {
                frames.pop();
            }
            Kind::Comma | Kind::Semicolon => {
                if let Some(frame) = frames.last_mut() {
                    frame.argument += 1;
                    frame.item.clear();
                }
            }
            _ => {}
        }
        last = Some(*token);
    }
    frames
}

fn is_text_around(token: Token, caret: usize) -> bool {
    match token.kind {
        Kind::Text { closed } => caret < token.span.end || !closed,
        _ => false,
    }
}

fn floor_boundary(source: &str, caret: usize) -> usize {
    let mut caret = caret.min(source.len());
    while !source.is_char_boundary(caret) {
        caret -= 1;
    }
    caret
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The context at the `|` of a source.
    fn here(marked: &str) -> Context {
        let caret = marked.find('|').unwrap();
        at(&marked.replacen('|', "", 1), caret, Locale::DecimalPoint)
    }

    fn call(marked: &str) -> (String, usize, Option<String>) {
        let call = here(marked).call.unwrap();
        (call.name, call.argument, call.keyword)
    }

    #[test]
    fn words_are_found() {
        assert_eq!(here("=di|ag(A1)").prefix, "di");
        assert_eq!(here("=di|ag(A1)").word, Span::new(1, 5));
        assert_eq!(here("=élé|").prefix, "élé");
        assert_eq!(here("=|").prefix, "");
        assert_eq!(here("=A1 + |").prefix, "");
        assert_eq!(here("=\"sub|").prefix, "");
        assert_eq!(here("hello si|").prefix, "");
        assert_eq!(here("(1, sq|").prefix, "sq");
        assert_eq!(at("=é", 2, Locale::DecimalPoint).prefix, "");
        assert_eq!(at("=ab", 99, Locale::DecimalPoint).prefix, "ab");
    }

    #[test]
    fn the_innermost_call_and_its_argument() {
        assert_eq!(call("=MIR(A1, [(1, 2), (|"), ("MIR".into(), 1, None));
        assert_eq!(call("=F(1, G(2), | )"), ("F".into(), 2, None));
        assert_eq!(call("=F(1, kind = \"a|"), ("F".into(), 1, Some("kind".into())));
        assert_eq!(call("=IF(x = |"), ("IF".into(), 0, None));
        assert_eq!(call("=F(A1: |"), ("F".into(), 0, None));
        assert_eq!(here("=F(1)|").call, None);
        assert_eq!(here("=F|(1)").call, None);
    }

    #[test]
    fn keywords_are_offered_at_the_start_of_arguments() {
        assert!(here("=F(|").starts_argument);
        assert!(here("=F(1, ki|").starts_argument);
        assert!(!here("=F(1 + |").starts_argument);
        assert!(!here("=F([|").starts_argument);
        assert!(!here("=F(\"a|").starts_argument);
    }
}
