//! Cells, ranges and names, looked up.

use pforms_catalogue::Language::{English, French};
use pforms_catalogue::{Arguments, Arithmetic, Failure, Value, find, unknown};
use pforms_formula::{Address, Range};
use pforms_kernel::Error;

use super::{Evaluator, Surroundings};
use crate::Target;

/// Cells of a range read between two looks at the token that cancels.
const PATIENCE: usize = 1024;

impl<S: Arithmetic> Surroundings<'_, S> {
    pub(super) fn at(&self, at: Address) -> Value<S> {
        self.cells.get(&at).map_or(Value::Empty, |cell| cell.value.clone())
    }

    /// The values of a range: in order for one row or one column, else its rows as lists.
    ///
    /// Empty cells at the end of a row, and empty rows at the end, do not count. One before the end
    /// is an error that names it, since leaving it out would make another form of the rest. Only
    /// cells that are not empty are visited.
    pub(crate) fn rows(&self, range: &Range) -> Result<Vec<Value<S>>, Failure> {
        let filled = self.filled(range);
        let (first_column, last_column) = range.columns();
        let (first_row, last_row) = range.rows();
        let mut rows = Vec::new();
        for (row, cells) in (first_row..).zip(filled.chunk_by(|a, b| a.0.row() == b.0.row())) {
            let mut values = Vec::with_capacity(cells.len());
            for (column, (at, value)) in (first_column..).zip(cells) {
                if (at.column(), at.row()) != (column, row) {
                    return Err(gap(column, row));
                }
                values.push((*value).clone());
            }
            rows.push(values);
        }
        if first_row == last_row || first_column == last_column {
            return Ok(rows.into_iter().flatten().collect());
        }
        Ok(rows.into_iter().map(Value::list).collect())
    }

    /// The cells of a range that have a value, row by row.
    pub(super) fn filled(&self, range: &Range) -> Vec<(Address, &Value<S>)> {
        let (first_column, last_column) = range.columns();
        let (first_row, last_row) = range.rows();
        let column = |column| {
            let ends = Address::new(column, first_row).zip(Address::new(column, last_row));
            ends.into_iter().flat_map(|(first, last)| self.cells.range(first..=last))
        };
        let mut filled = Vec::new();
        for (at, cell) in (first_column..=last_column).flat_map(column) {
            if filled.len() % PATIENCE == 0 && self.cancel.is_cancelled() {
                self.interrupted.set(true);
                return Vec::new();
            }
            if !matches!(cell.value, Value::Empty) {
                filled.push((*at, &cell.value));
            }
        }
        filled.sort_by_key(|(at, _)| (at.row(), at.column()));
        filled
    }
}

impl<S: Arithmetic> Evaluator<'_, S> {
    /// A name of the sheet, or else of an operator: `PI` is its value, `DIAG` alone its name.
    pub(super) fn name(&self, name: &str) -> Value<S> {
        match self.around.document.target(name) {
            Some(Target::Cell(at)) => self.around.at(at),
            Some(Target::Cells(range)) => self.around.rows(&range).map(Value::list).into(),
            None => match find(name) {
                Some(operator) if operator.parameters.iter().all(|p| !p.is_required()) => {
                    operator.call(Arguments::new([]))
                }
                Some(_) => Value::Text(name.to_owned()),
                None => nameless(name).into(),
            },
        }
    }
}

/// The error of a range with an empty cell before its end.
fn gap(column: u32, row: u32) -> Failure {
    empty(&Address::new(column, row).map_or(String::new(), |at| at.to_string()))
}

/// The error of an operator that meets an empty cell.
pub(super) fn empty(cell: &str) -> Failure {
    let cell: String = cell.chars().take(40).collect();
    Failure::of(
        Error::shape(&cell, "an empty cell", "a value"),
        format!("{cell} : reçu une cellule vide, attendu une valeur"),
    )
    .with_hint(format!("type a value into {cell}"), format!("tapez une valeur dans {cell}"))
}

fn nameless(name: &str) -> Failure {
    let short: String = name.chars().take(40).collect();
    let near = unknown(&short);
    let failure = Failure::new(
        "Name",
        format!("nothing is called {short}"),
        format!("rien ne s'appelle {short}"),
    );
    match near.hint(English).zip(near.hint(French)) {
        Some((en, fr)) => failure.with_hint(en, fr),
        None => failure.with_hint("a text stands in quotes", "un texte s'écrit entre guillemets"),
    }
}
