//! Collects the Rust examples of the manual: a module for each page, its examples in its
//! documentation, where `cargo test` finds them.

use std::fmt::Write as _;
use std::io::Result;
use std::path::Path;
use std::{env, fs};

fn main() -> Result<()> {
    println!("cargo::rerun-if-changed=src");
    let mut modules = String::new();
    collect(Path::new("src"), &mut modules)?;
    let out = env::var_os("OUT_DIR").unwrap_or_default();
    fs::write(Path::new(&out).join("examples.rs"), modules)
}

fn collect(folder: &Path, modules: &mut String) -> Result<()> {
    let mut paths = fs::read_dir(folder)?
        .map(|entry| entry.map(|entry| entry.path()))
        .collect::<Result<Vec<_>>>()?;
    paths.sort();
    for path in paths {
        if path.is_dir() {
            collect(&path, modules)?;
        } else if path.extension().is_some_and(|ending| ending == "md") {
            let examples = examples(&fs::read_to_string(&path)?);
            if !examples.is_empty() {
                let name = path.with_extension("").to_string_lossy().replace(['/', '\\', '-'], "_");
                let _ = writeln!(modules, "#[doc = {examples:?}]\npub mod {name} {{}}");
            }
        }
    }
    Ok(())
}

/// The fences marked `rust`, without the indentation of a tab.
fn examples(page: &str) -> String {
    let mut examples = String::new();
    let mut indentation = None;
    for line in page.lines() {
        let bare = line.trim_start();
        if bare == "```rust" {
            indentation = Some(line.len() - bare.len());
        }
        if let Some(width) = indentation {
            examples.push_str(line.get(width..).unwrap_or_default());
            examples.push('\n');
        }
        if bare == "```" {
            indentation = None;
        }
    }
    examples
}
