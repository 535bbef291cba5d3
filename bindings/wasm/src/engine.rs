//! One open sheet, and everything the page can ask of it.

use pforms_catalogue::{Language, Value};
use pforms_formula::Address;
use pforms_kernel::Error;
use pforms_scene::Camera;
use pforms_sheet::{Cancel, Clip, Clock, Edit, Settings, Sheet, Snapshot, Target, pfs};

use crate::place::address;
use crate::update::{Told, code};
use crate::{Assistance, OperatorHelp, Problem, Update, assist, operators, poles, style};

/// Seconds of computing before the page is answered; what remains is done when it asks to proceed.
const BUDGET: f64 = 0.06;

/// What a call answers.
pub type Answer<T = Update> = Result<T, Problem>;

/// One open sheet. Every call that changes it answers with what changed; one that fails changes nothing.
///
/// ```
/// use pforms_wasm::Engine;
/// let mut engine = Engine::new();
/// let update = engine.set(&[("A1".into(), "=1/4".into())])?;
/// assert_eq!(update.cells[0].info.text, "0.25");
/// # Ok::<(), pforms_wasm::Problem>(())
/// ```
#[derive(Debug, Default)]
pub struct Engine {
    pub(crate) sheet: Sheet,
    pub(crate) language: Language,
    told: Told,
    /// Where the viewer stands now; looking round is no step of the history, so the sheet learns of
    /// it only when it is written.
    pub(crate) camera: Option<Settings>,
    clock: Option<Clock>,
}

/// Where in a drag a move is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gesture {
    /// The first.
    Begin,
    /// One of many.
    During,
    /// The last.
    End,
}

impl Engine {
    /// An engine with an empty sheet, speaking English.
    pub fn new() -> Self {
        Self::default()
    }

    /// Gives the clock by which costs and patience are measured, in seconds.
    pub fn set_clock(&mut self, clock: Clock) {
        self.clock = Some(clock);
        self.sheet.set_clock(clock);
    }

    /// Replaces the sheet by the one in a `.pfs` text.
    pub fn open(&mut self, text: &str) -> Answer {
        let sheet = Sheet::open(text).map_err(|error| self.refusal(error))?;
        Ok(self.replace(sheet))
    }

    /// The sheet as a `.pfs` text.
    pub fn save(&self) -> String {
        self.with_camera(self.sheet.save())
    }

    /// The sheet with its history, as text to be kept. An open gesture ends.
    pub fn snapshot(&mut self) -> Answer<String> {
        let mut snapshot = self.sheet.snapshot();
        snapshot.document = self.with_camera(snapshot.document);
        serde_json::to_string(&snapshot).map_err(|error| self.damaged(&error))
    }

    /// Replaces the sheet by a kept one, history included.
    pub fn resume(&mut self, snapshot: &str) -> Answer {
        let snapshot: Snapshot =
            serde_json::from_str(snapshot).map_err(|error| self.damaged(&error))?;
        let sheet = Sheet::recover(&snapshot, &[]).map_err(|error| self.refusal(error))?;
        Ok(self.replace(sheet))
    }

    /// Types texts into cells, as one step.
    pub fn set(&mut self, entries: &[(String, String)]) -> Answer {
        let mut cells = Vec::with_capacity(entries.len());
        for (place, text) in entries {
            cells.push((address(place, self.language)?, assist::filed(text, self.language)));
        }
        self.sheet.begin_gesture();
        for (at, text) in cells {
            self.sheet.set(at, &text);
        }
        self.sheet.end_gesture();
        Ok(self.answer())
    }

    /// Puts copied cells at a place; their references follow.
    pub fn paste(&mut self, clip: &Clip, to: &str) -> Answer {
        let to = address(to, self.language)?;
        let filed =
            |(at, text): &(String, String)| (at.clone(), assist::filed(text, self.language));
        let clip =
            Clip { range: clip.range.clone(), cells: clip.cells.iter().map(filed).collect() };
        self.sheet.paste(&clip, to).map_err(|error| self.refusal(error))?;
        Ok(self.answer())
    }

    /// Copies one cell into every cell of a range; its references follow.
    pub fn fill(&mut self, from: &str, range: &str) -> Answer {
        let at = address(from, self.language)?;
        let target = Target::read(range).map_err(|error| self.refusal(error))?;
        if let Target::Cells(range) = target {
            self.sheet.fill(at, &range).map_err(|error| self.refusal(error))?;
        }
        Ok(self.answer())
    }

    /// Draws a cell in a style, or no longer.
    pub fn set_style(&mut self, place: &str, style: Option<Settings>) -> Answer {
        let at = address(place, self.language)?;
        let style = style
            .map(|style| style::tidy(&style))
            .transpose()
            .map_err(|error| self.refusal(error))?;
        self.sheet.set_show(at, style).map_err(|error| self.refusal(error))?;
        Ok(self.answer())
    }

    /// All changes until [`Engine::end_gesture`] are one step of the history.
    pub fn begin_gesture(&mut self) {
        self.sheet.begin_gesture();
    }

    /// Ends a gesture; one that changed nothing leaves no step.
    pub fn end_gesture(&mut self) -> Update {
        self.sheet.end_gesture();
        self.answer()
    }

