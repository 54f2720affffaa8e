//! Data that the command keeps from one call to the next: JSON files under `target/`.

use std::fs;

use anyhow::Result;
use serde::Serialize;
use serde::de::DeserializeOwned;

use lab_kit::Kit;
use lab_kit::files::write_file;

/// Reads the data kept as `name`; `None` if it cannot be read.
pub(crate) fn recall<T: DeserializeOwned>(kit: &Kit, name: &str) -> Option<T> {
    serde_json::from_str(&fs::read_to_string(kit.memory().join(name)).ok()?).ok()
}

/// Keeps `what` as `name`.
pub(crate) fn remember(kit: &Kit, name: &str, what: &impl Serialize) -> Result<()> {
    write_file(&kit.memory().join(name), serde_json::to_vec_pretty(what)?)
}
