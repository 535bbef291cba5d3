//! Copies of cells, whose references follow unless a `$` holds them.

use pforms_catalogue::Arithmetic;
use pforms_formula::{Address, Range, Reference, shift};
use pforms_kernel::{Error, Result};
use serde::{Deserialize, Serialize};

use crate::{Edit, Sheet, Target};

/// Cells that [`Sheet::fill`] writes at once.
const FILL_CAP: u64 = 100_000;

/// A rectangle of cells on its way to another place, in a form that a clipboard can hold.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Clip {
    /// Where it was copied: `A1:B3`.
    pub range: String,
    /// The cells that were not empty, and their texts.
    pub cells: Vec<(String, String)>,
}

impl<S: Arithmetic> Sheet<S> {
    /// Copies a range.
    pub fn copy(&self, range: &Range) -> Clip {
        let filled = self.document.cells().filter(|(at, _)| range.contains(*at));
        let cells = filled.map(|(at, text)| (at.to_string(), text.to_owned())).collect();
        Clip { range: range.to_string(), cells }
    }

    /// Puts a copy so that its first corner comes to `to`, over whatever is there.
    ///
    /// Errors: `Format` for a clip that is damaged, `Shape` when a cell or a reference would leave
    /// the sheet; then nothing is changed.
    pub fn paste(&mut self, clip: &Clip, to: Address) -> Result<()> {
        let source = match Target::read(&clip.range)? {
            Target::Cell(at) => Range { first: at.into(), last: at.into() },
            Target::Cells(range) => range,
        };
        let columns = i64::from(to.column()) - i64::from(source.columns().0);
        let rows = i64::from(to.row()) - i64::from(source.rows().0);
        let place = moved_range(&source, columns, rows)?;
        let covered = self.addresses().filter(|at| place.contains(*at));
        let mut edits: Vec<Edit> = covered.map(Edit::clear).collect();
        for (at, text) in &clip.cells {
            let at: Address = at.parse().map_err(|error| Error::format("a clip", None, error))?;
            let at = at.moved(columns, rows).ok_or_else(|| leaves(&at.to_string()))?;
            edits.push(Edit::cell(at, &shifted(text, at, columns, rows)?));
        }
        self.make(edits);
        Ok(())
    }

    /// Copies one cell into every cell of a range.
    ///
    /// Errors: `Limit` above 100,000 cells, `Shape` when a reference would leave the sheet; then
    /// nothing is changed.
    pub fn fill(&mut self, from: Address, range: &Range) -> Result<()> {
        if range.len() > FILL_CAP {
            let what = format!("filling {range} would write {} cells", range.len());
            let bytes = u128::from(range.len()) * self.document.text(from).len().max(1) as u128;
            return Err(Error::Limit { what, bytes, cap: u128::from(FILL_CAP) });
        }
        let text = self.document.text(from);
        let copies = range.cells().filter(|at| *at != from).map(|at| {
            let columns = i64::from(at.column()) - i64::from(from.column());
            let rows = i64::from(at.row()) - i64::from(from.row());
            Ok(Edit::cell(at, &shifted(text, at, columns, rows)?))
        });
        let edits = copies.collect::<Result<Vec<Edit>>>()?;
        self.make(edits);
        Ok(())
    }
}

fn shifted(text: &str, at: Address, columns: i64, rows: i64) -> Result<String> {
    shift(text, columns, rows).ok_or_else(|| leaves(&format!("a reference of {at}")))
}

fn moved_range(range: &Range, columns: i64, rows: i64) -> Result<Range> {
    let corner = |corner: Reference| {
        corner
            .address
            .moved(columns, rows)
            .map(Reference::from)
            .ok_or_else(|| leaves(&range.to_string()))
    };
    Ok(Range { first: corner(range.first)?, last: corner(range.last)? })
}

fn leaves(what: &str) -> Error {
    Error::shape("copy", format!("{what}, which would leave the sheet"), "a place inside it")
}
