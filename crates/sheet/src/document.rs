//! What a sheet says, before anything is computed: the part that is saved.

use std::collections::BTreeMap;

use pforms_formula::Address;
use serde_json::{Map, Value};

use crate::name::folded;
use crate::pfs::Remarks;
use crate::{Edit, Target};

/// An ordered table of settings the sheet keeps without reading: how a cell is drawn, the camera,
/// a note.
///
/// Their meaning belongs to whoever draws; here they are only kept, undone and saved.
pub type Settings = Map<String, Value>;

/// Cells, names, styles, camera, notes and titles.
///
/// A document changes only by an [`Edit`], which can be undone.
///
/// ```
/// use pforms_sheet::{Document, Edit};
/// let mut document = Document::default();
/// let undo = document.apply(Edit::cell("A1".parse()?, "(1, 2, 3)"));
/// assert_eq!(document.text("A1".parse()?), "(1, 2, 3)");
/// document.apply(undo);
/// assert_eq!(document, Document::default());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Document {
    pub(crate) titles: BTreeMap<String, String>,
    pub(crate) cells: BTreeMap<Address, String>,
    pub(crate) names: BTreeMap<String, Name>,
    pub(crate) shown: BTreeMap<Address, Settings>,
    pub(crate) camera: Settings,
    pub(crate) notes: Vec<Settings>,
    pub(crate) remarks: Remarks,
}

/// A name as it was typed, and its target.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Name {
    pub(crate) spelling: String,
    pub(crate) target: Target,
}

impl Document {
    /// Makes the change and returns the edit that takes it back.
    pub fn apply(&mut self, edit: Edit) -> Edit {
        match edit {
            Edit::Cell { at, text } => {
                let text = exchange(&mut self.cells, at, text.filter(|text| !text.is_empty()));
                Edit::Cell { at, text }
            }
            Edit::Name { name, target } => {
                let entry = target.map(|target| Name { spelling: name.clone(), target });
                let before = exchange(&mut self.names, folded(&name), entry);
                let (spelling, target) = before.map(|name| (name.spelling, name.target)).unzip();
                Edit::Name { name: spelling.unwrap_or(name), target }
            }
            Edit::Show { at, settings } => {
                let settings = exchange(&mut self.shown, at, settings);
                Edit::Show { at, settings }
            }
            Edit::Title { key, text } => {
                let text = exchange(&mut self.titles, key.clone(), text);
                Edit::Title { key, text }
            }
            Edit::Camera { settings } => {
                Edit::Camera { settings: std::mem::replace(&mut self.camera, settings) }
            }
            Edit::Notes { notes } => {
                Edit::Notes { notes: std::mem::replace(&mut self.notes, notes) }
            }
            Edit::Remarks { remarks } => {
                Edit::Remarks { remarks: std::mem::replace(&mut self.remarks, remarks) }
            }
        }
    }

    /// The edit that would put the slot of `edit` into the state it has now.
    pub(crate) fn current(&self, edit: &Edit) -> Edit {
        match edit {
            Edit::Cell { at, .. } => Edit::Cell { at: *at, text: self.cells.get(at).cloned() },
            Edit::Name { name, .. } => {
                let held = self.names.get(&folded(name));
                let spelling = held.map_or(name, |held| &held.spelling).clone();
                Edit::Name { name: spelling, target: held.map(|held| held.target) }
            }
            Edit::Show { at, .. } => Edit::Show { at: *at, settings: self.shown.get(at).cloned() },
            Edit::Title { key, .. } => {
                Edit::Title { key: key.clone(), text: self.titles.get(key).cloned() }
            }
            Edit::Camera { .. } => Edit::Camera { settings: self.camera.clone() },
            Edit::Notes { .. } => Edit::Notes { notes: self.notes.clone() },
            Edit::Remarks { .. } => Edit::Remarks { remarks: self.remarks.clone() },
        }
    }

    /// The title in a language (`"fr"`), or the one without language if there is none in it.
    pub fn title(&self, language: &str) -> &str {
        let own = self.titles.get(&format!("title_{language}"));
        own.or_else(|| self.titles.get("title")).map_or("", String::as_str)
    }

    /// The text of a cell as typed; empty for an empty cell.
    pub fn text(&self, at: Address) -> &str {
        self.cells.get(&at).map_or("", String::as_str)
    }

    /// The cells that are not empty, column by column: A1, A2, …, B1.
    pub fn cells(&self) -> impl Iterator<Item = (Address, &str)> {
        self.cells.iter().map(|(at, text)| (*at, text.as_str()))
    }

    /// Every name as typed with its target, in alphabetical order.
    pub fn names(&self) -> impl Iterator<Item = (&str, Target)> {
        self.names.values().map(|name| (name.spelling.as_str(), name.target))
    }

    /// What a name stands for; capitals do not matter.
    pub fn target(&self, name: &str) -> Option<Target> {
        self.names.get(&folded(name)).map(|name| name.target)
    }

    /// The cells that are drawn, and how.
    pub fn shown(&self) -> impl Iterator<Item = (Address, &Settings)> {
        self.shown.iter().map(|(at, settings)| (*at, settings))
    }

    /// How a cell is drawn; `None` when it is not.
    pub fn show(&self, at: Address) -> Option<&Settings> {
        self.shown.get(&at)
    }

    /// The camera; empty when nobody moved it.
    pub fn camera(&self) -> &Settings {
        &self.camera
    }

    /// The comments of a file written by hand, by the lines they stand by.
    pub fn remarks(&self) -> &Remarks {
        &self.remarks
    }

    /// The notes, in order.
    pub fn notes(&self) -> &[Settings] {
        &self.notes
    }
}

/// Puts `new` in the place of what the map holds for `key`, and returns that.
fn exchange<K: Ord, V>(map: &mut BTreeMap<K, V>, key: K, new: Option<V>) -> Option<V> {
    match new {
        Some(value) => map.insert(key, value),
        None => map.remove(&key),
    }
}
