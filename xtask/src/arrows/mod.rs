//! The check that imports point one way. Each file asks one question and lists what breaks it.

mod catalogue;
mod findings;
mod manifests;
mod rooms;
mod source;
mod studio;

use std::path::Path;

use anyhow::{Result, bail};
use findings::Findings;

/// Fails with one line per finding, or says in one line that there is none.
pub(crate) fn check(root: &Path) -> Result<()> {
    let mut findings = Findings::default();
    manifests::check(root, &mut findings)?;
    rooms::check(root, &mut findings)?;
    studio::check(root, &mut findings)?;
    catalogue::check(root, &mut findings)?;
    if findings.is_empty() {
        println!("arrows: {} files read, none turned", findings.files_read());
        return Ok(());
    }
    bail!("{findings}");
}
