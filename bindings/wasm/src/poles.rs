//! Poles of literal cells: what can be dragged, and typed, in the view.

use pforms_catalogue::{Language, Value};
use pforms_formula::{
    Address, Content, Expression, Locale, NodeId, Tree, classify, convert, point_spans,
};
use pforms_sheet::Sheet;
use serde::Serialize;

use crate::Problem;
use crate::assist::shown;
use crate::place::locale;

/// A net of more poles than this is not dragged but typed: nobody takes hold of one among so many.
const DRAGGED: usize = 4096;

/// A pole of a literal cell.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Pole {
    /// Its place in the net.
    pub index: Vec<usize>,
    /// Where it is drawn; none for a direction.
    pub position: Option<[f64; 3]>,
    /// Its coordinates as they stand in the cell.
    pub coordinates: Vec<String>,
    /// Its weight as it stands in the cell, `1` when it does not.
    pub weight: String,
}

/// The net of poles of a literal cell.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Poles {
    /// The cell.
    pub address: String,
    /// Orders of the net; none for a single point.
    pub orders: Vec<usize>,
    /// The poles, last index fastest.
    pub poles: Vec<Pole>,
}

impl Poles {
    /// The poles of a cell that holds a net of at most [`DRAGGED`] points; `None` for any other.
    pub(crate) fn of(sheet: &Sheet, at: Address, language: Language) -> Option<Self> {
        let Value::Form(form) = sheet.value(at) else { return None };
        if form.pole_count() > DRAGGED {
            return None;
        }
        let editable = sheet.editable_poles(at);
        if editable.is_empty() || editable.len() != form.pole_count() {
            return None;
        }
        let tree = literal(&shown(sheet.document().text(at), language), locale(language))?;
        let poles: Vec<Pole> = editable
            .into_iter()
            .filter_map(|index| {
                let (coordinates, weight) = texts(&tree, &index)?;
                let position = position(form.pole(&index).ok()?);
                Some(Pole { index, position, coordinates, weight })
            })
            .collect();
        Some(Self { address: at.to_string(), orders: form.orders().to_vec(), poles })
    }
}

/// The three coordinates that are seen of a homogeneous pole.
fn position(pole: &[f64]) -> Option<[f64; 3]> {
    let (weight, point) = pole.split_last()?;
    let at = |axis: usize| point.get(axis).map_or(0.0, |x| x / weight);
    (*weight != 0.0).then(|| [at(0), at(1), at(2)])
}

fn literal(source: &str, locale: Locale) -> Option<Tree> {
    match classify(source, locale) {
        Content::Literal(tree) => Some(tree),
        _ => None,
    }
}

fn node(tree: &Tree, index: &[usize]) -> Option<NodeId> {
    index.iter().try_fold(tree.root(), |id, at| match &tree[id].expression {
        Expression::List(items) => items.get(*at).copied(),
        _ => None,
    })
}

fn texts(tree: &Tree, index: &[usize]) -> Option<(Vec<String>, String)> {
    let Expression::Point { coordinates, weight } = &tree[node(tree, index)?].expression else {
        return None;
    };
    let text = |id: &NodeId| tree.text(*id).to_owned();
    let weight = weight.as_ref().map_or("1".to_owned(), text);
    Some((coordinates.iter().map(text).collect(), weight))
}

/// A coordinate on the grid of a step, as the shortest decimal; `old` when the step cannot tell them apart.
pub(crate) fn rounded(new: f64, old: Option<f64>, step: f64) -> f64 {
    let usable = step.is_finite() && step > 0.0;
    if let Some(old) = old.filter(|old| usable && (new - old).abs() < step / 2.0) {
        return old;
    }
    if !usable || !new.is_finite() {
        return new;
    }
    let digits = (-step.log10().floor()).clamp(0.0, 17.0) as usize;
    format!("{:.digits$}", (new / step).round() * step).parse().unwrap_or(new)
}

/// The source of a literal with one point typed anew; `texts` are its coordinates, its weight last.
pub(crate) fn retyped(
    source: &str,
    index: &[usize],
    texts: &[String],
    language: Language,
) -> Result<String, Problem> {
    let missing = || Problem::new(language, "there is no such pole", "ce pôle n'existe pas");
    let tree = literal(source, Locale::DecimalPoint).ok_or_else(missing)?;
    let spans = point_spans(&tree);
    let (_, span) = spans.iter().find(|(path, _)| path == index).ok_or_else(missing)?;
    let (weight, coordinates) = texts.split_last().ok_or_else(missing)?;
    let coordinates =
        coordinates.iter().map(|text| number(text, language)).collect::<Result<Vec<_>, _>>()?;
    let weight = number(weight, language)?;
    let weight = if weight == "1" { String::new() } else { format!("; {weight}") };
    let comma = if coordinates.len() == 1 && weight.is_empty() { "," } else { "" };
    let point = format!("({}{comma}{weight})", coordinates.join(", "));
    Ok(format!("{}{point}{}", &source[..span.start], &source[span.end..]))
}

/// One typed number or calculation, as files hold it.
fn number(text: &str, language: Language) -> Result<String, Problem> {
    let filed = convert(&format!("={}", text.trim()), locale(language), Locale::DecimalPoint);
    let sound = matches!(classify(&filed, Locale::DecimalPoint), Content::Formula(tree) if !tree.has_errors());
    match filed.strip_prefix('=') {
        Some(filed) if sound => Ok(filed.to_owned()),
        _ => {
            let shown: String = text.chars().take(30).collect();
            Err(Problem::new(
                language,
                format!("“{shown}” is not a number"),
                format!("« {shown} » n'est pas un nombre"),
            ))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_drag_writes_short_numbers_and_leaves_the_rest_alone() {
        assert_eq!(rounded(0.300_000_001, Some(0.5), 0.1), 0.3);
        assert_eq!(rounded(0.707_2, Some(0.5_f64.sqrt()), 0.01), 0.5_f64.sqrt());
        assert_eq!(rounded(12.4, None, 5.0), 10.0);
        assert_eq!(rounded(0.123, None, 0.0), 0.123);
        assert_eq!(rounded(-0.000_1, None, 0.01), 0.0);
    }

    #[test]
    fn typed_coordinates_stay_as_typed() {
        let texts = |texts: &[&str]| texts.iter().map(ToString::to_string).collect::<Vec<_>>();
        let source = "[(1, 0), (2,  3; 0.5)]";
        let typed = retyped(source, &[1], &texts(&["sqrt(2)/2", "-1", "1"]), Language::English);
        assert_eq!(typed.unwrap(), "[(1, 0), (sqrt(2)/2, -1)]");
        let typed = retyped(source, &[0], &texts(&["0,5", "1", "1/3"]), Language::French);
        assert_eq!(typed.unwrap(), "[(0.5, 1; 1/3), (2,  3; 0.5)]");
        assert!(retyped(source, &[0], &texts(&["1", "2)", "1"]), Language::English).is_err());
        assert!(retyped(source, &[7], &texts(&["1", "2", "1"]), Language::English).is_err());
    }
}
