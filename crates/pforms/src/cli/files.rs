//! Files in, files out; `-` is standard input.

use std::io::Read;
use std::path::Path;

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
