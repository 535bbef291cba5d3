//! Pictures: values with a style and a camera to the bytes of a file.

use pforms_catalogue::{Arithmetic, Value};
use pforms_formats::{Format, obj, write_scene};
use pforms_kernel::{Error, Result};
use pforms_mesh::Mesh;
use pforms_operators::Shape;
use pforms_scene::{Camera, Scene, Shapes, Style};
use pforms_sheet::{Settings, Sheet};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::errors::{done, mistyped, raised};
use crate::{meshes, shapes};

/// What was asked about a picture.
#[derive(FromPyObject)]
pub(crate) struct Look {
    /// The name of the file, and that of a file beside it for the colours of an OBJ.
    name: String,
    library: String,
    /// A style and a camera as JSON.
    style: String,
    camera: String,
    axes: bool,
}

impl Look {
    /// The camera, these keys before those of a sheet.
    pub(crate) fn camera(&self, own: &Settings) -> Result<Camera> {
        Camera::from_settings(&over(own, &self.camera)?)
    }

    fn style(&self, own: &Settings) -> Result<Style> {
        Style::from_settings(&over(own, &self.style)?)
    }
}

fn over(own: &Settings, json: &str) -> Result<Settings> {
    let changes: Settings =
        serde_json::from_str(json).map_err(|error| Error::format("style", None, error))?;
    let mut settings = own.clone();
    settings.extend(changes);
    Ok(settings)
}

/// Adds what a sheet shows to a scene.
pub(crate) fn scene_of<S: Arithmetic>(
    sheet: &Sheet<S>,
    look: &Look,
    scene: &mut Scene,
) -> Result<()> {
    for (at, own) in sheet.document().shown() {
        match sheet.value(at) {
            Value::Empty => {}
            Value::Error(failure) => return Err(failure.to_error()),
            value => scene.add(&at.to_string(), &Shapes::in_value(value)?, look.style(own)?)?,
        }
    }
    if scene.items.is_empty() {
        return Err(Error::format("sheet", None, "nothing is shown"));
    }
    Ok(())
}

/// The bytes of a picture, and of the file beside it if there is one.
pub(crate) fn picture<'py>(
    look: &Bound<'py, PyAny>,
    scene: impl FnOnce(&Look) -> Result<Scene> + Send,
) -> PyResult<Vec<Bound<'py, PyBytes>>> {
    let py = look.py();
    let look: Look = look.extract()?;
    let files = done(py, usize::MAX, || {
        let format = Format::of_name(&look.name)?;
        let scene = Scene { axes: look.axes, ..scene(&look)? };
        Ok(match format {
            Format::Obj => vec![obj::write(&scene, Some(&look.library))?, obj::materials(&scene)],
            _ => vec![write_scene(format, &scene)?],
        })
    })?;
    Ok(files.iter().map(|bytes| PyBytes::new(py, bytes)).collect())
}

/// The forms and the meshes that are given, one or a list of both.
fn drawable(what: &Bound<'_, PyAny>) -> PyResult<(Vec<Shape>, Vec<Mesh>)> {
    if meshes::is_mesh(what) {
        return Ok((Vec::new(), vec![meshes::read("what", what)?]));
    }
    if shapes::is_shape(what) || what.try_iter().is_err() {
        return Ok((shapes::list("what", what)?, Vec::new()));
    }
    let (mut list, mut found) = (Vec::new(), Vec::new());
    for item in what.try_iter()? {
        let item = item?;
        if meshes::is_mesh(&item) {
            found.push(meshes::read("what", &item)?);
        } else if shapes::is_shape(&item) {
            list.push(shapes::read("what", &item)?);
        } else {
            return Err(mistyped("what", &item, "a pforms.Form, a pforms.Spline or a pforms.Mesh"));
        }
    }
    Ok((list, found))
}

/// The picture of some forms and meshes in one style.
#[pyfunction]
pub(crate) fn _draw_forms<'py>(
    forms: &Bound<'py, PyAny>,
    look: &Bound<'py, PyAny>,
) -> PyResult<Vec<Bound<'py, PyBytes>>> {
    let (list, meshes) = drawable(forms)?;
    if list.is_empty() && meshes.is_empty() {
        return Err(raised(&Error::shape("what", "no forms", "at least one form")));
    }
    picture(look, |look| {
        let none = Settings::new();
        let mut scene = Scene { camera: look.camera(&none)?, ..Scene::default() };
        scene.add("form", &Shapes::of_all(list).with(meshes), look.style(&none)?)?;
        Ok(scene)
    })
}
