//! What a cell holds, told from its source text.

use crate::lex::{is_space, lex};
use crate::locale::Locale;
use crate::parse::{parse, parse_literal};
use crate::problem::Problem;
use crate::token::{Kind, Token};
use crate::tree::{Expression, Tree};

/// What a cell holds. The places of a tree count from the start of the source of the cell.
#[derive(Clone, Debug, PartialEq)]
pub enum Content {
    /// Nothing but space.
    Empty,
    /// A number, point or list given by itself. It names no cells: those are errors in the tree.
    Literal(Tree),
    /// A formula, begun by `=`.
    Formula(Tree),
    /// Anything else, or what follows a leading `'`.
    Text(String),
}

/// Tells what the source text of a cell is.
///
/// - `=…` is a formula, `'…` is text.
/// - What begins with a bracket, a digit, a sign or a decimal mark and parses as a value is a literal. It may compute
///   (`sqrt(2)/2`, `1/3`, `2*pi`) but not with other cells.
/// - What begins as a point or a list is a literal even if it has errors, so that they are seen.
/// - All the rest is text.
///
/// ```
/// use pforms_formula::{classify, Content, Locale};
/// let kind = |source| classify(source, Locale::DecimalPoint);
/// assert!(matches!(kind("(1, 0, sqrt(2)/2)"), Content::Literal(tree) if !tree.has_errors()));
/// assert!(matches!(kind("(1, 0"), Content::Literal(tree) if tree.has_errors()));
/// assert_eq!(kind("2 towers"), Content::Text("2 towers".into()));
/// assert_eq!(kind("'=A1"), Content::Text("=A1".into()));
/// ```
pub fn classify(source: &str, locale: Locale) -> Content {
    let trimmed = source.trim_start_matches(is_space);
    let Some(first) = trimmed.chars().next() else { return Content::Empty };
    if let Some(text) = trimmed.strip_prefix('\'') {
        return Content::Text(text.into());
    }
    if first == '=' {
        return Content::Formula(parse(source, locale));
    }
    if !may_be_literal(first, locale) {
        return Content::Text(source.into());
    }
    let tree = parse_literal(source, locale);
    if !tree.has_errors() || is_broken_literal(&tree) {
        return Content::Literal(tree);
    }
    Content::Text(source.into())
}

/// Whether words in a cell of this source are part of an expression rather than of a text.
pub(crate) fn computes(source: &str, locale: Locale) -> bool {
    let first = source.trim_start_matches(is_space).chars().next();
    first.is_some_and(|c| c == '=' || may_be_literal(c, locale))
}

fn may_be_literal(first: char, locale: Locale) -> bool {
    matches!(first, '(' | '[' | '+' | '-' | '−' | '–' | '.' | '0'..='9') || first == locale.mark()
}

/// Whether a source with errors was meant as a point or a list rather than as text.
fn is_broken_literal(tree: &Tree) -> bool {
    let tokens = lex(&tree.source, 0, tree.locale);
    let opened = tokens.iter().take_while(|t| matches!(t.kind, Kind::Open(_))).count();
    opened > 0
        && (only_names_cells(tree) || tokens.get(opened).is_some_and(|t| begins_value(tree, *t)))
}

/// Whether it is a sound point or list but for the cells it names.
fn only_names_cells(tree: &Tree) -> bool {
    let holds =
        matches!(tree[tree.root()].expression, Expression::Point { .. } | Expression::List(_));
    holds && tree.errors().all(|(_, fault)| matches!(fault.problem, Problem::ReferenceInLiteral(_)))
}

/// Whether a word after the opening brackets belongs to a value; a name belongs to prose.
fn begins_value(tree: &Tree, token: Token) -> bool {
    let word = token.span.of(&tree.source);
    match token.kind {
        Kind::Word => {
            let rest = tree.source[token.span.end..].trim_start_matches(is_space);
            rest.starts_with('(') || crate::Reference::read(word).is_some()
        }
        Kind::Unknown | Kind::Text { .. } => false,
        _ => true,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kind(source: &str) -> &'static str {
        match classify(source, Locale::DecimalPoint) {
            Content::Empty => "empty",
            Content::Literal(tree) if tree.has_errors() => "broken",
            Content::Literal(_) => "literal",
            Content::Formula(_) => "formula",
            Content::Text(_) => "text",
        }
    }

    #[test]
    fn every_kind_of_cell() {
        for source in ["", "  ", "\u{a0}\n"] {
            assert_eq!(kind(source), "empty", "{source:?}");
        }
        for source in [
            "1",
            "-1.5",
            "−2",
            "+3",
            ".5",
            "1/3",
            "2*PI",
            "sqrt(2)",
            "(1,0;0.5)",
            " [1, [2]] ",
            "[]",
            "(pi, 0)",
        ] {
            let expected = if source == "sqrt(2)" { "text" } else { "literal" };
            assert_eq!(kind(source), expected, "{source:?}");
        }
        for source in [
            "(1, 0",
            "(1,,2)",
            "[(1,0), (1,1]",
            "(A1, 2)",
            "[A1:B2]",
            "(x, y)",
            "((",
            "()",
            "(sqrt(2, 1",
        ] {
            assert_eq!(kind(source), "broken", "{source:?}");
        }
        for source in [
            "A1", "hello", "(hello)", "(see A1)", "2 towers", "- note", "...", "-", "1+A1", "'12",
            "TRUE", "\"q\"",
        ] {
            assert_eq!(kind(source), "text", "{source:?}");
        }
        for source in ["=", "=1", "  = A1", "=)("] {
            assert_eq!(kind(source), "formula", "{source:?}");
        }
    }

    #[test]
    fn commas_decide_by_locale() {
        assert!(matches!(classify("1,5", Locale::DecimalComma), Content::Literal(_)));
        assert!(matches!(classify(",5", Locale::DecimalComma), Content::Literal(_)));
        assert!(matches!(classify("1,5", Locale::DecimalPoint), Content::Text(_)));
    }
}
