//! Points of literals, changed in place as they are dragged.

use crate::locale::Locale;
use crate::number::decimal;
use crate::parse::parse;
use crate::place::Span;
use crate::rewrite::edited;
use crate::tree::{Expression, NodeId, Tree};

/// The points of nested lists: the path of list indices that leads to each, and where it stands, in order.
///
/// A tree that is a single point has the empty path. Points inside calls or sums are not listed.
pub fn point_spans(tree: &Tree) -> Vec<(Vec<usize>, Span)> {
    let mut found = Vec::new();
    let mut waiting = vec![(Vec::new(), tree.root())];
    while let Some((path, id)) = waiting.pop() {
        match &tree[id].expression {
            Expression::Point { .. } => found.push((path, tree[id].span)),
            Expression::List(items) => {
                let inner =
                    |(index, item): (usize, &NodeId)| ([path.as_slice(), &[index]].concat(), *item);
                waiting.extend(items.iter().enumerate().map(inner).rev());
            }
            _ => {}
        }
    }
    found
}

/// Gives new coordinates to the point at a path of list indices; weight, spacing and all other text stay.
///
/// `None` as a coordinate keeps its text, and so does a value the coordinate already has as a plain number. The
/// source is in the form of files, with a decimal point. The answer is `None` if there is no point at the path, the
/// number of coordinates differs, a value is not finite, or the source has errors.
///
/// ```
/// use pforms_formula::replace_point;
/// let source = "[(1,0, 0), (sqrt(2)/2 , 1,0; 0.5)]";
/// let moved = replace_point(source, &[1], &[None, Some(0.25), Some(0.0)]);
/// assert_eq!(moved.as_deref(), Some("[(1,0, 0), (sqrt(2)/2 , 0.25,0; 0.5)]"));
/// ```
pub fn replace_point(source: &str, path: &[usize], coordinates: &[Option<f64>]) -> Option<String> {
    let tree = parse(source, Locale::DecimalPoint);
    let Expression::Point { coordinates: old, .. } = &tree[find(&tree, path)?].expression else {
        return None;
    };
    if tree.has_errors() || old.len() != coordinates.len() {
        return None;
    }
    let mut edits = Vec::new();
    for (id, new) in old.iter().zip(coordinates) {
        match new {
            Some(value) if !value.is_finite() => return None,
            Some(value) if plain(tree.text(*id)) != Some(*value) => {
                edits.push((tree[*id].span, decimal(*value)));
            }
            _ => {}
        }
    }
    Some(edited(source, &edits))
}

fn find(tree: &Tree, path: &[usize]) -> Option<NodeId> {
    path.iter().try_fold(tree.root(), |id, index| match &tree[id].expression {
        Expression::List(items) => items.get(*index).copied(),
        _ => None,
    })
}

/// The value of a text that is nothing but a number with or without sign.
fn plain(text: &str) -> Option<f64> {
    text.ends_with(|c: char| c.is_ascii_digit() || c == '.')
        .then(|| text.replace('−', "-").parse().ok())?
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_listed_with_their_paths() {
        let source = "[[(1,0),(2,0)], (3,), 4, [[(5,6;7)]]]";
        let tree = parse(source, Locale::DecimalPoint);
        let found: Vec<_> =
            point_spans(&tree).into_iter().map(|(path, span)| (path, span.of(source))).collect();
        let expected = [
            (vec![0, 0], "(1,0)"),
            (vec![0, 1], "(2,0)"),
            (vec![1], "(3,)"),
            (vec![3, 0, 0], "(5,6;7)"),
        ];
        assert_eq!(found, expected);
    }

    #[test]
    fn only_what_moved_is_rewritten() {
        let all = |x, y| [Some(x), Some(y)];
        let moved = |source, x, y| replace_point(source, &[], &all(x, y));
        assert_eq!(moved("( 1.0 , −2e0; 1/3)", 1.0, -2.0).as_deref(), Some("( 1.0 , −2e0; 1/3)"));
        assert_eq!(moved("(1/2, (3))", 0.1, -0.0).as_deref(), Some("(0.1, (0))"));
        assert_eq!(moved("(1, 2)", f64::NAN, 0.0), None);
        assert_eq!(moved("(1, 2, 3)", 0.0, 0.0), None);
        assert_eq!(moved("(1, 2", 0.0, 0.0), None);
        assert_eq!(replace_point("[(1,2)]", &[1], &all(0.0, 0.0)), None);
        assert_eq!(replace_point("[(1,2)]", &[0, 0], &all(0.0, 0.0)), None);
    }
}
