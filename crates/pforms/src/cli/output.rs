//! Writes what an input holds in the format that the name of a file asks for.

use std::path::Path;

use pforms_formats::{Format, obj, write_forms, write_scene};
use serde_json::{Map, Value as Json};

use super::{files, input::Input};

type Done = Result<(), Box<dyn std::error::Error>>;

/// Writes the forms themselves or a drawing of them; an OBJ gets its colours in a file beside it.
///
/// Nothing is written when anything asked for cannot be drawn.
pub(crate) fn write(
    path: &Path,
    input: &Input,
    asked: &[String],
    style: &Map<String, Json>,
    camera: &Map<String, Json>,
    axes: bool,
) -> Done {
    let format = Format::of_name(&path.display().to_string())?;
    if format.holds_forms() {
        return files::write(path, &write_forms(format, &input.forms(asked)?)?);
    }
    let mut scene = input.scene(asked, style, camera)?;
    scene.axes = axes;
    if format != Format::Obj {
        return files::write(path, &write_scene(format, &scene)?);
    }
    let library = path.with_extension("mtl");
    let name = library.file_name().map(|name| name.to_string_lossy().into_owned());
    let drawing = obj::write(&scene, name.as_deref())?;
    files::write(&library, &obj::materials(&scene))?;
    files::write(path, &drawing)
}
