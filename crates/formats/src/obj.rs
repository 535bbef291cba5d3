//! A drawn scene as Wavefront OBJ, with its colours in a companion `.mtl`.

use std::fmt::Write;

use pforms_kernel::Result;
use pforms_scene::Scene;

use crate::solid::all_triangles;

/// Writes a scene, a group for each drawn value; `library` is the name of the `.mtl` beside it.
///
/// Coordinates and normals are those of the sheet, to the last bit.
///
/// Errors: `Limit`.
pub fn write(scene: &Scene, library: Option<&str>) -> Result<Vec<u8>> {
    let mut text = String::from("# pforms\n");
    if let Some(library) = library {
        let _ = writeln!(text, "mtllib {library}");
    }
    let mut first = 1;
    for item in &scene.items {
        let mesh = all_triangles(item)?;
        let name = word(&item.name);
        let _ = writeln!(text, "o {name}\ng {name}");
        if library.is_some() {
            let _ = writeln!(text, "usemtl {name}");
        }
        for (letter, triples) in [("v", &mesh.positions), ("vn", &mesh.normals)] {
            for [x, y, z] in triples {
                let _ = writeln!(text, "{letter} {x} {y} {z}");
            }
        }
        for corners in &mesh.indices {
            let [a, b, c] = corners.map(|vertex| vertex as usize + first);
            let _ = writeln!(text, "f {a}//{a} {b}//{b} {c}//{c}");
        }
        first += mesh.positions.len();
    }
    Ok(text.into_bytes())
}

/// The companion: a material for each drawn value.
pub fn materials(scene: &Scene) -> Vec<u8> {
    let mut text = String::from("# pforms\n");
    for item in &scene.items {
        let [red, green, blue] = item.style.color.encoded();
        let _ = writeln!(
            text,
            "newmtl {}\nKd {red:.4} {green:.4} {blue:.4}\nKs 0.2 0.2 0.2\nNs 40\nd {}\nillum 2",
            word(&item.name),
            item.style.opacity,
        );
    }
    text.into_bytes()
}

/// The name without spaces and line breaks, which end a name in OBJ.
fn word(name: &str) -> String {
    let word: String =
        name.chars().map(|c| if c.is_whitespace() || c.is_control() { '_' } else { c }).collect();
    if word.is_empty() { "_".to_owned() } else { word }
}
