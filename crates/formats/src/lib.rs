//! File formats: bytes in, bytes out. No file system.
//!
//! [`json`] and [`bpt`] hold forms; [`glb`], [`obj`], [`stl`] and [`pov`] hold a drawn scene.

pub mod bpt;
mod format;
pub mod glb;
pub mod json;
mod named;
pub mod obj;
pub mod pov;
mod solid;
pub mod stl;
mod tokens;

use pforms_kernel::{Error, Result};
use pforms_scene::Scene;

pub use format::{FORMATS, Format};
pub use named::Named;

/// Reads forms; the format is told by the name if it is one of forms, else by the content.
///
/// Errors: `Format`, with line and column where they are known.
pub fn read(name: &str, bytes: &[u8]) -> Result<Vec<Named>> {
    let named = Format::of_name(name).ok().filter(|format| format.holds_forms());
    match named.or_else(|| Format::of_content(bytes)) {
        Some(Format::Bpt) => bpt::read(bytes),
        Some(_) => json::read(bytes),
        None => Err(Error::format(name, None, "neither a JSON document nor Bézier patches (.bpt)")),
    }
}

/// Writes forms.
///
/// Errors: `Format` for a format of drawings; those of the format.
pub fn write_forms(format: Format, forms: &[Named]) -> Result<Vec<u8>> {
    match format {
        Format::Json => Ok(json::write(forms)),
        Format::Bpt => bpt::write(forms),
        other => Err(Error::format(other.extension(), None, "holds a drawing, not forms")),
    }
}

/// Writes a drawn scene; an OBJ without its colours, which [`obj::materials`] writes.
///
/// Errors: `Format` for a format of forms; those of the format.
pub fn write_scene(format: Format, scene: &Scene) -> Result<Vec<u8>> {
    match format {
        Format::Glb => glb::write(scene),
        Format::Obj => obj::write(scene, None),
        Format::Stl => stl::write(scene),
        Format::Pov => pov::write(scene),
        other => Err(Error::format(other.extension(), None, "holds forms, not a drawing")),
    }
}
