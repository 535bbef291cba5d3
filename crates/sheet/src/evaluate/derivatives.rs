//! Derivatives of a formula in the cells it comes from: what lies between is computed once more,
//! with numbers that remember what they come from.

use std::any::TypeId;
use std::cell::Cell as Flag;
use std::collections::{BTreeMap, BTreeSet};

use pforms_catalogue::{Arithmetic, Failure, Value, numbers, sources, traced};
use pforms_formula::{Address, Call, Content, Expression, Locale, NodeId, Tree, parse};
use pforms_kernel::{Error, Result, Sparse, Traced, derivatives, gradient};

use super::{Evaluator, Surroundings};
use crate::cell::{Cell, Mentioned};
use crate::graph::Stage;
use crate::{Cancel, Sheet, Target};

/// How the numbers of a result follow those of its sources.
///
/// The numbers of a form are the coordinates and the weight of each pole, in the order of the poles.
#[derive(Clone, Debug)]
pub struct Sensitivities {
    results: Vec<Traced>,
    sources: usize,
}

impl Sensitivities {
    /// How many numbers the result has.
    pub fn results(&self) -> usize {
        self.results.len()
    }

    /// The derivatives: a row for each number of the result, a column for each of the sources.
    ///
    /// Errors: `Domain` for a derivative that is not finite.
    pub fn matrix(&self) -> Result<Sparse> {
        derivatives(&self.results, self.sources)
    }

    /// The derivatives of a weighted sum of the results in every number of the sources, in one sweep
    /// back from the results.
    ///
    /// Errors: `Shape` unless there is a weight for each number of the result; `Domain` as above.
    pub fn gradient(&self, weights: &[f64]) -> Result<Vec<f64>> {
        gradient(&self.results, weights, self.sources)
    }
}

impl<S: Arithmetic> Sheet<S> {
    /// How a formula, written without its `=`, follows a cell, a name or a range.
    ///
    /// Only the formula and the cells between are computed again.
    ///
    /// Errors: those of the formula; `Shape` for values that hold no numbers and empty cells; `Domain`
    /// when an operator in between does not hand derivatives on, and in exact mode.
    ///
    /// ```
    /// use pforms_sheet::Sheet;
    /// let mut sheet: Sheet = Sheet::new();
    /// sheet.set("A1".parse()?, "3");
    /// sheet.set("A2".parse()?, "=A1^2");
    /// sheet.recalculate_all();
    /// let found = sheet.sensitivities("2*A2", "A1").map_err(|failure| failure.to_string())?;
    /// assert_eq!(found.matrix()?.entries(), [12.0]);
    /// assert_eq!(found.gradient(&[10.0])?, [120.0]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn sensitivities(
        &self,
        result: &str,
        source: &str,
    ) -> std::result::Result<Sensitivities, Failure> {
        let tree = parse(&format!("={result}"), Locale::DecimalPoint);
        if let Some((_, fault)) = tree.errors().next() {
            return Err(super::misread(fault));
        }
        let place = self.locate(source)?;
        self.around(&Cancel::new()).sensitivities(&tree, tree.root(), place)
    }
}

impl<S: Arithmetic> Evaluator<'_, S> {
    /// `D(result, source)` whose source is a place; any other is left to the catalogue.
    pub(super) fn sensitivities(&self, call: &Call) -> Option<Value<S>> {
        let given: Vec<NodeId> = call.positional().collect();
        let ([result, source], None) = (given.as_slice(), call.keywords().next()) else {
            return None;
        };
        let place = self.place(*source)?;
        let found = self.around.sensitivities(self.tree, *result, place);
        Some(found.and_then(|found| Ok(found.matrix()?)).map(|matrix| listed(&matrix)).into())
    }

    fn place(&self, id: NodeId) -> Option<Target> {
        match &self.node(id).expression {
            Expression::CellRef(reference) => Some(Target::Cell(reference.address)),
            Expression::Range(range) => Some(Target::Cells(*range)),
            Expression::Name(name) => self.around.document.target(name),
            _ => None,
        }
    }
}

/// A list for each row; of a single row or a single column, its numbers.
fn listed<S: Arithmetic>(matrix: &Sparse) -> Value<S> {
    let number = |x: &f64| Value::Number(S::from_f64(*x).unwrap_or_else(S::zero));
    let row = |index| {
        let mut row = vec![Value::Number(S::zero()); matrix.columns()];
        for (place, entry) in matrix.row(index) {
            row[place] = number(entry);
        }
        single(row)
    };
    single((0..matrix.rows()).map(row).collect())
}

fn single<S: Arithmetic>(mut values: Vec<Value<S>>) -> Value<S> {
    if values.len() == 1 { values.remove(0) } else { Value::list(values) }
}

