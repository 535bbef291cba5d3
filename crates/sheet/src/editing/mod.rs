//! Changing a sheet: every gesture is one step of its history.

mod copy;
mod insert;
mod poles;
mod recover;

pub use copy::Clip;

use pforms_catalogue::Arithmetic;
use pforms_formula::{Address, Range, rename_reference};
use pforms_kernel::{Error, Result};

use crate::history::Step;
use crate::settings::check_settings;
use crate::{Edit, Settings, Sheet, Target, check_name};

impl<S: Arithmetic> Sheet<S> {
    /// Types `text` into a cell; an empty text empties it.
    pub fn set(&mut self, at: Address, text: &str) {
        self.make(vec![Edit::cell(at, text)]);
    }

    /// Empties the cells of a range.
    pub fn clear(&mut self, range: &Range) {
        let filled = self.addresses().filter(|at| range.contains(*at));
        let edits = filled.map(Edit::clear).collect();
        self.make(edits);
    }

    /// Gives a name to an address or range; an empty target takes the name away.
    ///
    /// Errors: `Format` for a name no formula could use, or a target that is no place.
    pub fn set_name(&mut self, name: &str, target: &str) -> Result<()> {
        check_name(name)?;
        let target = if target.is_empty() { None } else { Some(Target::read(target)?) };
        self.make(vec![Edit::Name { name: name.to_owned(), target }]);
        Ok(())
    }

    /// Gives a name another spelling, in all formulas too.
    ///
    /// Errors: `Format` when there is no such name, or the new one is taken or unusable.
    pub fn rename(&mut self, old: &str, new: &str) -> Result<()> {
        check_name(new)?;
        let refused = |message: String| Error::format("a name", None, message);
        let target = self.document.target(old);
        let target = target.ok_or_else(|| refused(format!("there is no name {old:?}")))?;
        let same = pforms_formula::same_name(old, new);
        if !same && self.document.target(new).is_some() {
            return Err(refused(format!("{new:?} is the name of something else")));
        }
        let mut edits = vec![Edit::Name { name: new.to_owned(), target: Some(target) }];
        if !same {
            edits.push(Edit::Name { name: old.to_owned(), target: None });
        }
        let cells =
            self.document.cells().map(|(at, text)| (at, text, rename_reference(text, old, new)));
        edits.extend(
            cells
                .filter(|(_, text, renamed)| text != renamed)
                .map(|(at, _, renamed)| Edit::cell(at, &renamed)),
        );
        self.make(edits);
        Ok(())
    }

    /// Says how a cell is drawn; `None` hides it.
    ///
    /// Errors: `Format` for settings a file could not hold: nothing, or more than 32 levels.
    pub fn set_show(&mut self, at: Address, settings: Option<Settings>) -> Result<()> {
        settings.iter().try_for_each(check_settings)?;
        self.make(vec![Edit::Show { at, settings }]);
        Ok(())
    }

    /// Moves the camera; empty settings make it the usual one.
    ///
    /// Errors: as [`Sheet::set_show`].
    pub fn set_camera(&mut self, settings: Settings) -> Result<()> {
        check_settings(&settings)?;
        self.make(vec![Edit::Camera { settings }]);
        Ok(())
    }

    /// Replaces the notes.
    ///
    /// Errors: as [`Sheet::set_show`].
    pub fn set_notes(&mut self, notes: Vec<Settings>) -> Result<()> {
        notes.iter().try_for_each(check_settings)?;
        self.make(vec![Edit::Notes { notes }]);
        Ok(())
    }

    /// Changes the title in a language such as `fr`, or the one without language when that is
    /// empty; an empty title is taken away.
    ///
    /// Errors: `Format` when `language` is not of two to eight small letters.
    pub fn set_title(&mut self, language: &str, title: &str) -> Result<()> {
        let key =
            if language.is_empty() { "title".to_owned() } else { format!("title_{language}") };
        if !crate::pfs::is_title(&key) {
            return Err(Error::format("a language", None, format!("{language:?} is none")));
        }
        let text = Some(title.to_owned()).filter(|title| !title.is_empty());
        self.make(vec![Edit::Title { key, text }]);
        Ok(())
    }

    /// All edits until the matching [`Sheet::end_gesture`] are one step: a drag is undone at once.
    pub fn begin_gesture(&mut self) {
        self.history.begin();
    }

    /// Ends a gesture; one that changed nothing leaves no step.
    pub fn end_gesture(&mut self) {
        self.history.end(&self.document);
    }

    /// Takes back the last step; says whether there was one.
    pub fn undo(&mut self) -> bool {
        let step = self.history.undo(&mut self.document);
        self.absorb(step.as_deref().unwrap_or_default());
        step.is_some()
    }

    /// Makes the last step again that was taken back; says whether there was one.
    pub fn redo(&mut self) -> bool {
        let step = self.history.redo(&mut self.document);
        self.absorb(step.as_deref().unwrap_or_default());
        step.is_some()
    }

    /// Is there a step to take back?
    pub fn can_undo(&self) -> bool {
        self.history.can_undo()
    }

    /// Is there a step to make again?
    pub fn can_redo(&self) -> bool {
        self.history.can_redo()
    }

    /// Makes edits as one step, or as part of the gesture that has begun.
    /// An edit that changes nothing is no edit.
    pub(crate) fn make(&mut self, mut edits: Step) {
        edits.retain(|edit| self.document.current(edit) != *edit);
        self.history.make(&mut self.document, edits.clone());
        self.absorb(&edits);
    }
}
