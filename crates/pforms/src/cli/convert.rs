//! `pforms convert`: from one file format to another.

use std::path::PathBuf;

use clap::Args;
use serde_json::Map;

use super::{Outcome, input::Input, output};

/// Convert between file formats, told by the endings of the names.
///
/// Forms are read from .json, .bpt and .pfs (what the sheet shows) and written to .json and .bpt
/// as they are, to .glb, .obj, .stl and .pov as they are drawn.
#[derive(Args)]
pub(crate) struct Convert {
    /// A .pfs, .json or .bpt file; - reads standard input.
    input: PathBuf,
    /// The file to write: .json .bpt .glb .obj .stl .pov
    output: PathBuf,
}

impl Convert {
    pub(crate) fn run(self) -> Outcome {
        let input = Input::open(&self.input)?;
        output::write(&self.output, &input, &[], &Map::new(), &Map::new(), true)?;
        Ok(true)
    }
}
