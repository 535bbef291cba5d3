//! A cell as the page shows it.

use pforms_catalogue::{Failure, Language, Value};
use pforms_formula::{Address, Content, Tree, classify, references};
use pforms_sheet::{Sheet, Target};
use serde::Serialize;

use crate::assist::{Diagnostic, mistakes, shown, strangers};
use crate::cost::Cost;
use crate::place::locale;

/// Cells of a range that are outlined as read by a formula.
const OUTLINED: usize = 200;

/// Longest short text of a value.
const TEXT: usize = 400;

/// A cell as it is shown in one language.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CellInfo {
    /// `A1`.
    pub address: String,
    /// What a person typed, decimals as the language writes them.
    pub source: String,
    /// The value in short.
    pub text: String,
    /// What the value is, in a word of the language.
    pub kind: String,
    /// What the value is, in no language.
    pub sort: &'static str,
    /// Why there is no value.
    pub error: Option<CellError>,
    /// What it cost.
    pub cost: Option<Cost>,
    /// The name it goes by.
    pub name: Option<String>,
    /// Cells its formula reads.
    pub reads: Vec<String>,
    /// Must it be computed yet?
    pub pending: bool,
}

/// Why a cell has no value.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CellError {
    /// What happened.
    pub message: String,
    /// What to do about it.
    pub hint: Option<String>,
    /// First unit of the wrong place in the source of this cell.
    pub from: Option<usize>,
    /// One past its last unit.
    pub to: Option<usize>,
    /// The cell it came from, when that is another one.
    pub origin: Option<String>,
}

impl CellInfo {
    pub(crate) fn of(sheet: &Sheet, at: Address, language: Language) -> Self {
        let info = sheet.info(at, language);
        let source = shown(&info.source, language);
        let tree = tree(&source, language);
        let cost = Cost::of(&info.cost, language);
        Self {
            address: at.to_string(),
            text: shortened(&in_words(&info.text, sheet.value(at), language)),
            kind: info.kind,
            sort: sort(sheet.value(at)),
            error: info.error.map(|failure| error(&failure, at, &source, tree.as_ref(), language)),
            cost: (!info.pending).then_some(cost),
            name: name(sheet, at),
            reads: tree.map_or(Vec::new(), |tree| reads(sheet, &tree)),
            pending: info.pending,
            source,
        }
    }
}

fn tree(source: &str, language: Language) -> Option<Tree> {
    match classify(source, locale(language)) {
        Content::Literal(tree) | Content::Formula(tree) => Some(tree),
        Content::Empty | Content::Text(_) => None,
    }
}

fn sort(value: &Value) -> &'static str {
    match value {
        Value::Empty => "empty",
        Value::Number(_) => "number",
        Value::Boolean(_) => "boolean",
        Value::Text(_) => "text",
        Value::Form(_) | Value::Spline(_) | Value::Immersed(_) => "form",
        Value::Mesh(_) => "mesh",
        Value::List(_) => "list",
        Value::Record(_) => "record",
        Value::Error(_) => "error",
    }
}

/// The failure with its place: where the syntax is wrong, or where an unknown operator is called.
fn error(
    failure: &Failure,
    at: Address,
    source: &str,
    tree: Option<&Tree>,
    language: Language,
) -> CellError {
    let here = at.to_string();
    let origin = failure.origin().filter(|origin| *origin != here);
    let place = tree.filter(|_| origin.is_none()).and_then(|tree| first(tree, source, language));
    CellError {
        message: failure.message(language).to_owned(),
        hint: failure.hint(language).map(str::to_owned),
        from: place.as_ref().map(|wrong| wrong.place.from),
        to: place.as_ref().map(|wrong| wrong.place.to),
        origin: origin.map(str::to_owned),
    }
}

fn first(tree: &Tree, source: &str, language: Language) -> Option<Diagnostic> {
    let wrong = mistakes(tree, source, language).into_iter().next();
    wrong.or_else(|| strangers(tree, source, language).into_iter().next())
}

fn name(sheet: &Sheet, at: Address) -> Option<String> {
    let own = |target: Target| matches!(target, Target::Cell(cell) if cell == at);
    sheet.document().names().find(|(_, target)| own(*target)).map(|(name, _)| name.to_owned())
}

/// The cells a formula mentions, those of ranges and of names too.
fn reads(sheet: &Sheet, tree: &Tree) -> Vec<String> {
    let mentioned = references(tree);
    let mut cells: Vec<Address> = mentioned.cells.into_iter().collect();
    let mut ranges: Vec<_> = mentioned.ranges.into_iter().collect();
    for name in &mentioned.names {
        match sheet.document().target(name) {
            Some(Target::Cell(at)) => cells.push(at),
            Some(Target::Cells(range)) => ranges.push(range),
            None => {}
        }
    }
    cells.extend(ranges.iter().flat_map(|range| range.cells().take(OUTLINED)));
    cells.truncate(OUTLINED);
    cells.iter().map(ToString::to_string).collect()
}

/// Numbers, points and lists are written as they are typed in the language; words stay.
fn in_words(text: &str, value: &Value, language: Language) -> String {
    match value {
        Value::Number(_) | Value::Form(_) | Value::List(_) => shown(text, language),
        _ => text.to_owned(),
    }
}

fn shortened(text: &str) -> String {
    if text.chars().nth(TEXT).is_none() {
        return text.to_owned();
    }
    text.chars().take(TEXT).chain(['…']).collect()
}
