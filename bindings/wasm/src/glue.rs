//! The calls as JavaScript sees them: texts and numbers in, plain objects and typed arrays out.

#![expect(clippy::needless_pass_by_value, reason = "JavaScript hands its values over")]

use js_sys::{Array, Float32Array, JSON, Object, Reflect, Uint8Array, Uint32Array};
use pforms_catalogue::Language;
use pforms_sheet::Settings;
use serde::Serialize;
use serde::de::DeserializeOwned;
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};

use crate::{Answer, Drawing, Engine as Core, Gesture, Piece, Problem, Update};

#[wasm_bindgen]
extern "C" {
    #[wasm_bindgen(js_namespace = performance)]
    fn now() -> f64;

    #[wasm_bindgen(js_namespace = console, js_name = error)]
    fn report(message: &str);
}

fn seconds() -> f64 {
    now() / 1e3
}

/// The engine of the studio. Each call answers with an object, or throws a plain `{ message, hint, fatal }`.
#[wasm_bindgen]
#[derive(Debug)]
pub struct Engine(Core);

#[wasm_bindgen]
impl Engine {
    /// An empty sheet.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        std::panic::set_hook(Box::new(|fault| report(&format!("the kernel failed: {fault}"))));
        let mut core = Core::new();
        core.set_clock(seconds);
        Self(core)
    }

    /// See [`Core::open`].
    pub fn open(&mut self, text: &str) -> Result<JsValue, JsValue> {
        updated(self.0.open(text))
    }

    /// See [`Core::save`].
    pub fn save(&self) -> String {
        self.0.save()
    }

    /// See [`Core::snapshot`].
    pub fn snapshot(&mut self) -> Result<String, JsValue> {
        self.0.snapshot().map_err(thrown)
    }

    /// See [`Core::resume`].
    pub fn resume(&mut self, snapshot: &str) -> Result<JsValue, JsValue> {
        updated(self.0.resume(snapshot))
    }

    /// See [`Core::set`]; pairs of address and text.
    pub fn set(&mut self, entries: JsValue) -> Result<JsValue, JsValue> {
        let entries: Vec<(String, String)> = given(&entries)?;
        updated(self.0.set(&entries))
    }

    /// See [`Core::paste`].
    pub fn paste(&mut self, clip: JsValue, to: &str) -> Result<JsValue, JsValue> {
        updated(self.0.paste(&given(&clip)?, to))
    }

    /// See [`Core::fill`].
    pub fn fill(&mut self, from: &str, range: &str) -> Result<JsValue, JsValue> {
        updated(self.0.fill(from, range))
    }

    /// See [`Core::set_style`]; `null` hides the cell.
    #[wasm_bindgen(js_name = setStyle)]
    pub fn set_style(&mut self, address: &str, style: JsValue) -> Result<JsValue, JsValue> {
        let style: Option<Settings> = given(&style)?;
        updated(self.0.set_style(address, style))
    }

    /// See [`Core::begin_gesture`].
    #[wasm_bindgen(js_name = beginGesture)]
    pub fn begin_gesture(&mut self) -> JsValue {
        self.0.begin_gesture();
        JsValue::NULL
    }

    /// See [`Core::end_gesture`].
    #[wasm_bindgen(js_name = endGesture)]
    pub fn end_gesture(&mut self) -> Result<JsValue, JsValue> {
        updated(Ok(self.0.end_gesture()))
    }

    /// See [`Core::set_name`].
    #[wasm_bindgen(js_name = setName)]
    pub fn set_name(&mut self, address: &str, name: Option<String>) -> Result<JsValue, JsValue> {
        updated(self.0.set_name(address, name.as_deref()))
    }

    /// See [`Core::set_title`].
    #[wasm_bindgen(js_name = setTitle)]
    pub fn set_title(&mut self, title: &str) -> Result<JsValue, JsValue> {
        updated(self.0.set_title(title))
    }

    /// See [`Core::set_camera`]; what is `null` is left open.
    #[wasm_bindgen(js_name = setCamera)]
    pub fn set_camera(&mut self, camera: JsValue) -> Result<JsValue, JsValue> {
        let mut camera: Settings = given(&camera)?;
        camera.retain(|_, item| !item.is_null());
        self.0.set_camera(camera).map(|()| JsValue::NULL).map_err(thrown)
    }

    /// See [`Core::set_language`]; `fr` or `en`.
    #[wasm_bindgen(js_name = setLanguage)]
    pub fn set_language(&mut self, code: &str) -> Result<JsValue, JsValue> {
        let language = if code == "fr" { Language::French } else { Language::English };
        updated(Ok(self.0.set_language(language)))
    }

    /// See [`Core::undo`].
    pub fn undo(&mut self) -> Result<JsValue, JsValue> {
        updated(Ok(self.0.undo()))
    }

    /// See [`Core::redo`].
    pub fn redo(&mut self) -> Result<JsValue, JsValue> {
        updated(Ok(self.0.redo()))
    }

    /// See [`Core::proceed`].
    pub fn proceed(&mut self) -> Result<JsValue, JsValue> {
        updated(Ok(self.0.proceed()))
    }

    /// See [`Core::move_pole`]; the gesture is `begin`, `during` or `end`.
    #[wasm_bindgen(js_name = movePole)]
    pub fn move_pole(
        &mut self,
        address: &str,
        index: Vec<u32>,
        to: Vec<f64>,
        step: f64,
        gesture: &str,
    ) -> Result<JsValue, JsValue> {
        let gesture = match gesture {
            "begin" => Gesture::Begin,
            "end" => Gesture::End,
            _ => Gesture::During,
        };
        updated(self.0.move_pole(address, &indices(&index), &to, step, gesture))
    }

    /// See [`Core::type_pole`].
    #[wasm_bindgen(js_name = typePole)]
    pub fn type_pole(
        &mut self,
        address: &str,
        index: Vec<u32>,
        texts: Vec<String>,
    ) -> Result<JsValue, JsValue> {
        updated(self.0.type_pole(address, &indices(&index), &texts))
    }

    /// See [`Core::assist`].
    pub fn assist(&self, text: &str, caret: usize) -> Result<JsValue, JsValue> {
        plain(&self.0.assist(text, caret))
    }

    /// See [`Core::catalogue`].
    pub fn catalogue(&self) -> Result<JsValue, JsValue> {
        plain(&self.0.catalogue())
    }

    /// See [`Core::import`].
    #[wasm_bindgen(js_name = importFile)]
    pub fn import_file(&mut self, name: &str, bytes: &[u8]) -> Result<JsValue, JsValue> {
        updated(self.0.import(name, bytes))
    }

    /// See [`Core::export`]; a list of `{ name, bytes }`.
    #[wasm_bindgen(js_name = exportFile)]
    pub fn export_file(&self, format: &str, stem: &str) -> Result<JsValue, JsValue> {
        let files = Array::new();
        for file in self.0.export(format, stem).map_err(thrown)? {
            let object = Object::new();
            put(&object, "name", &file.name.as_str().into())?;
            put(&object, "bytes", &Uint8Array::from(file.bytes.as_slice()))?;
            files.push(&object);
        }
        Ok(files.into())
    }
}