impl<S: Arithmetic> Surroundings<'_, S> {
    /// How a node of a tree follows the cells of a place.
    pub(crate) fn sensitivities(
        &self,
        tree: &Tree,
        result: NodeId,
        place: Target,
    ) -> std::result::Result<Sensitivities, Failure> {
        require_floating::<S>()?;
        let moved = match place {
            Target::Cell(at) => vec![at],
            Target::Cells(range) => self.filled(&range).into_iter().map(|(at, _)| at).collect(),
        };
        let values: Vec<Value> = moved.iter().map(|at| self.plain(*at)).collect();
        if let Some(at) = moved.iter().zip(&values).find_map(|(at, value)| empty(*at, value)) {
            return Err(super::references::empty(&at.to_string()));
        }
        let (seeded, count) = sources(&values.iter().collect::<Vec<_>>())?;
        let mut cells: BTreeMap<Address, Cell<Traced>> =
            moved.iter().copied().zip(seeded.into_iter().map(Cell::computed)).collect();

        let mut between = self.between(&moved, tree);
        between.kept.retain(|at| !cells.contains_key(at));
        cells.extend(between.kept.iter().map(|at| (*at, Cell::computed(traced(&self.plain(*at))))));
        for at in between.followed {
            let Some(cell) = self.cells.get(&at) else { continue };
            let value = self.among(&cells, |around| around.cell(at, &cell.content));
            cells.insert(at, Cell::computed(value));
        }
        let value =
            self.among(&cells, |around| Evaluator { tree, around }.operand(result).settle());
        Ok(Sensitivities { results: numbers(&value)?, sources: count })
    }

    /// What is computed among other cells; interrupted there, it is here.
    fn among(
        &self,
        cells: &BTreeMap<Address, Cell<Traced>>,
        compute: impl FnOnce(&Surroundings<Traced>) -> Value<Traced>,
    ) -> Value<Traced> {
        let Self { document, graph, cancel, .. } = *self;
        let stopped = self.interrupted.get() || cancel.is_cancelled();
        let around =
            Surroundings { document, cells, graph, cancel, interrupted: Flag::new(stopped) };
        let value = if stopped { Value::Empty } else { compute(&around) };
        self.interrupted.set(around.interrupted.get());
        value
    }

    /// The value of a cell as floating numbers, which it has.
    fn plain(&self, at: Address) -> Value {
        self.at(at).map_scalar(&|x| x.plain().ok()).unwrap_or_default()
    }

    /// What a tree needs: cells that follow the moved ones, in the order in which they are computed,
    /// and cells that stay as they are.
    fn between(&self, moved: &[Address], tree: &Tree) -> Between {
        let mut affected = BTreeSet::new();
        self.graph.spread(moved.iter().copied(), &mut affected);
        let mut found = Between::default();
        let mut needed = BTreeSet::new();
        let mut open: Vec<Address> = self.mentioned(tree);
        while let Some(at) = open.pop() {
            if moved.contains(&at) || !affected.contains(&at) {
                found.kept.insert(at);
            } else if needed.insert(at)
                && let Some(Content::Formula(tree)) = self.cells.get(&at).map(|cell| &cell.content)
            {
                open.extend(self.mentioned(tree));
            }
        }
        for stage in self.graph.stages(&affected) {
            match stage {
                Stage::Compute(at) if needed.contains(&at) => found.followed.push(at),
                Stage::Compute(_) => {}
                // Their values are errors already.
                Stage::Circle(circle) => found.kept.extend(circle.rounds.keys()),
            }
        }
        found
    }

    /// The cells that are not empty among those a tree mentions.
    fn mentioned(&self, tree: &Tree) -> Vec<Address> {
        let Mentioned { mut cells, ranges, .. } = Mentioned::by(tree, self.document);
        for range in &ranges {
            cells.extend(self.filled(range).into_iter().map(|(at, _)| at));
        }
        cells
    }
}

/// The cells to compute again, and those to take over.
#[derive(Default)]
struct Between {
    followed: Vec<Address>,
    kept: BTreeSet<Address>,
}

fn empty(at: Address, value: &Value) -> Option<Address> {
    matches!(value, Value::Empty).then_some(at)
}

/// Exact numbers are not traced, and traced ones not once more.
fn require_floating<S: Arithmetic>() -> std::result::Result<(), Failure> {
    if TypeId::of::<S>() == TypeId::of::<f64>() {
        return Ok(());
    }
    let (en, fr) = match S::EXACT {
        true => ("exact mode", "le mode exact"),
        false => ("a derivative", "une dérivée"),
    };
    let expected = "a formula without derivatives, in floating mode";
    let french =
        format!("résultat : reçu {fr}, attendu une formule sans dérivées, en mode flottant");
    Err(Failure::of(Error::domain("result", en, expected), french))
}
