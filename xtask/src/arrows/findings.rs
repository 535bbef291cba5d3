//! What a check found: places and what is wrong there.

use std::fmt;
use std::path::{Path, PathBuf};

/// A growing list of findings, and the count of files that were looked at.
#[derive(Debug, Default)]
pub(super) struct Findings {
    lines: Vec<String>,
    files: usize,
}

impl Findings {
    /// Notes that a file was read.
    pub(super) fn read(&mut self) {
        self.files += 1;
    }

    /// Notes what is wrong in a file; `line` counts from 1, and 0 stands for the whole file.
    pub(super) fn add(&mut self, file: &Path, line: usize, message: impl fmt::Display) {
        let place = match line {
            0 => file.display().to_string(),
            _ => format!("{}:{line}", file.display()),
        };
        self.lines.push(format!("{place}: {message}"));
    }

    pub(super) fn is_empty(&self) -> bool {
        self.lines.is_empty()
    }

    pub(super) fn files_read(&self) -> usize {
        self.files
    }
}

impl fmt::Display for Findings {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{}", self.lines.join("\n"))
    }
}

/// All files below `folder` whose name ends in one of `endings`, sorted. A missing folder has none.
pub(super) fn files_below(folder: &Path, endings: &[&str]) -> std::io::Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    if !folder.is_dir() {
        return Ok(found);
    }
    for entry in std::fs::read_dir(folder)? {
        let path = entry?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if path.is_dir() {
            if !matches!(&*name, "node_modules" | "target" | "dist") {
                found.extend(files_below(&path, endings)?);
            }
        } else if endings.iter().any(|ending| name.ends_with(ending)) {
            found.push(path);
        }
    }
    found.sort();
    Ok(found)
}