impl Default for Engine {
    fn default() -> Self {
        Self::new()
    }
}

fn indices(index: &[u32]) -> Vec<usize> {
    index.iter().map(|at| *at as usize).collect()
}

/// An update with its drawings as typed arrays.
fn updated(answer: Answer) -> Result<JsValue, JsValue> {
    let update: Update = answer.map_err(thrown)?;
    let object = plain(&update)?;
    let drawings = Array::new();
    for drawing in &update.drawings {
        drawings.push(&drawn(drawing)?);
    }
    put(&object, "drawings", &drawings)?;
    Ok(object)
}

fn drawn(drawing: &Drawing) -> Result<JsValue, JsValue> {
    let object = Object::new();
    let color: Array = drawing.color.iter().map(|channel| JsValue::from(*channel)).collect();
    put(&object, "address", &drawing.address.as_str().into())?;
    put(&object, "color", &color)?;
    put(&object, "opacity", &drawing.opacity.into())?;
    let shape = drawing.shape.as_deref().map_or(Ok(JsValue::NULL), shaped)?;
    put(&object, "shape", &shape)?;
    Ok(object.into())
}

fn shaped(pieces: &[Piece]) -> Result<JsValue, JsValue> {
    let (meshes, points) = (Array::new(), Array::new());
    for piece in pieces {
        let part = Object::new();
        match piece {
            Piece::Mesh { positions, normals, indices } => {
                let triangles = indices.as_deref().map(Uint32Array::from);
                put(&part, "positions", &floats(positions))?;
                put(&part, "normals", &floats(normals))?;
                put(&part, "indices", &triangles.map_or(JsValue::NULL, JsValue::from))?;
                meshes.push(&part);
            }
            Piece::Balls { positions, radius } => {
                put(&part, "positions", &floats(positions))?;
                put(&part, "radius", &(*radius).into())?;
                points.push(&part);
            }
        }
    }
    let shape = Object::new();
    put(&shape, "meshes", &meshes)?;
    put(&shape, "points", &points)?;
    Ok(shape.into())
}

fn floats(numbers: &[f32]) -> Float32Array {
    Float32Array::from(numbers)
}

fn put(object: &JsValue, key: &str, value: &JsValue) -> Result<(), JsValue> {
    Reflect::set(object, &key.into(), value).map(|_| ())
}

/// A plain JavaScript object.
fn plain<T: Serialize>(value: &T) -> Result<JsValue, JsValue> {
    let text = serde_json::to_string(value).map_err(|error| JsValue::from(error.to_string()))?;
    JSON::parse(&text)
}

/// What JavaScript handed in.
fn given<T: DeserializeOwned>(value: &JsValue) -> Result<T, JsValue> {
    let text = JSON::stringify(value)?.as_string().unwrap_or_else(|| "null".to_owned());
    serde_json::from_str(&text)
        .map_err(|error| thrown(Problem { message: error.to_string(), hint: None, fatal: false }))
}

fn thrown(problem: Problem) -> JsValue {
    plain(&problem).unwrap_or_else(|error| error)
}
