//! Which crate may name which in its manifest.
//!
//! ```text
//! kernel ← operators ← mesh ← catalogue ← { scene, sheet } ← { python, wasm, pforms }
//! { kernel, operators, mesh, scene } ← formats ← faces        formula ← sheet
//! ```
//!
//! The compiler refuses a path to a crate that the manifest lacks, so the manifests are enough.
//! Dependencies of tests are free: they never reach a user.

use std::path::Path;

use anyhow::{Context, Result};

use super::findings::{Findings, files_below};

/// A crate, and the crates of ours it may import.
const MAY_IMPORT: &[(&str, &[&str])] = &[
    ("pforms-kernel", &[]),
    ("pforms-formula", &[]),
    ("pforms-operators", &["pforms-kernel"]),
    ("pforms-mesh", &["pforms-kernel", "pforms-operators"]),
    ("pforms-catalogue", &["pforms-kernel", "pforms-operators", "pforms-mesh"]),
    ("pforms-scene", &["pforms-kernel", "pforms-operators", "pforms-mesh", "pforms-catalogue"]),
    (
        "pforms-sheet",
        &["pforms-kernel", "pforms-operators", "pforms-mesh", "pforms-catalogue", "pforms-formula"],
    ),
    ("pforms-formats", &["pforms-kernel", "pforms-operators", "pforms-mesh", "pforms-scene"]),
    ("pforms-testkit", &["pforms-kernel"]),
    ("pforms", LIBRARIES),
    ("pforms-python", LIBRARIES),
    ("pforms-wasm", LIBRARIES),
    ("pforms-benches", LIBRARIES),
    ("pforms-book", LIBRARIES),
    ("xtask", LIBRARIES),
];

/// What a face may import: every library, but no other face and nothing made for tests.
const LIBRARIES: &[&str] = &[
    "pforms-kernel",
    "pforms-operators",
    "pforms-mesh",
    "pforms-catalogue",
    "pforms-scene",
    "pforms-formats",
    "pforms-formula",
    "pforms-sheet",
];

/// Reads every manifest of the workspace.
pub(super) fn check(root: &Path, findings: &mut Findings) -> Result<()> {
    for folder in ["crates", "bindings", "benches", "book", "xtask"] {
        for file in files_below(&root.join(folder), &["Cargo.toml"])? {
            let text = std::fs::read_to_string(&file)?;
            let shown = file.strip_prefix(root).unwrap_or(&file);
            check_manifest(shown, &text, findings)
                .with_context(|| format!("{} cannot be read", shown.display()))?;
        }
    }
    Ok(())
}

fn check_manifest(file: &Path, text: &str, findings: &mut Findings) -> Result<()> {
    findings.read();
    let manifest: toml::Table = text.parse()?;
    let name = package_name(&manifest).context("no package name")?;
    let Some((_, allowed)) = MAY_IMPORT.iter().find(|(crate_name, _)| *crate_name == name) else {
        findings.add(file, 0, format!("`{name}` has no place among the arrows yet"));
        return Ok(());
    };
    for dependency in dependencies(&manifest) {
        let ours = dependency == "pforms" || dependency.starts_with("pforms-");
        if ours && !allowed.contains(&dependency.as_str()) {
            findings.add(file, 0, format!("`{name}` may not import `{dependency}`"));
        }
    }
    Ok(())
}

fn package_name(manifest: &toml::Table) -> Option<&str> {
    manifest.get("package")?.get("name")?.as_str()
}

/// Names of all dependencies that reach a user: ordinary, of build scripts, and of one platform.
fn dependencies(manifest: &toml::Table) -> Vec<String> {
    let platforms = manifest.get("target").and_then(toml::Value::as_table);
    let platforms =
        platforms.into_iter().flat_map(toml::Table::values).filter_map(toml::Value::as_table);
    std::iter::once(manifest)
        .chain(platforms)
        .flat_map(|table| ["dependencies", "build-dependencies"].map(|kind| table.get(kind)))
        .flatten()
        .filter_map(toml::Value::as_table)
        .flatten()
        .map(|(key, value)| {
            value.get("package").and_then(toml::Value::as_str).unwrap_or(key).to_owned()
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn findings_of(text: &str) -> String {
        let mut findings = Findings::default();
        check_manifest(Path::new("x/Cargo.toml"), text, &mut findings).unwrap();
        findings.to_string()
    }

    #[test]
    fn an_arrow_that_follows_the_drawing_is_silent() {
        let text = "[package]\nname = 'pforms-mesh'\n[dependencies]\npforms-kernel.workspace = true\nserde = '1'";
        assert_eq!(findings_of(text), "");
    }

    #[test]
    fn a_turned_arrow_is_named() {
        let text =
            "[package]\nname = 'pforms-kernel'\n[dependencies]\npforms-mesh.workspace = true";
        assert_eq!(findings_of(text), "x/Cargo.toml: `pforms-kernel` may not import `pforms-mesh`");
    }

    #[test]
    fn a_renamed_or_platform_dependency_is_seen() {
        let renamed =
            "[package]\nname = 'pforms-formula'\n[dependencies]\nk = { package = 'pforms-kernel' }";
        assert!(findings_of(renamed).contains("may not import `pforms-kernel`"));
        let platform = "[package]\nname = 'pforms-formula'\n[target.'cfg(unix)'.dependencies]\npforms-kernel = '1'";
        assert!(findings_of(platform).contains("may not import `pforms-kernel`"));
    }

    #[test]
    fn tests_may_import_what_they_like() {
        let text = "[package]\nname = 'pforms-kernel'\n[dev-dependencies]\npforms-testkit.workspace = true";
        assert_eq!(findings_of(text), "");
    }

    #[test]
    fn an_unknown_crate_is_asked_to_find_its_place() {
        assert!(
            findings_of("[package]\nname = 'pforms-more'").contains("no place among the arrows")
        );
    }
}
