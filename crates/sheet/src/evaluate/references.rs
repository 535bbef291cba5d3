//! Cells, ranges and names, looked up.

use pforms_catalogue::Language::{English, French};
use pforms_catalogue::{Arguments, Arithmetic, Failure, Value, find, unknown};
use pforms_formula::{Address, Range};
use pforms_kernel::Error;

use super::{Evaluator, Surroundings};
use crate::Target;

/// Cells one range may hold when its values are asked for.
pub const RANGE_CAP: u64 = 1 << 20;

/// Cells of a range read between two looks at the token that cancels.
const PATIENCE: usize = 1024;

impl<S: Arithmetic> Surroundings<'_, S> {
    pub(super) fn at(&self, at: Address) -> Value<S> {
        self.cells.get(&at).map_or(Value::Empty, |cell| cell.value.clone())
    }

    /// The values of a range: in order for one row or one column, else its rows as lists.
    ///
    /// Empty cells at the end do not count; one before the end is an error that names it, since
    /// leaving it out would make another form of the rest.
    pub(crate) fn rows(&self, range: &Range) -> Result<Vec<Value<S>>, Failure> {
        let count = range.len();
        if count > RANGE_CAP {
            return Err(too_many(range, count));
        }
        let (first, last) = range.columns();
        let width = (last - first + 1) as usize;
        let mut cells = Vec::with_capacity(count as usize);
        for (visited, at) in range.cells().enumerate() {
            if visited % PATIENCE == 0 && self.cancel.is_cancelled() {
                self.interrupted.set(true);
                return Ok(Vec::new());
            }
            cells.push((at, self.at(at)));
        }
        if width == 1 || cells.len() == width {
            return without_gaps(cells);
        }
        let rows = cells.chunks(width).map(|row| without_gaps(row.to_vec()));
        let mut rows: Vec<Vec<Value<S>>> = rows.collect::<Result<_, _>>()?;
        while rows.last().is_some_and(Vec::is_empty) {
            rows.pop();
        }
        Ok(rows.into_iter().map(Value::list).collect())
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

/// The values up to the last that is not empty.
fn without_gaps<S>(mut cells: Vec<(Address, Value<S>)>) -> Result<Vec<Value<S>>, Failure> {
    while cells.last().is_some_and(|(_, value)| matches!(value, Value::Empty)) {
        cells.pop();
    }
    let sound = |(at, value)| match value {
        Value::Empty => Err(empty(&Address::to_string(&at))),
        value => Ok(value),
    };
    cells.into_iter().map(sound).collect()
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

fn too_many(range: &Range, count: u64) -> Failure {
    Failure::new(
        "Limit",
        format!("{range} has {count} cells: refused, the cap is {RANGE_CAP}"),
        format!("{range} a {count} cellules : refusé, le plafond est {RANGE_CAP}"),
    )
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
