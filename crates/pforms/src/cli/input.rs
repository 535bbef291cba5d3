//! What a file holds to be drawn: named values, their styles, and a camera.

use std::path::Path;

use pforms_catalogue::{Language, Value};
use pforms_formats::{Format, Named};
use pforms_kernel::{Error, Result};
use pforms_operators::Shape;
use pforms_scene::{Camera, Scene, Shapes, Style};
use pforms_sheet::{Address, Sheet, Target, pfs};
use serde_json::{Map, Value as Json};

use super::{files, poles};

type Settings = Map<String, Json>;

/// A file that was read; complaints name it.
pub(crate) struct Input {
    name: String,
    content: Content,
}

/// A sheet, computed, or forms.
enum Content {
    Sheet(Box<Sheet>),
    Forms { stem: String, forms: Vec<Named> },
}

/// A value to be drawn.
struct Subject {
    name: String,
    shapes: Shapes,
    style: Settings,
}

impl Input {
    /// Reads a file; complaints name it.
    pub(crate) fn open(path: &Path) -> std::result::Result<Self, Box<dyn std::error::Error>> {
        let bytes = files::read(path)?;
        let name = path.display().to_string();
        let ending = path.extension().map(std::ffi::OsStr::to_ascii_lowercase);
        let is_sheet = ending.is_some_and(|ending| ending == "pfs")
            || (Format::of_name(&name).is_err() && Format::of_content(&bytes).is_none());
        if is_sheet {
            let document = pfs::read_bytes(&bytes).map_err(|error| files::in_file(&name, error))?;
            let mut sheet = Sheet::from(document);
            sheet.recalculate_all();
            return Ok(Self { name, content: Content::Sheet(Box::new(sheet)) });
        }
        let forms =
            pforms_formats::read(&name, &bytes).map_err(|error| files::in_file(&name, error))?;
        let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        Ok(Self { name, content: Content::Forms { stem, forms } })
    }

    /// The forms that are shown, or those asked for.
    pub(crate) fn forms(&self, asked: &[String]) -> Result<Vec<Named>> {
        if let (Content::Forms { forms, .. }, true) = (&self.content, asked.is_empty()) {
            return Ok(forms.clone());
        }
        let named = |Subject { name, shapes, .. }: Subject| {
            let of = |shape: &Shape| Named { name: Some(name.clone()), shape: shape.clone() };
            shapes.as_slice().iter().map(of).collect::<Vec<_>>()
        };
        Ok(self.subjects(asked)?.into_iter().flat_map(named).collect())
    }

    /// The scene of what is shown or asked for; `style` and `camera` go before what the file says.
    pub(crate) fn scene(
        &self,
        asked: &[String],
        style: &Settings,
        camera: &Settings,
    ) -> Result<Scene> {
        let own = match &self.content {
            Content::Sheet(sheet) => sheet.document().camera().clone(),
            Content::Forms { .. } => Settings::new(),
        };
        let camera = Camera::from_settings(&over(own, camera));
        let camera = camera.map_err(|error| self.named(&error))?;
        let mut scene = Scene { camera, ..Scene::default() };
        for Subject { name, shapes, style: own } in self.subjects(asked)? {
            let drawn = Style::from_settings(&over(own, style))
                .and_then(|style| scene.add(&name, &shapes, style));
            drawn.map_err(|error| self.named(&at_cell(&name, &error)))?;
        }
        Ok(scene)
    }

    fn named(&self, error: &Error) -> Error {
        Error::format(&self.name, None, error)
    }

    fn subjects(&self, asked: &[String]) -> Result<Vec<Subject>> {
        let subjects = match &self.content {
            Content::Sheet(sheet) => cells(sheet, asked),
            Content::Forms { stem, forms } => named(stem, forms, asked),
        };
        let subjects = subjects.map_err(|error| self.named(&error))?;
        if subjects.is_empty() {
            let message = "nothing is shown; name a cell with --cell";
            return Err(Error::format(&self.name, None, message));
        }
        Ok(subjects)
    }
}

/// The cells that are shown, unless they are empty, or those asked for.
fn cells(sheet: &Sheet, asked: &[String]) -> Result<Vec<Subject>> {
    let document = sheet.document();
    let mut addresses: Vec<Address> =
        document.shown().map(|(at, _)| at).filter(|at| *sheet.value(*at) != Value::Empty).collect();
    if !asked.is_empty() {
        addresses.clear();
        for place in asked {
            match sheet.locate(place)? {
                Target::Cell(at) => addresses.push(at),
                Target::Cells(range) => {
                    addresses.extend(sheet.addresses().filter(|at| range.contains(*at)));
                }
            }
        }
    }
    addresses.into_iter().map(|at| cell(sheet, at)).collect()
}

fn cell(sheet: &Sheet, at: Address) -> Result<Subject> {
    let name = at.to_string();
    let value = sheet.value(at);
    if let Value::Error(failure) = value {
        return Err(Error::format(&name, None, poles::complaint(failure, Language::English)));
    }
    let shapes = Shapes::in_value(value).map_err(|error| at_cell(&name, &error))?;
    Ok(Subject { name, shapes, style: sheet.document().show(at).cloned().unwrap_or_default() })
}

/// Named forms one by one, and all that have no name together, so that patches fit one another.
fn named(stem: &str, forms: &[Named], asked: &[String]) -> Result<Vec<Subject>> {
    for name in asked {
        if !forms.iter().any(|named| named.name.as_ref() == Some(name)) {
            return Err(Error::format(name, None, "no form has this name"));
        }
    }
    let mut subjects: Vec<Subject> = Vec::new();
    for part in forms.chunk_by(|a, b| a.name == b.name) {
        let name = part[0].name.clone();
        if !asked.is_empty() && !name.as_ref().is_some_and(|name| asked.contains(name)) {
            continue;
        }
        subjects.push(Subject {
            name: name.unwrap_or_else(|| stem.to_owned()),
            shapes: Shapes::of_all(part.iter().map(|named| named.shape.clone()).collect()),
            style: Settings::new(),
        });
    }
    Ok(subjects)
}

/// The settings with some keys replaced.
fn over(mut settings: Settings, changes: &Settings) -> Settings {
    settings.extend(changes.clone());
    settings
}

fn at_cell(name: &str, error: &Error) -> Error {
    Error::format(name, None, error)
}
