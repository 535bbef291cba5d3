//! A drawn scene as input for POV-Ray 3.7.
//!
//! Bicubic polynomial patches stay what they are (`bicubic_patch`), other surfaces become `mesh2`
//! with exact normals, points spheres, lines cylinders or, where one sees through them,
//! `sphere_sweep`. Background and lights are those of the book's pictures.

mod objects;
mod stage;

use pforms_kernel::Result;
use pforms_scene::Scene;

/// Writes a scene. It renders without a warning.
///
/// Errors: `Limit`.
pub fn write(scene: &Scene) -> Result<Vec<u8>> {
    let mut text = String::from("// pforms\n#version 3.7;\n");
    stage::write(&mut text, scene);
    for item in &scene.items {
        objects::write(&mut text, item)?;
    }
    Ok(text.into_bytes())
}

/// A vector in the language of POV-Ray.
fn vector([x, y, z]: [f64; 3]) -> String {
    format!("<{x:?}, {y:?}, {z:?}>")
}
