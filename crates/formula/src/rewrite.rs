//! Changing the cells and names of a formula while all other text stays.

use crate::cell::{Content, classify};
use crate::locale::Locale;
use crate::place::Span;
use crate::reference::Reference;
use crate::tree::{Expression, Tree};

/// Whether two names mean the same: capitals do not count.
pub fn same_name(a: &str, b: &str) -> bool {
    a == b || a.to_lowercase() == b.to_lowercase()
}

/// The source of a cell as it reads in a copy so many columns to the right and rows down. `$` fixes a part.
///
/// Sources that are not formulas are copied as they are. `None` if a cell would leave the sheet.
///
/// ```
/// use pforms_formula::shift;
/// assert_eq!(shift("= MIR(A1, $A1, A$1:B2)", 1, 2).as_deref(), Some("= MIR(B3, $A3, B$1:C4)"));
/// assert_eq!(shift("=A1", -1, 0), None);
/// ```
pub fn shift(source: &str, columns: i64, rows: i64) -> Option<String> {
    map_references(source, |cell| cell.shifted(columns, rows))
}

/// The source of a cell with every reference replaced, corners of ranges included. `None` if any replacement is.
pub fn map_references(
    source: &str,
    replace: impl Fn(Reference) -> Option<Reference>,
) -> Option<String> {
    let Some(tree) = formula(source) else { return Some(source.into()) };
    let mut edits = Vec::new();
    for node in tree.nodes() {
        let corners = match &node.expression {
            Expression::CellRef(cell) => vec![(node.span, *cell)],
            Expression::Range(range) => {
                corner_spans(&tree, node.span).into_iter().zip([range.first, range.last]).collect()
            }
            _ => continue,
        };
        for (span, cell) in corners {
            let new = replace(cell)?;
            if new != cell {
                edits.push((span, new.to_string()));
            }
        }
    }
    Some(edited(source, &edits))
}

/// The source of a cell with a name or a cell called by another name or address.
///
/// `from` and `to` are each an address or a name. A cell keeps its `$` when it becomes another cell. Ranges stay
/// as they are, and so do keywords and names of functions. Anything but a formula stays as it is.
///
/// ```
/// use pforms_formula::rename_reference;
/// assert_eq!(rename_reference("=DIAG(Octant) + $B$2", "octant", "sphere"), "=DIAG(sphere) + $B$2");
/// assert_eq!(rename_reference("=DIAG(Octant) + $B$2", "B2", "C7"), "=DIAG(Octant) + $C$7");
/// ```
pub fn rename_reference(source: &str, from: &str, to: &str) -> String {
    let Some(tree) = formula(source) else { return source.into() };
    let (old, new) = (Reference::read(from), Reference::read(to));
    let mut edits = Vec::new();
    for node in tree.nodes() {
        match (&node.expression, old, new) {
            (Expression::CellRef(cell), Some(old), Some(new)) if cell.address == old.address => {
                let moved = Reference { address: new.address, ..*cell };
                edits.push((node.span, moved.to_string()));
            }
            (Expression::CellRef(cell), Some(old), None) if cell.address == old.address => {
                edits.push((node.span, to.into()));
            }
            (Expression::Name(name), None, _) if same_name(name, from) => {
                edits.push((node.span, to.into()));
            }
            _ => {}
        }
    }
    edited(source, &edits)
}

fn formula(source: &str) -> Option<Tree> {
    match classify(source, Locale::DecimalPoint) {
        Content::Formula(tree) => Some(tree),
        _ => None,
    }
}

/// Where the two corners of a range stand.
fn corner_spans(tree: &Tree, span: Span) -> [Span; 2] {
    let text = span.of(tree.source());
    let end = span.start
        + text.find(|c: char| c != '$' && !c.is_ascii_alphanumeric()).unwrap_or(text.len());
    let start = span.start
        + text.rfind(|c: char| c != '$' && !c.is_ascii_alphanumeric()).map_or(0, |at| at + 1);
    [Span::new(span.start, end), Span::new(start, span.end)]
}

/// The source with stretches replaced; edits come in order and do not overlap.
pub(crate) fn edited(source: &str, edits: &[(Span, String)]) -> String {
    let mut text = String::with_capacity(source.len());
    let mut end = 0;
    for (span, replacement) in edits {
        text.push_str(&source[end..span.start]);
        text.push_str(replacement);
        end = span.end;
    }
    text.push_str(&source[end..]);
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_formulas_shift() {
        assert_eq!(shift("(1, 2)", 1, 1).as_deref(), Some("(1, 2)"));
        assert_eq!(shift("see A1", 1, 1).as_deref(), Some("see A1"));
        assert_eq!(
            shift("=LOG10(A1) + \"A1\" + a1 : b2 #", 1, 1).as_deref(),
            Some("=LOG10(B2) + \"A1\" + B2 : C3 #")
        );
        assert_eq!(
            shift("=A1:B2\u{200b}:\u{200b}A1", 0, 1).as_deref(),
            Some("=A2:B3\u{200b}:\u{200b}A2")
        );
    }

    #[test]
    fn names_are_told_from_keywords_and_functions() {
        assert_eq!(rename_reference("=r(r, r: r, r=r) + R", "r", "A1"), "=r(A1, r: A1, r=A1) + A1");
        assert_eq!(rename_reference("=A1 + A1:A2", "a1", "start"), "=start + A1:A2");
    }
}
