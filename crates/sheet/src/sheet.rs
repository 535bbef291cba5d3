//! The sheet: a document that computes itself.

use std::collections::{BTreeMap, BTreeSet, VecDeque};

use pforms_catalogue::{Arithmetic, Language, Value};
use pforms_formula::{Address, Content, Locale, classify};
use pforms_kernel::{Error, Result};

use crate::cancel::system_clock;
use crate::cell::Cell;
use crate::evaluate::Surroundings;
use crate::graph::{Graph, Stage};
use crate::history::History;
use crate::name::folded;
use crate::{Cancel, Clock, Document, Edit, Info, Target, pfs};

/// Cells that recalculate, in floating (`f64`) or exact (`Rational`) arithmetic.
///
/// Changing a cell marks what depends on it; [`Sheet::recalculate`] computes that and nothing
/// else. Errors are values: they flow, and name the cell they started in.
///
/// ```
/// use pforms_sheet::Sheet;
/// let mut sheet: Sheet = Sheet::new();
/// sheet.set("A1".parse()?, "2");
/// sheet.set("A2".parse()?, "=1/A1");
/// sheet.recalculate_all();
/// assert_eq!(sheet.info("A2".parse()?, Default::default()).text, "0.5");
/// sheet.undo();
/// assert_eq!(sheet.document().text("A2".parse()?), "");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Sheet<S = f64> {
    pub(crate) document: Document,
    pub(crate) history: History,
    pub(crate) graph: Graph,
    pub(crate) cells: BTreeMap<Address, Cell<S>>,
    /// Cells to be computed; with every cell, all that depends on it.
    pub(crate) dirty: BTreeSet<Address>,
    /// The order in which to compute them; empty when it must be made anew.
    pub(crate) plan: VecDeque<Stage>,
    pub(crate) clock: Option<Clock>,
    nothing: Value<S>,
}

impl<S: Arithmetic> Default for Sheet<S> {
    fn default() -> Self {
        Document::default().into()
    }
}

impl<S: Arithmetic> From<Document> for Sheet<S> {
    /// The sheet of a document; nothing is computed yet.
    fn from(document: Document) -> Self {
        Self::of(document, History::default())
    }
}

impl<S: Arithmetic> Sheet<S> {
    /// An empty sheet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Reads a sheet from the text of a `.pfs` file; nothing is computed yet.
    ///
    /// Errors: `Format` with line and column, see [`pfs::read`].
    pub fn open(text: &str) -> Result<Self> {
        Ok(pfs::read(text)?.into())
    }

    /// The text of a `.pfs` file that holds this sheet.
    pub fn save(&self) -> String {
        pfs::write(&self.document)
    }

    pub(crate) fn of(document: Document, history: History) -> Self {
        let mut sheet = Self {
            document,
            history,
            graph: Graph::default(),
            cells: BTreeMap::new(),
            dirty: BTreeSet::new(),
            plan: VecDeque::new(),
            clock: system_clock(),
            nothing: Value::Empty,
        };
        let all: Vec<Address> = sheet.document.cells().map(|(at, _)| at).collect();
        for &at in &all {
            sheet.understand(at);
        }
        sheet.dirty.extend(all);
        sheet
    }

    /// What the sheet says, apart from what it computes.
    pub fn document(&self) -> &Document {
        &self.document
    }

    /// The clock by which costs and budgets are measured. On a page there is none until it is set.
    pub fn set_clock(&mut self, clock: Clock) {
        self.clock = Some(clock);
    }

    /// The value of a cell as last computed.
    pub fn value(&self, at: Address) -> &Value<S> {
        self.cells.get(&at).map_or(&self.nothing, |cell| &cell.value)
    }

    /// The value of an address, a range or a name, as last computed.
    ///
    /// Errors: `Format` when `place` is none of them. A range with gaps has an error for its value.
    pub fn get(&self, place: &str) -> Result<Value<S>> {
        Ok(match self.locate(place)? {
            Target::Cell(at) => self.value(at).clone(),
            Target::Cells(range) => {
                self.around(&Cancel::new()).rows(&range).map(Value::list).into()
            }
        })
    }

    /// What an address, a range or a name stands for.
    ///
    /// Errors: `Format` when `place` is none of them.
    pub fn locate(&self, place: &str) -> Result<Target> {
        if let Some(target) = self.document.target(place) {
            return Ok(target);
        }
        Target::read(place).map_err(|_| {
            let shown: String = place.chars().take(40).collect();
            Error::format("sheet", None, format!("{shown:?} is neither a cell nor a name of it"))
        })
    }

    /// A cell as it is shown in a language.
    pub fn info(&self, at: Address, language: Language) -> Info {
        let value = self.value(at);
        Info {
            source: self.document.text(at).to_owned(),
            text: value.display(language),
            kind: value.kind(language),
            error: value.failure().cloned(),
            cost: self.cells.get(&at).map(|cell| cell.cost.clone()).unwrap_or_default(),
            pending: self.dirty.contains(&at),
        }
    }

    /// The cells that are not empty, column by column.
    pub fn addresses(&self) -> impl Iterator<Item = Address> {
        self.cells.keys().copied()
    }

    /// The cells that must be computed again.
    pub fn pending(&self) -> impl Iterator<Item = Address> {
        self.dirty.iter().copied()
    }

    pub(crate) fn around<'a>(&'a self, cancel: &'a Cancel) -> Surroundings<'a, S> {
        let interrupted = std::cell::Cell::new(false);
        let Self { document, cells, graph, .. } = self;
        Surroundings { document, cells, graph, cancel, interrupted }
    }

    /// Takes note of edits that were made to the document.
    pub(crate) fn absorb(&mut self, edits: &[Edit]) {
        let mut touched = BTreeSet::new();
        for edit in edits {
            match edit {
                Edit::Cell { at, .. } => {
                    self.understand(*at);
                    touched.insert(*at);
                }
                Edit::Name { name, .. } => {
                    let users: Vec<Address> = self.graph.users_of_name(&folded(name)).collect();
                    for at in users {
                        self.connect(at);
                        touched.insert(at);
                    }
                }
                _ => {}
            }
        }
        if !touched.is_empty() {
            self.graph.spread(touched, &mut self.dirty);
            self.plan.clear();
        }
    }

    /// Reads the text of a cell anew; the value stays until the cell is computed.
    fn understand(&mut self, at: Address) {
        match classify(self.document.text(at), Locale::DecimalPoint) {
            Content::Empty => {
                self.cells.remove(&at);
            }
            content => match self.cells.get_mut(&at) {
                Some(cell) => cell.content = content,
                None => {
                    self.cells.insert(at, Cell::new(content));
                }
            },
        }
        self.connect(at);
    }

    fn connect(&mut self, at: Address) {
        let mentions = self.cells.get(&at).map(|cell| cell.mentions(&self.document));
        self.graph.link(at, mentions.unwrap_or_default());
    }
}
