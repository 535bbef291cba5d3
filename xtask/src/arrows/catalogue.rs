//! Every operator of the catalogue has a golden case, and a page that calls it in three ways.
//!
//! Words that take forms apart, lists and elementary functions share a page with their group, and
//! the manual lists them there by itself.

use std::path::Path;
use std::process::Command;

use anyhow::{Context, Result, ensure};
use serde::Deserialize;

use super::findings::Findings;

/// Groups whose entries share a page.
const SHARED: [&str; 3] = ["forms", "lists", "numbers"];

/// The three ways to say it, by the mark of their fence.
const WAYS: [&str; 3] = ["```rust", "```python", "```sheet"];

/// What is read of an entry.
#[derive(Debug, Deserialize)]
struct Entry {
    name: String,
    group: String,
}

/// Asks the command line for the catalogue, and looks for the files that belong to each entry.
pub(super) fn check(root: &Path, findings: &mut Findings) -> Result<()> {
    for entry in entries(root)? {
        findings.read();
        if SHARED.contains(&entry.group.as_str()) {
            check_exists(root, &page_of(&entry.group), &entry.name, findings);
        } else {
            check_page(root, &entry.name, findings);
            check_exists(
                root,
                &format!("cases/operators/{}.json", entry.name),
                &entry.name,
                findings,
            );
        }
    }
    Ok(())
}

fn entries(root: &Path) -> Result<Vec<Entry>> {
    let output = Command::new(env!("CARGO"))
        .args(["run", "--locked", "--quiet", "--package", "pforms", "--"])
        .args(["operators", "--json"])
        .current_dir(root)
        .output()
        .context("cargo cannot be started")?;
    let complaint = String::from_utf8_lossy(&output.stderr);
    ensure!(output.status.success(), "`pforms operators --json` failed: {complaint}");
    serde_json::from_slice(&output.stdout)
        .context("`pforms operators --json` is no list of entries")
}

fn page_of(name: &str) -> String {
    format!("book/src/operators/{name}.md")
}

fn check_exists(root: &Path, file: &str, name: &str, findings: &mut Findings) {
    if !root.join(file).exists() {
        findings.add(Path::new(file), 0, format!("missing: `{name}` needs it"));
    }
}

fn check_page(root: &Path, name: &str, findings: &mut Findings) {
    let file = page_of(name);
    let Ok(text) = std::fs::read_to_string(root.join(&file)) else {
        return check_exists(root, &file, name, findings);
    };
    for way in WAYS.iter().filter(|way| !text.contains(*way)) {
        let language = way.trim_start_matches('`');
        findings.add(Path::new(&file), 0, format!("`{name}` is not called from {language}"));
    }
}
