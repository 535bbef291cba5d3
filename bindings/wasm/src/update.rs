//! What a call changed.

use std::collections::{BTreeMap, BTreeSet};

use pforms_catalogue::Language;
use pforms_formula::Address;
use pforms_scene::Mode;
use pforms_sheet::{Settings, Sheet};
use serde::Serialize;

use crate::picture::Gallery;
use crate::style::{complete, modes};
use crate::{CellInfo, Drawing, Poles, Problem};

/// What changed since the last answer. Drawings travel beside it, as plain buffers.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Update {
    /// The title in the language of the page.
    pub title: String,
    /// Cells that were computed, restyled or renamed.
    pub cells: Vec<ShownCell>,
    /// Cells that are empty now.
    pub removed: Vec<String>,
    /// Cells that are no longer drawn.
    pub hidden: Vec<String>,
    /// Poles of the changed cells that are literal.
    pub poles: Vec<Poles>,
    /// The camera, when the sheet was replaced.
    pub camera: Option<Settings>,
    /// The notes, when they changed.
    pub notes: Option<Vec<Note>>,
    /// Is there a step to take back?
    pub can_undo: bool,
    /// Is there a step to make again?
    pub can_redo: bool,
    /// Was the sheet replaced?
    pub whole: bool,
    /// Cells still to be computed: ask to proceed.
    pub pending: usize,
    /// Cells that are shown but cannot be drawn, and why.
    pub undrawn: Vec<Undrawn>,
    /// Cells drawn anew; they travel as plain buffers, not as text.
    #[serde(skip)]
    pub drawings: Vec<Drawing>,
}

/// A cell and how it is drawn.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ShownCell {
    /// What it holds.
    #[serde(flatten)]
    pub info: CellInfo,
    /// How it is drawn, if it is.
    pub style: Option<Settings>,
    /// The ways its value can be drawn.
    pub modes: Vec<Mode>,
}

/// Why a cell that is shown has no picture.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Undrawn {
    /// The cell.
    pub address: String,
    /// What went wrong.
    #[serde(flatten)]
    pub problem: Problem,
}

/// A remark of the author in one language.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Note {
    /// The cell it is about.
    pub cell: Option<String>,
    /// What it says.
    pub text: String,
}

/// What the page was told last of what the sheet does not report by itself.
#[derive(Clone, Debug, Default)]
pub(crate) struct Told {
    shown: BTreeMap<Address, Settings>,
    names: Vec<(String, String)>,
    notes: Vec<Settings>,
    gallery: Gallery,
}

impl Told {
    /// Collects what changed: `changed` was computed again, the rest is found by comparing.
    pub(crate) fn update(
        &mut self,
        sheet: &Sheet,
        changed: &[Address],
        language: Language,
    ) -> Update {
        let restyled = self.restyled(sheet);
        let mut touched: BTreeSet<Address> = changed.iter().chain(&restyled).copied().collect();
        touched.extend(sheet.pending());
        touched.extend(self.renamed(sheet));
        let mut update = self.collect(sheet, &touched, language);
        let changed: BTreeSet<Address> = changed.iter().copied().collect();
        let drawn: BTreeSet<Address> = changed.iter().chain(&restyled).copied().collect();
        for at in drawn {
            self.draw(&mut update, sheet, at, !changed.contains(&at), language);
        }
        update
    }

    /// What changed when nothing but cells was edited: one frame of a drag. Nothing is compared.
    pub(crate) fn cells(
        &mut self,
        sheet: &Sheet,
        changed: &[Address],
        language: Language,
    ) -> Update {
        let mut touched: BTreeSet<Address> = changed.iter().copied().collect();
        touched.extend(sheet.pending());
        let mut update = self.collect(sheet, &touched, language);
        for at in changed {
            self.draw(&mut update, sheet, *at, false, language);
        }
        update
    }

