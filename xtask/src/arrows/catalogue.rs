//! Every operator of the catalogue has a golden case, and a page that calls it in three ways.
//!
//! The elementary functions of a group share one page, which names each of them.

use std::path::Path;
use std::process::Command;

use anyhow::{Context, Result, ensure};
use serde::Deserialize;

use super::findings::Findings;

/// Groups whose entries share a page: they are words of the formula language, known from anywhere.
const ELEMENTARY: [&str; 2] = ["numbers", "lists"];

/// The three ways to say it, by the mark of their fence.
const WAYS: [&str; 3] = ["```rust", "```python", "```sheet"];

/// What is read of an entry.
#[derive(Debug, Deserialize)]
struct Entry {
    name: String,
    english: Vec<String>,
    group: String,
}

/// Asks the command line for the catalogue, and looks for the files that belong to each entry.
pub(super) fn check(root: &Path, findings: &mut Findings) -> Result<()> {
    for entry in entries(root)? {
        findings.read();
        if ELEMENTARY.contains(&entry.group.as_str()) {
            check_shared_page(root, &entry, findings);
        } else {
            check_page(root, &entry.name, findings);
            check_case(root, &entry.name, findings);
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
    serde_json::from_slice(&output.stdout).context("`pforms operators --json` is no list of entries")
}

fn check_case(root: &Path, name: &str, findings: &mut Findings) {
    let file = format!("cases/operators/{name}.json");
    if !root.join(&file).exists() {
        findings.add(Path::new(&file), 0, format!("`{name}` lacks its golden case"));
    }
}

fn check_page(root: &Path, name: &str, findings: &mut Findings) {
    let file = format!("book/src/operators/{name}.md");
    let Ok(text) = std::fs::read_to_string(root.join(&file)) else {
        return findings.add(Path::new(&file), 0, format!("`{name}` lacks its page"));
    };
    for way in WAYS.iter().filter(|way| !text.contains(*way)) {
        findings.add(Path::new(&file), 0, format!("`{name}` is not called in a {way} fence"));
    }
}

fn check_shared_page(root: &Path, entry: &Entry, findings: &mut Findings) {
    let file = format!("book/src/operators/{}.md", entry.group);
    let text = std::fs::read_to_string(root.join(&file)).unwrap_or_default();
    let Some(word) = entry.english.first() else { return };
    if !text.contains(&format!("`{word}")) {
        findings.add(Path::new(&file), 0, format!("`{word}` is not named"));
    }
}
