//! A drawn scene as binary glTF 2.0: a node for each drawn value, a primitive for each part.
//!
//! Coordinates are those of the sheet, unchanged, in single precision.

use pforms_kernel::{Error, Result};
use pforms_mesh::Triangles;
use pforms_scene::{Item, Scene, Style};
use serde_json::{Value, json};

use crate::solid::{single, triangles};

const FLOAT: u32 = 5126;
const UNSIGNED: u32 = 5125;
const VERTICES: u32 = 34962;
const INDICES: u32 = 34963;

/// Writes a scene. Values without triangles are left out.
///
/// Errors: `Domain` for coordinates beyond single precision; `Limit` when the file would exceed
/// 4 GB.
pub fn write(scene: &Scene) -> Result<Vec<u8>> {
    let mut file = File::default();
    for item in &scene.items {
        file.item(item)?;
    }
    file.bytes()
}

/// The arrays of a glTF file as they grow.
#[derive(Default)]
struct File {
    binary: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
    materials: Vec<Value>,
    meshes: Vec<Value>,
    nodes: Vec<Value>,
}

impl File {
    fn item(&mut self, item: &Item) -> Result<()> {
        let mut primitives = Vec::new();
        for part in &item.parts {
            let mesh = triangles(part)?;
            if !mesh.indices.is_empty() {
                primitives.push(self.primitive(&mesh)?);
            }
        }
        if primitives.is_empty() {
            return Ok(());
        }
        self.materials.push(material(&item.name, &item.style));
        self.nodes.push(json!({ "name": item.name, "mesh": self.meshes.len() }));
        self.meshes.push(json!({ "name": item.name, "primitives": primitives }));
        Ok(())
    }

    fn primitive(&mut self, mesh: &Triangles) -> Result<Value> {
        let count = mesh.positions.len();
        let start = self.binary.len();
        let mut low = [f32::INFINITY; 3];
        let mut high = [f32::NEG_INFINITY; 3];
        for position in &mesh.positions {
            for k in 0..3 {
                let x = single(position[k])?;
                (low[k], high[k]) = (low[k].min(x), high[k].max(x));
                self.binary.extend(x.to_le_bytes());
            }
        }
        let position = self.accessor(start, VERTICES, FLOAT, "VEC3", count);
        self.accessors[position]["min"] = json!(low.map(f64::from));
        self.accessors[position]["max"] = json!(high.map(f64::from));
        let start = self.binary.len();
        for x in mesh.normals.as_flattened() {
            self.binary.extend((*x as f32).to_le_bytes());
        }
        let normal = self.accessor(start, VERTICES, FLOAT, "VEC3", count);
        let start = self.binary.len();
        for index in mesh.indices.as_flattened() {
            self.binary.extend(index.to_le_bytes());
        }
        let indices = self.accessor(start, INDICES, UNSIGNED, "SCALAR", mesh.indices.len() * 3);
        Ok(json!({
            "attributes": { "POSITION": position, "NORMAL": normal },
            "indices": indices,
            "material": self.materials.len(),
        }))
    }

    /// A view of the bytes since `start`, and an accessor of it.
    fn accessor(
        &mut self,
        start: usize,
        target: u32,
        component: u32,
        shape: &str,
        count: usize,
    ) -> usize {
        self.views.push(json!({
            "buffer": 0,
            "byteOffset": start,
            "byteLength": self.binary.len() - start,
            "target": target,
        }));
        self.accessors.push(json!({
            "bufferView": self.views.len() - 1,
            "componentType": component,
            "count": count,
            "type": shape,
        }));
        self.accessors.len() - 1
    }

    fn bytes(self) -> Result<Vec<u8>> {
        let nodes: Vec<usize> = (0..self.nodes.len()).collect();
        let mut document = json!({
            "asset": { "version": "2.0", "generator": "pforms" },
            "scene": 0,
            "scenes": [{}],
        });
        // glTF knows no empty arrays.
        if !nodes.is_empty() {
            document["scenes"] = json!([{ "nodes": nodes }]);
            document["buffers"] = json!([{ "byteLength": self.binary.len() }]);
            for (key, list) in [
                ("nodes", self.nodes),
                ("meshes", self.meshes),
                ("materials", self.materials),
                ("accessors", self.accessors),
                ("bufferViews", self.views),
            ] {
                document[key] = Value::Array(list);
            }
        }
        container(document.to_string().into_bytes(), self.binary)
    }
}

/// Header, JSON chunk and binary chunk, each a multiple of 4 bytes.
fn container(mut text: Vec<u8>, mut binary: Vec<u8>) -> Result<Vec<u8>> {
    text.resize(text.len().next_multiple_of(4), b' ');
    binary.resize(binary.len().next_multiple_of(4), 0);
    let chunk = |bytes: &[u8]| if bytes.is_empty() { 0 } else { bytes.len() + 8 };
    let total = 12 + chunk(&text) + chunk(&binary);
    let length = u32::try_from(total).map_err(|_| Error::Limit {
        what: "the GLB file".to_owned(),
        bytes: total as u128,
        cap: u128::from(u32::MAX),
    })?;
    let mut file = Vec::with_capacity(total);
    file.extend(b"glTF");
    file.extend(2u32.to_le_bytes());
    file.extend(length.to_le_bytes());
    for (kind, bytes) in [(b"JSON", text), (b"BIN\0", binary)] {
        if !bytes.is_empty() {
            file.extend((bytes.len() as u32).to_le_bytes());
            file.extend(kind);
            file.extend(bytes);
        }
    }
    Ok(file)
}

fn material(name: &str, style: &Style) -> Value {
    let [red, green, blue] = style.color.linear();
    let mut material = json!({
        "name": name,
        "doubleSided": true,
        "pbrMetallicRoughness": {
            "baseColorFactor": [red, green, blue, style.opacity],
            "metallicFactor": 0.0,
            "roughnessFactor": 0.55,
        },
    });
    if style.opacity < 1.0 {
        material["alphaMode"] = json!("BLEND");
    }
    material
}