    /// Draws one cell that changed, or tells that it is no longer drawn.
    fn draw(
        &mut self,
        update: &mut Update,
        sheet: &Sheet,
        at: Address,
        same: bool,
        language: Language,
    ) {
        match self.gallery.draw(sheet, at, same) {
            Ok(Some(drawing)) => return update.drawings.push(drawing),
            Ok(None) => {}
            Err(error) => update.undrawn.push(Undrawn {
                address: at.to_string(),
                problem: Problem::error(error, language),
            }),
        }
        update.hidden.push(at.to_string());
    }

    /// Everything, as for a page that knows nothing.
    pub(crate) fn whole(&mut self, sheet: &Sheet, language: Language) -> Update {
        *self = Self::default();
        let all: Vec<Address> = sheet.addresses().collect();
        let mut update = self.update(sheet, &all, language);
        update.whole = true;
        update.camera = Some(sheet.document().camera().clone());
        update.notes = Some(notes(sheet, language));
        update
    }

    fn collect(
        &mut self,
        sheet: &Sheet,
        touched: &BTreeSet<Address>,
        language: Language,
    ) -> Update {
        let (kept, removed): (Vec<Address>, Vec<Address>) =
            touched.iter().partition(|at| !sheet.document().text(**at).is_empty());
        let notes_changed = self.notes != sheet.document().notes();
        if notes_changed {
            self.notes = sheet.document().notes().to_vec();
        }
        Update {
            title: sheet.document().title(code(language)).to_owned(),
            cells: kept.iter().map(|at| shown_cell(sheet, *at, language)).collect(),
            removed: removed.iter().map(ToString::to_string).collect(),
            poles: kept.iter().filter_map(|at| Poles::of(sheet, *at, language)).collect(),
            notes: notes_changed.then(|| notes(sheet, language)),
            can_undo: sheet.can_undo(),
            can_redo: sheet.can_redo(),
            pending: sheet.pending().count(),
            ..Update::default()
        }
    }

    fn restyled(&mut self, sheet: &Sheet) -> Vec<Address> {
        let now: BTreeMap<Address, Settings> =
            sheet.document().shown().map(|(at, settings)| (at, settings.clone())).collect();
        let before = std::mem::replace(&mut self.shown, now);
        let places: BTreeSet<&Address> = before.keys().chain(self.shown.keys()).collect();
        places.into_iter().filter(|at| before.get(at) != self.shown.get(at)).copied().collect()
    }

    fn renamed(&mut self, sheet: &Sheet) -> Vec<Address> {
        let now: Vec<(String, String)> = sheet
            .document()
            .names()
            .map(|(name, target)| (name.to_owned(), target.to_string()))
            .collect();
        let before = std::mem::replace(&mut self.names, now);
        let gone = before.iter().filter(|name| !self.names.contains(name));
        let come = self.names.iter().filter(|name| !before.contains(name));
        gone.chain(come).filter_map(|(_, target)| target.parse().ok()).collect()
    }
}

fn shown_cell(sheet: &Sheet, at: Address, language: Language) -> ShownCell {
    ShownCell {
        info: CellInfo::of(sheet, at, language),
        style: sheet.document().show(at).map(|style| complete(style, sheet.value(at))),
        modes: modes(sheet.value(at)),
    }
}

pub(crate) fn code(language: Language) -> &'static str {
    match language {
        Language::English => "en",
        Language::French => "fr",
    }
}

/// Notes say `text`, and `text_fr` for another language.
fn notes(sheet: &Sheet, language: Language) -> Vec<Note> {
    let own = format!("text_{}", code(language));
    let word = |note: &Settings, key: &str| note.get(key)?.as_str().map(str::to_owned);
    sheet
        .document()
        .notes()
        .iter()
        .filter_map(|note| {
            let text = word(note, &own).or_else(|| word(note, "text"))?;
            Some(Note { cell: word(note, "cell"), text })
        })
        .collect()
}
