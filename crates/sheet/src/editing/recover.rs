//! What to keep so that a crash of the page costs nothing.

use pforms_catalogue::Arithmetic;
use pforms_kernel::{Error, Result};

use crate::history::History;
use crate::settings::check_settings;
use crate::{Edit, Entry, Sheet, Snapshot, pfs};

impl<S: Arithmetic> Sheet<S> {
    /// The document with all its past and future; the log starts again from here.
    ///
    /// An open gesture ends.
    pub fn snapshot(&mut self) -> Snapshot {
        self.history.snapshot(&self.document)
    }

    /// What was done since the last snapshot. A page keeps each entry as it comes.
    pub fn log(&self) -> &[Entry] {
        self.history.log()
    }

    /// The sheet of a snapshot, with what was done since: undo and redo reach as far as before.
    ///
    /// Errors: `Format` when the snapshot or an entry is damaged.
    ///
    /// ```
    /// use pforms_sheet::Sheet;
    /// let mut sheet: Sheet = Sheet::new();
    /// let snapshot = sheet.snapshot();
    /// sheet.set("A1".parse()?, "1");
    /// sheet.set("A1".parse()?, "2");
    /// let mut again = Sheet::<f64>::recover(&snapshot, sheet.log())?;
    /// assert_eq!(again.save(), sheet.save());
    /// again.undo();
    /// assert_eq!(again.document().text("A1".parse()?), "1");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn recover(snapshot: &Snapshot, log: &[Entry]) -> Result<Self> {
        let steps = snapshot.undo.iter().chain(&snapshot.redo);
        let logged = log.iter().filter_map(|entry| match entry {
            Entry::Step(step) => Some(step),
            Entry::Undo | Entry::Redo => None,
        });
        steps.chain(logged).flatten().try_for_each(check)?;
        let mut document = pfs::read(&snapshot.document)?;
        let mut history = History::resumed(snapshot.undo.clone(), snapshot.redo.clone());
        for entry in log {
            history.replay(&mut document, entry.clone());
        }
        Ok(Self::of(document, history))
    }
}

impl Entry {
    /// The line of a log that holds this entry.
    pub fn line(&self) -> String {
        serde_json::to_string(self).unwrap_or_default()
    }

    /// Reads the lines of a log up to the first that is damaged: a crash may cut the last one.
    pub fn read_lines(log: &str) -> Vec<Self> {
        log.lines().map_while(|line| serde_json::from_str(line).ok()).collect()
    }
}

fn check(edit: &Edit) -> Result<()> {
    match edit {
        Edit::Show { settings, .. } => settings.iter().try_for_each(check_settings),
        Edit::Camera { settings } => check_settings(settings),
        Edit::Notes { notes } => notes.iter().try_for_each(check_settings),
        Edit::Name { name, .. } => crate::check_name(name),
        Edit::Title { key, .. } if !pfs::is_title(key) => {
            Err(Error::format("a title", None, format!("{key:?} is no key of a title")))
        }
        Edit::Title { .. } | Edit::Cell { .. } | Edit::Remarks { .. } => Ok(()),
    }
}
