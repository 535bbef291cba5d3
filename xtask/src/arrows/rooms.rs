//! Inside `crates/operators`: `algebra ← measuring ← making`, and no tolerance in `algebra`.

use std::path::{Component, Path};

use anyhow::{Context, Result};

use super::findings::{Findings, files_below};
use super::source::{self, Mention};

/// The rooms in the order of their arrows: each may import those before it.
const ROOMS: [&str; 3] = ["algebra", "measuring", "making"];

/// Below this, a positive number literal is a tolerance and no coefficient.
const SMALLEST_COEFFICIENT: f64 = 1e-3;

/// For each room, the names it hands to the crate's front door.
type Exports = [Vec<String>; ROOMS.len()];

/// A file of a room: where it is shown to be, its module path, its room's place, its text.
struct SourceFile<'a> {
    shown: &'a Path,
    module: Vec<String>,
    room: usize,
    text: &'a str,
}

/// Reads every source file of the three rooms.
pub(super) fn check(root: &Path, findings: &mut Findings) -> Result<()> {
    let sources = root.join("crates/operators/src");
    let mut exports = Exports::default();
    for (names, room) in exports.iter_mut().zip(ROOMS) {
        let door = sources.join(room).join("mod.rs");
        if door.exists() {
            *names = exported(&std::fs::read_to_string(door)?)?;
        }
    }
    for (place, room) in ROOMS.iter().enumerate() {
        for file in files_below(&sources.join(room), &[".rs"])? {
            let text = std::fs::read_to_string(&file)?;
            let module = module_of(file.strip_prefix(&sources)?);
            let shown = file.strip_prefix(root)?;
            let source = SourceFile { shown, module, room: place, text: &text };
            check_file(&source, &exports, findings)
                .with_context(|| format!("{} cannot be read", shown.display()))?;
        }
    }
    Ok(())
}

fn check_file(file: &SourceFile<'_>, exports: &Exports, findings: &mut Findings) -> Result<()> {
    findings.read();
    let mentions = source::mentions(file.text)?;
    for path in &mentions.paths {
        let target = resolve(&file.module, &path.text);
        if let Some(room) = room_of(&target, exports).filter(|room| *room > file.room) {
            let (here, there) = (ROOMS[file.room], ROOMS[room]);
            findings.add(file.shown, path.line, format!("`{here}` may not import `{there}`"));
        }
    }
    if ROOMS[file.room] == "algebra" {
        check_exact(file.shown, &mentions, findings);
    }
    Ok(())
}

/// The room a path from the crate's root leads into, by its folder or through the front door.
fn room_of(target: &[String], exports: &Exports) -> Option<usize> {
    let first = target.first()?;
    let folder = ROOMS.iter().position(|room| first == room);
    folder.or_else(|| exports.iter().position(|names| target.len() == 1 && names.contains(first)))
}

/// The names that a room's `mod.rs` re-exports.
fn exported(door: &str) -> Result<Vec<String>> {
    let mentions = source::mentions(door)?;
    let last = |path: &Mention| path.text.rsplit("::").next().map(str::to_owned);
    Ok(mentions.paths.iter().filter_map(last).collect())
}

/// A multiple of `f64::EPSILON` states a rounding and decides nothing: it is let through.
fn check_exact(file: &Path, mentions: &source::Mentions, findings: &mut Findings) {
    for number in mentions.floats.iter().filter(|float| is_tolerance(float)) {
        let message = format!("`{}` is a tolerance: algebra is exact", number.text);
        findings.add(file, number.line, message);
    }
}

fn is_tolerance(literal: &Mention) -> bool {
    let digits = literal.text.replace('_', "");
    let number = digits.trim_end_matches("f64").trim_end_matches("f32");
    number.parse::<f64>().is_ok_and(|value| value > 0.0 && value < SMALLEST_COEFFICIENT)
}

/// `algebra/immerse/plan.rs` is the module `algebra::immerse::plan`; a `mod.rs` is its folder.
fn module_of(file: &Path) -> Vec<String> {
    let mut names: Vec<String> = file
        .with_extension("")
        .components()
        .filter_map(|part| match part {
            Component::Normal(name) => Some(name.to_string_lossy().into_owned()),
            _ => None,
        })
        .collect();
    names.pop_if(|name| name == "mod");
    names
}

/// A path from the crate's root: `crate::`, `self::` and `super::` are followed from `module`.
/// A path of another crate, or to a local name, stays outside the rooms and is empty.
fn resolve(module: &[String], path: &str) -> Vec<String> {
    let mut names = path.split("::").peekable();
    let mut target = match names.peek() {
        Some(&"crate") => Vec::new(),
        Some(&("self" | "super")) => module.to_vec(),
        _ => return Vec::new(),
    };
    for name in names {
        match name {
            "crate" | "self" => {}
            "super" => drop(target.pop()),
            _ => target.push(name.to_owned()),
        }
    }
    target
}

#[cfg(test)]
mod tests {
    use super::*;

    fn findings_of(file: &str, text: &str) -> String {
        let mut findings = Findings::default();
        let shown = Path::new(file);
        let module = module_of(shown);
        let room = ROOMS.iter().position(|room| *room == module[0]).unwrap();
        let exports = ["elevate", "length", "fit"].map(|name| vec![name.to_owned()]);
        check_file(&SourceFile { shown, module, room, text }, &exports, &mut findings).unwrap();
        findings.to_string()
    }

    #[test]
    fn imports_along_the_arrow_are_silent() {
        assert_eq!(findings_of("making/fit.rs", "use crate::algebra::elevate;"), "");
        assert_eq!(findings_of("making/fit.rs", "use super::super::measuring::length;"), "");
        assert_eq!(findings_of("algebra/immerse/plan.rs", "use super::making;"), "");
    }

    #[test]
    fn imports_against_the_arrow_are_named() {
        let expected = "algebra/elevate.rs:1: `algebra` may not import `making`";
        assert_eq!(findings_of("algebra/elevate.rs", "use crate::making::fit;"), expected);
        assert_eq!(findings_of("algebra/elevate.rs", "use super::super::making::fit;"), expected);
        assert_eq!(
            findings_of("measuring/length.rs", "fn f() {\n    crate::making::fit()\n}"),
            "measuring/length.rs:2: `measuring` may not import `making`"
        );
    }

    #[test]
    fn the_front_door_is_no_way_around() {
        assert_eq!(findings_of("making/arc.rs", "use crate::{elevate, fit};"), "");
        assert_eq!(
            findings_of("algebra/elevate.rs", "use crate::fit;"),
            "algebra/elevate.rs:1: `algebra` may not import `making`"
        );
        assert_eq!(
            exported("mod fit;\npub use fit::{Fit, fit as fitted};").unwrap(),
            ["Fit", "fit"]
        );
    }

    #[test]
    fn a_tolerance_in_algebra_is_named_and_a_coefficient_is_not() {
        assert_eq!(findings_of("algebra/elevate.rs", "const HALF: f64 = 0.5;"), "");
        assert_eq!(
            findings_of("algebra/elevate.rs", "const SMALL: f64 = 1e-9;"),
            "algebra/elevate.rs:1: `1e-9` is a tolerance: algebra is exact"
        );
        assert_eq!(findings_of("algebra/reduce.rs", "fn f() -> f64 { f64::EPSILON }"), "");
        assert_eq!(findings_of("measuring/length.rs", "const SMALL: f64 = 1e-9;"), "");
    }
}
