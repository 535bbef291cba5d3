//! What the sheet knows of one cell: its text as understood, its value, and what that cost.

use pforms_catalogue::{Arithmetic, Failure, Value};
use pforms_formula::{Address, Content, Range, References, Tree, references};
use serde::Serialize;

use crate::Document;
use crate::graph::Mentions;
use crate::{Target, name::folded};

/// A cell that is not empty.
#[derive(Clone, Debug)]
pub(crate) struct Cell<S> {
    pub(crate) content: Content,
    pub(crate) value: Value<S>,
    pub(crate) cost: Cost,
}

/// What computing a cell took, and what its value occupies.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Cost {
    /// Seconds; none without a clock.
    pub seconds: Option<f64>,
    /// Orders of the form, along each of its axes; none when it is no form.
    pub orders: Option<Vec<usize>>,
    /// Bytes of its numbers.
    pub bytes: usize,
}

/// A cell as it is shown.
#[derive(Clone, Debug)]
pub struct Info {
    /// The text that was typed.
    pub source: String,
    /// The short text of its value.
    pub text: String,
    /// What its value is, in a word: `number`, `point`, `pS33`, `error`.
    pub kind: String,
    /// What went wrong, and where it started.
    pub error: Option<Failure>,
    /// What it cost.
    pub cost: Cost,
    /// Must it be computed again? Then the rest is about what it was.
    pub pending: bool,
}

impl<S: Arithmetic> Cell<S> {
    /// A cell that has not been computed.
    pub(crate) fn new(content: Content) -> Self {
        Self { content, value: Value::Empty, cost: Cost::default() }
    }

    /// A cell of which only the value counts.
    pub(crate) fn computed(value: Value<S>) -> Self {
        Self { content: Content::Empty, value, cost: Cost::default() }
    }

    /// What the cell depends on, names looked up.
    pub(crate) fn mentions(&self, document: &Document) -> Mentions {
        let Content::Formula(tree) = &self.content else { return Mentions::default() };
        let Mentioned { cells, ranges, names } = Mentioned::by(tree, document);
        let mut mentions = Mentions { cells: cells.into_iter().collect(), ..Mentions::default() };
        for range in &ranges {
            mentions.add_range(range);
        }
        mentions.names.extend(names.iter().map(|name| folded(name)));
        mentions
    }
}

/// The cells and ranges a tree mentions, by address or by name.
pub(crate) struct Mentioned {
    pub(crate) cells: Vec<Address>,
    pub(crate) ranges: Vec<Range>,
    names: Vec<String>,
}

impl Mentioned {
    pub(crate) fn by(tree: &Tree, document: &Document) -> Self {
        let References { mut cells, mut ranges, names } = references(tree);
        for name in &names {
            match document.target(name) {
                Some(Target::Cell(at)) => cells.push(at),
                Some(Target::Cells(range)) => ranges.push(range),
                None => {}
            }
        }
        Self { cells, ranges, names }
    }
}
