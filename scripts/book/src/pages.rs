//! The book's pages, as the checks read them.

use std::collections::BTreeMap;

use anyhow::Result;

use lab_kit::Kit;
use lab_kit::files::{files_below, read_text};

/// The text of every page by its name in the kit, such as `book/src/instructor/mistakes.md`.
///
/// # Errors
/// A page cannot be read.
pub(crate) fn pages(kit: &Kit) -> Result<BTreeMap<String, String>> {
    let files = files_below(&kit.path("book/src"))?.into_iter();
    let pages = files.filter(|path| path.extension().is_some_and(|e| e == "md"));
    let named = |path: std::path::PathBuf| {
        let name = path.strip_prefix(kit.root()).unwrap_or(&path).display().to_string();
        Ok((name, read_text(&path)?))
    };
    pages.map(named).collect()
}
