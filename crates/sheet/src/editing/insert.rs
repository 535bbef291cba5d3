//! Rows and columns put between others; whatever lies beyond moves, and formulas follow.

use std::collections::{BTreeMap, BTreeSet};

use pforms_catalogue::Arithmetic;
use pforms_formula::{Address, Range, Reference, map_references};
use pforms_kernel::{Error, Result};

use crate::{Edit, Settings, Sheet, Target};

/// Where and how much room is made.
#[derive(Clone, Copy)]
struct Gap {
    vertical: bool,
    before: u32,
    count: u32,
}

impl Gap {
    /// Where a cell goes; `None` beyond the edge of the sheet.
    fn moved(self, at: Address) -> Option<Address> {
        let place = if self.vertical { at.row() } else { at.column() };
        if place < self.before {
            return Some(at);
        }
        let (columns, rows) = if self.vertical { (0, self.count) } else { (self.count, 0) };
        at.moved(i64::from(columns), i64::from(rows))
    }

    /// Where a reference goes; it stops at the edge of the sheet.
    fn followed(self, reference: Reference) -> Reference {
        let at = reference.address;
        let edge = if self.vertical {
            Address::new(at.column(), Address::LAST_ROW)
        } else {
            Address::new(Address::LAST_COLUMN, at.row())
        };
        Reference { address: self.moved(at).or(edge).unwrap_or(at), ..reference }
    }

    fn target(self, target: Target) -> Target {
        match target {
            Target::Cell(at) => Target::Cell(self.followed(at.into()).address),
            Target::Cells(Range { first, last }) => {
                Target::Cells(Range { first: self.followed(first), last: self.followed(last) })
            }
        }
    }
}

impl<S: Arithmetic> Sheet<S> {
    /// Makes room for `count` rows before the row `before`, counted from 1.
    ///
    /// Errors: `Shape` when a cell would leave the sheet; then nothing is changed.
    pub fn insert_rows(&mut self, before: u32, count: u32) -> Result<()> {
        self.insert(Gap { vertical: true, before, count })
    }

    /// Makes room for `count` columns before the column `before`, counted from 1.
    ///
    /// Errors: as [`Sheet::insert_rows`].
    pub fn insert_columns(&mut self, before: u32, count: u32) -> Result<()> {
        self.insert(Gap { vertical: false, before, count })
    }

    fn insert(&mut self, gap: Gap) -> Result<()> {
        let document = &self.document;
        let texts = document.cells.iter().map(|(at, text)| {
            let text = map_references(text, |reference| Some(gap.followed(reference)));
            (*at, text.unwrap_or_default())
        });
        let (old, new) = (&document.cells, moved(gap, texts)?);
        let cells = differences(old, &new).map(|(at, text)| Edit::Cell { at, text });
        let shown = document.shown.iter().map(|(at, settings)| (*at, settings.clone()));
        let (old, new) = (&document.shown, moved(gap, shown)?);
        let styles = differences(old, &new).map(|(at, settings)| Edit::Show { at, settings });
        let names = document.names().map(|(name, target)| Edit::Name {
            name: name.to_owned(),
            target: Some(gap.target(target)),
        });
        let notes = document.notes.iter().map(|note| followed_note(gap, note)).collect();
        let remarks = document.remarks.iter();
        let remarks = remarks.map(|(line, remark)| (followed_line(gap, line), remark.clone()));
        let whole = [Edit::Notes { notes }, Edit::Remarks { remarks: remarks.collect() }];
        let edits = cells.chain(styles).chain(names).chain(whole).collect();
        self.make(edits);
        Ok(())
    }
}

fn moved<T>(gap: Gap, entries: impl Iterator<Item = (Address, T)>) -> Result<BTreeMap<Address, T>> {
    let moved = entries.map(|(at, entry)| match gap.moved(at) {
        Some(to) => Ok((to, entry)),
        None => {
            Err(Error::shape("insertion", format!("{at} would leave the sheet"), "room for it"))
        }
    });
    moved.collect()
}

/// What must be put where to come from one map to the other.
fn differences<'a, T: Clone + PartialEq>(
    old: &'a BTreeMap<Address, T>,
    new: &'a BTreeMap<Address, T>,
) -> impl Iterator<Item = (Address, Option<T>)> {
    let places: BTreeSet<Address> = old.keys().chain(new.keys()).copied().collect();
    let different = places.into_iter().filter(|at| old.get(at) != new.get(at));
    different.map(|at| (at, new.get(&at).cloned())).collect::<Vec<_>>().into_iter()
}

/// The name of a line in the file, when its cell moves.
fn followed_line(gap: Gap, line: &str) -> String {
    let mut parts: Vec<String> = line.split('.').map(str::to_owned).collect();
    if let [table, cell, ..] = &mut parts[..]
        && matches!(table.as_str(), "cells" | "show")
        && let Some(to) = cell.parse().ok().and_then(|at| gap.moved(at))
    {
        *cell = to.to_string();
    }
    parts.join(".")
}

/// A note that stands beside a cell goes with it.
fn followed_note(gap: Gap, note: &Settings) -> Settings {
    let mut note = note.clone();
    if let Some(cell) = note.get_mut("cell")
        && let Some(at) = cell.as_str().and_then(Reference::read)
    {
        *cell = gap.followed(at).to_string().into();
    }
    note
}