    /// Gives a cell a name, or another one, in all formulas too; none takes it away.
    pub fn set_name(&mut self, place: &str, name: Option<&str>) -> Answer {
        let at = address(place, self.language)?;
        let old = crate::CellInfo::of(&self.sheet, at, self.language).name;
        let done = match (old, name) {
            (Some(old), Some(name)) => self.sheet.rename(&old, name),
            (None, Some(name)) => self.sheet.set_name(name, place),
            (Some(old), None) => self.sheet.set_name(&old, ""),
            (None, None) => Ok(()),
        };
        done.map_err(|error| self.refusal(error))?;
        Ok(self.answer())
    }

    /// Gives the sheet a title: in the language of the page, if it has one of its own there.
    pub fn set_title(&mut self, title: &str) -> Answer {
        let own = code(self.language);
        let document = self.sheet.document();
        let language = if document.title(own) == document.title("") { "" } else { own };
        self.sheet.set_title(language, title).map_err(|error| self.refusal(error))?;
        Ok(self.answer())
    }

    /// Keeps where the viewer stands.
    pub fn set_camera(&mut self, camera: Settings) -> Answer<()> {
        Camera::from_settings(&camera).map_err(|error| self.refusal(error))?;
        self.camera = Some(camera);
        Ok(())
    }

    /// Speaks another language from now on.
    pub fn set_language(&mut self, language: Language) -> Update {
        self.language = language;
        self.compute();
        let mut update = self.told.whole(&self.sheet, language);
        update.whole = false;
        update.camera = None;
        update
    }

    /// Takes back the last step.
    pub fn undo(&mut self) -> Update {
        self.sheet.undo();
        self.answer()
    }

    /// Makes the last step again that was taken back.
    pub fn redo(&mut self) -> Update {
        self.sheet.redo();
        self.answer()
    }

    /// Goes on computing what an earlier answer left pending.
    pub fn proceed(&mut self) -> Update {
        self.answer()
    }

    /// Moves a pole of a literal cell to a place on the grid of `step`. A gesture is one step of the history.
    pub fn move_pole(
        &mut self,
        place: &str,
        index: &[usize],
        to: &[f64],
        step: f64,
        gesture: Gesture,
    ) -> Answer {
        let at = address(place, self.language)?;
        let coordinates = self.aimed(at, index, to, step);
        if gesture == Gesture::Begin {
            self.sheet.begin_gesture();
        }
        let moved = self.sheet.move_pole(at, index, &coordinates);
        // A gesture that could not begin leaves nothing open.
        if gesture == Gesture::End || (gesture == Gesture::Begin && moved.is_err()) {
            self.sheet.end_gesture();
        }
        moved.map_err(|error| self.refusal(error))?;
        let changed = self.compute();
        Ok(self.told.cells(&self.sheet, &changed, self.language))
    }

    /// Types the coordinates of a pole, its weight last.
    pub fn type_pole(&mut self, place: &str, index: &[usize], texts: &[String]) -> Answer {
        let at = address(place, self.language)?;
        let source = self.sheet.document().text(at);
        let text = poles::retyped(source, index, texts, self.language)?;
        self.sheet.set(at, &text);
        Ok(self.answer())
    }

    /// Completion, help and mistakes for a text at a caret, in UTF-16 units.
    pub fn assist(&self, text: &str, caret: usize) -> Assistance {
        let names = self.sheet.document().names();
        assist::assist(
            text,
            caret,
            self.language,
            names.map(|(name, target)| (name, target.to_string())),
        )
    }

    /// Every operator in the language of the page.
    pub fn catalogue(&self) -> Vec<OperatorHelp> {
        operators::all(self.language)
    }

    pub(crate) fn replace(&mut self, sheet: Sheet) -> Update {
        self.sheet = sheet;
        self.camera = None;
        if let Some(clock) = self.clock {
            self.sheet.set_clock(clock);
        }
        self.compute();
        self.told.whole(&self.sheet, self.language)
    }

    /// Computes for a while, and tells what changed.
    pub(crate) fn answer(&mut self) -> Update {
        let changed = self.compute();
        self.told.update(&self.sheet, &changed, self.language)
    }

    fn compute(&mut self) -> Vec<Address> {
        self.sheet.recalculate(&Cancel::new().with_budget(BUDGET)).changed
    }

    /// The coordinates a drag means: of the pole's dimension, on the grid, unchanged where it did not move.
    fn aimed(&self, at: Address, index: &[usize], to: &[f64], step: f64) -> Vec<f64> {
        let Value::Form(form) = self.sheet.value(at) else { return to.to_vec() };
        let Some((weight, point)) = form.pole(index).ok().and_then(<[f64]>::split_last) else {
            return to.to_vec();
        };
        let old = point.iter().map(|x| if *weight == 0.0 { *x } else { x / weight });
        old.enumerate()
            .map(|(axis, old)| {
                to.get(axis).map_or(old, |new| poles::rounded(*new, Some(old), step))
            })
            .collect()
    }

    /// The text of a sheet with the present camera.
    fn with_camera(&self, text: String) -> String {
        match (&self.camera, pfs::read(&text)) {
            (Some(settings), Ok(mut document)) => {
                document.apply(Edit::Camera { settings: settings.clone() });
                pfs::write(&document)
            }
            _ => text,
        }
    }

    pub(crate) fn refusal(&self, error: Error) -> Problem {
        Problem::error(error, self.language)
    }

    fn damaged(&self, error: &serde_json::Error) -> Problem {
        Problem::new(
            self.language,
            format!("the kept sheet is damaged: {error}"),
            format!("le tableau gardé est endommagé : {error}"),
        )
    }
}
