//! JavaScript and TypeScript bindings of a compiled WebAssembly module.

use std::path::Path;

use anyhow::{Context, Result};
use wasm_bindgen_cli_support::Bindgen;

/// Writes the ES module, its types and the stripped `.wasm` into `outdir`.
///
/// The module is written for browsers and workers, and knows the address of its `.wasm`.
pub(crate) fn generate(input: &Path, outdir: &Path) -> Result<()> {
    Bindgen::new()
        .input_path(input)
        .typescript(true)
        .web(true)?
        .omit_default_module_path(false)
        .remove_name_section(true)
        .remove_producers_section(true)
        .generate(outdir)
        .with_context(|| format!("no bindings for {}", input.display()))
}
