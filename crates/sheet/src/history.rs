//! Undo and redo without limit, and the log that survives a crash.

use std::collections::BTreeSet;

use serde::{Deserialize, Serialize};

use crate::edit::Slot;
use crate::{Document, Edit};

/// Edits that are undone together; none touches what another does, so their order is free.
pub type Step = Vec<Edit>;

/// What happened to a document, one entry for each thing a person did.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Entry {
    /// Edits were made.
    Step(Step),
    /// The last step was taken back.
    Undo,
    /// The last step taken back was made again.
    Redo,
}

/// A document at some moment with its past and its future: what to keep where a crash cannot
/// reach it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Snapshot {
    /// The document as a `.pfs` text.
    pub document: String,
    /// What undo would take back, the last entry first to go.
    pub undo: Vec<Step>,
    /// What redo would make again, the last entry first to come.
    pub redo: Vec<Step>,
}

/// The past and future of one document, as edits that take back and edits that make again.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct History {
    undo: Vec<Step>,
    redo: Vec<Step>,
    open: Option<Gesture>,
    log: Vec<Entry>,
}

/// A step that is still being made: only the first state of each slot counts for undo.
#[derive(Clone, Debug, Default, PartialEq)]
struct Gesture {
    depth: usize,
    touched: BTreeSet<Slot>,
    opposites: Step,
}

impl History {
    pub(crate) fn resumed(undo: Vec<Step>, redo: Vec<Step>) -> Self {
        Self { undo, redo, ..Self::default() }
    }

    /// All edits from here to the matching [`History::end`] are one step; gestures may nest.
    pub(crate) fn begin(&mut self) {
        self.open.get_or_insert_default().depth += 1;
    }

    /// Makes edits, as one step or as part of the open gesture.
    pub(crate) fn make(&mut self, document: &mut Document, edits: Step) {
        self.begin();
        for edit in edits {
            let slot = edit.slot();
            let opposite = document.apply(edit);
            if let Some(gesture) = &mut self.open
                && gesture.touched.insert(slot)
            {
                gesture.opposites.push(opposite);
            }
        }
        self.end(document);
    }

    /// Ends a gesture. One that left everything as it was leaves no trace.
    pub(crate) fn end(&mut self, document: &Document) {
        let Some(gesture) = &mut self.open else { return };
        gesture.depth -= 1;
        if gesture.depth > 0 {
            return;
        }
        let opposites = std::mem::take(&mut gesture.opposites);
        self.open = None;
        let (step, opposites): (Step, Step) = opposites
            .into_iter()
            .map(|opposite| (document.current(&opposite), opposite))
            .filter(|(now, before)| now != before)
            .unzip();
        if step.is_empty() {
            return;
        }
        self.undo.push(opposites);
        self.redo.clear();
        self.log.push(Entry::Step(step));
    }

    /// Takes back the last step and returns the edits that did so; an open gesture ends first.
    pub(crate) fn undo(&mut self, document: &mut Document) -> Option<Step> {
        self.finish(document);
        let step = self.undo.pop()?;
        self.redo.push(apply_all(document, &step));
        self.log.push(Entry::Undo);
        Some(step)
    }

    /// Makes the last step again that was taken back, and returns its edits.
    pub(crate) fn redo(&mut self, document: &mut Document) -> Option<Step> {
        self.finish(document);
        let step = self.redo.pop()?;
        self.undo.push(apply_all(document, &step));
        self.log.push(Entry::Redo);
        Some(step)
    }

    /// Ends whatever gesture is open, however deep.
    pub(crate) fn finish(&mut self, document: &Document) {
        while self.open.is_some() {
            self.end(document);
        }
    }

    pub(crate) fn can_undo(&self) -> bool {
        !self.undo.is_empty() || self.open.as_ref().is_some_and(|open| !open.touched.is_empty())
    }

    pub(crate) fn can_redo(&self) -> bool {
        !self.redo.is_empty()
    }

    pub(crate) fn log(&self) -> &[Entry] {
        &self.log
    }

    /// The state to keep; the log starts again from here.
    pub(crate) fn snapshot(&mut self, document: &Document) -> Snapshot {
        self.finish(document);
        self.log.clear();
        let (undo, redo) = (self.undo.clone(), self.redo.clone());
        Snapshot { document: crate::pfs::write(document), undo, redo }
    }

    /// Does again what an entry of a log tells; returns the edits made.
    pub(crate) fn replay(&mut self, document: &mut Document, entry: Entry) -> Step {
        match entry {
            Entry::Step(edits) => {
                self.make(document, edits.clone());
                edits
            }
            Entry::Undo => self.undo(document).unwrap_or_default(),
            Entry::Redo => self.redo(document).unwrap_or_default(),
        }
    }
}

fn apply_all(document: &mut Document, step: &[Edit]) -> Step {
    step.iter().map(|edit| document.apply(edit.clone())).collect()
}
