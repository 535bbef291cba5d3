//! In the studio only `engine/` names the WebAssembly package.

use std::path::Path;

use anyhow::Result;

use super::findings::{Findings, files_below};

/// Reads every TypeScript file outside `engine/`.
pub(super) fn check(root: &Path, findings: &mut Findings) -> Result<()> {
    let sources = root.join("studio/src");
    for file in files_below(&sources, &[".ts", ".tsx"])? {
        findings.read();
        if file.starts_with(sources.join("engine")) {
            continue;
        }
        let text = std::fs::read_to_string(&file)?;
        for (number, line) in text.lines().enumerate() {
            if imports_wasm(line) {
                let shown = file.strip_prefix(root)?;
                findings.add(shown, number + 1, "only `engine/` may import the wasm package");
            }
        }
    }
    Ok(())
}

fn imports_wasm(line: &str) -> bool {
    let imports = line.contains("from ") || line.contains("import(") || line.contains("import ");
    let quoted = line.split(['"', '\'', '`']).skip(1).step_by(2);
    imports && quoted.into_iter().any(|path| path.split('/').any(|part| part == "wasm"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_import_of_the_package_is_seen_and_prose_is_not() {
        assert!(imports_wasm("import init from '../engine/wasm/pforms_wasm.js';"));
        assert!(imports_wasm("const m = await import(\"./wasm/pforms_wasm\");"));
        assert!(!imports_wasm("import { engine } from '../engine/client';"));
        assert!(!imports_wasm("// the wasm package is imported from engine/ only"));
    }
}
