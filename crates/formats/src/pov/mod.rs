//! A drawn scene as input for POV-Ray 3.7.
//!
//! Bicubic polynomial patches stay what they are (`bicubic_patch`), other surfaces become `mesh2`
//! with exact normals, points spheres, lines cylinders or, where one sees through them,
//! `sphere_sweep`. Background and lights are those of the book's pictures.

mod objects;
mod size;
mod stage;

use std::fmt::Write;

use pforms_kernel::Result;
use pforms_scene::Scene;

/// Writes a scene. It renders without a warning.
///
/// A very small or very large scene is scaled by a power of two, which a comment in the file
/// tells; otherwise coordinates are those of the sheet.
///
/// Errors: `Domain` for numbers near the largest there are; `Limit`.
pub fn write(scene: &Scene) -> Result<Vec<u8>> {
    let mut text = String::from("// pforms\n#version 3.7;\n");
    let factor = size::factor(scene);
    let scaled;
    let scene = if factor == 1.0 {
        scene
    } else {
        let _ = writeln!(text, "// All lengths are multiplied by {factor:e}.");
        scaled = size::scaled(scene, factor)?;
        &scaled
    };
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
