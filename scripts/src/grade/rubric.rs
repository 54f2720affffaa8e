//! Points per task: `tests/rubric.toml`.

use std::collections::BTreeMap;
use std::fs;

use anyhow::{Context, Result};
use serde::Deserialize;

use crate::kit::{Kit, Lab};

/// What a lab's tasks are worth.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Rubric {
    /// Points by task, such as `1.3`.
    pub(crate) tasks: BTreeMap<String, f64>,
}

/// The rubric of a lab.
///
/// # Errors
/// The file cannot be read, or the lab is not in it.
pub(crate) fn read(kit: &Kit, lab: Lab) -> Result<Rubric> {
    let text = fs::read_to_string(kit.path("tests/rubric.toml"))
        .context("cannot read tests/rubric.toml")?;
    let mut labs: BTreeMap<String, Rubric> = toml::from_str(&text).context("tests/rubric.toml")?;
    labs.remove(&format!("lab{lab}")).with_context(|| {
        format!("tests/rubric.toml says nothing about lab {lab}: it cannot be graded")
    })
}

/// The labs that can be graded, in order.
///
/// # Errors
/// The file cannot be read.
pub(crate) fn labs(kit: &Kit) -> Result<Vec<Lab>> {
    let text = fs::read_to_string(kit.path("tests/rubric.toml"))
        .context("cannot read tests/rubric.toml")?;
    let labs: BTreeMap<String, Rubric> = toml::from_str(&text).context("tests/rubric.toml")?;
    let mut labs: Vec<Lab> = labs.keys().filter_map(|name| name.parse().ok()).collect();
    labs.sort();
    Ok(labs)
}
