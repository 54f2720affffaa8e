//! Copies files of the kit to a handout.

use std::path::Path;

use anyhow::Result;

use lab_kit::files::read_bytes;
use lab_kit::starter::Files;
use lab_kit::{Kit, sources_below};

/// Adds a file at its path in the kit.
pub(super) fn add(kit: &Kit, files: &mut Files, path: &Path) -> Result<()> {
    files.insert(path.strip_prefix(kit.root())?.to_owned(), read_bytes(path)?);
    Ok(())
}

/// Adds all files of a folder, without files that builds and editors have left.
pub(super) fn add_all(kit: &Kit, files: &mut Files, folder: &Path) -> Result<()> {
    for path in sources_below(folder)? {
        if !path.strip_prefix(folder)?.iter().any(|part| part == "target") {
            add(kit, files, &path)?;
        }
    }
    Ok(())
}
