//! Files in, files out; `-` is standard input.

use std::io::Read;
use std::path::Path;

use pforms_kernel::Error;

/// Largest file that is read: 256 MiB.
const CAP: u64 = 1 << 28;

/// The bytes of a file, or of standard input for `-`. Complaints name the file.
pub(crate) fn read(path: &Path) -> Result<Vec<u8>, Box<dyn std::error::Error>> {
    let named = |error: std::io::Error| format!("{}: {error}", path.display());
    let mut bytes = Vec::new();
    let count = if path == Path::new("-") {
        std::io::stdin().lock().take(CAP + 1).read_to_end(&mut bytes).map_err(named)?
    } else {
        let file = std::fs::File::open(path).map_err(named)?;
        file.take(CAP + 1).read_to_end(&mut bytes).map_err(named)?
    };
    if count as u64 > CAP {
        return Err(format!("{}: larger than {CAP} bytes: refused", path.display()).into());
    }
    Ok(bytes)
}

/// Writes a file. Complaints name it.
pub(crate) fn write(path: &Path, bytes: &[u8]) -> Result<(), Box<dyn std::error::Error>> {
    std::fs::write(path, bytes).map_err(|error| format!("{}: {error}", path.display()).into())
}

/// The error of a file, its name in the place of the word "sheet".
pub(crate) fn in_file(name: &str, error: Error) -> Error {
    match error {
        Error::Format { place, message, .. } => {
            Error::Format { what: name.to_owned(), place, message }
        }
        other => other,
    }
}
