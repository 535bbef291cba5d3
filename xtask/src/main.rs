//! Steps of the build, under the names the Makefile and `.ci/run` use.
//!
//! ```text
//! cargo xtask wasm INPUT.wasm OUTDIR   JavaScript and TypeScript bindings of a compiled module
//! cargo xtask arrows                   imports point one way, and the catalogue is complete
//! ```

mod arrows;
mod javascript;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

const USAGE: &str = "usage: cargo xtask wasm INPUT.wasm OUTDIR | cargo xtask arrows";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let outcome = match words.as_slice() {
        ["wasm", input, outdir] => javascript::generate(Path::new(input), Path::new(outdir)),
        ["arrows"] => arrows::check(&root()),
        _ => Err(anyhow::anyhow!(USAGE)),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error:#}");
            ExitCode::FAILURE
        }
    }
}

/// The repository's root: the folder above this crate's, as cargo tells when it runs us.
fn root() -> PathBuf {
    let here = std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_else(|| "xtask".into());
    PathBuf::from(here).join("..")
}
