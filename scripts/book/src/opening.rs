//! A chapter's opening, made from book/chapters.toml: what the reader can do afterwards, what to know before,
//! hours and difficulty of each task.

use std::collections::BTreeMap;

use anyhow::{Context, Result};
use serde::Deserialize;

use lab_kit::files::read_toml;
use lab_kit::{Kit, Lab, hints};

/// What a chapter's opening says.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Opening {
    needs: String,
    able: Vec<String>,
    before: Vec<String>,
    /// Hours for all but the tasks.
    reading: f64,
    pub(crate) tasks: BTreeMap<String, Task>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Task {
    hours: f64,
    /// Of difficulty, 1 to 3.
    mark: usize,
}

/// What the file says, by lab.
///
/// # Errors
/// It cannot be read.
pub(crate) fn openings(kit: &Kit) -> Result<BTreeMap<String, Opening>> {
    read_toml(&kit.path("book/chapters.toml"))
}

impl Opening {
    fn of(kit: &Kit, lab: Lab) -> Result<Self> {
        openings(kit)?
            .remove(&format!("lab{lab}"))
            .with_context(|| format!("book/chapters.toml has no lab {lab}"))
    }

    /// How long the lab takes and what it needs, in one line.
    fn time(&self) -> String {
        let hours = self.reading + self.tasks.values().map(|task| task.hours).sum::<f64>();
        format!("About {hours:.0} hours. You need {}.", self.needs)
    }
}

/// How long a lab takes and what it needs, in one line.
///
/// # Errors
/// `book/chapters.toml` cannot be read, or has nothing about the lab.
pub(crate) fn needs(kit: &Kit, lab: Lab) -> Result<String> {
    Ok(Opening::of(kit, lab)?.time())
}

/// The opening of a lab's chapter.
///
/// # Errors
/// `book/chapters.toml` or the lab's hints, which know the titles of tasks, cannot be read.
pub(crate) fn opening(kit: &Kit, lab: &str) -> Result<String> {
    let lab: Lab = lab.parse().map_err(anyhow::Error::msg)?;
    let opening = Opening::of(kit, lab)?;
    let mut out = format!("*{}*\n\n**Afterwards you can**\n\n", opening.time());
    for what in &opening.able {
        out += &format!("- {what}\n");
    }
    out += "\n**Before you begin** you should know\n\n";
    for what in &opening.before {
        out += &format!("- {what}\n");
    }
    out += "\n<details><summary>Hours and difficulty, task by task</summary>\n\n\
            | task | | hours | difficulty |\n|---|---|---:|---|\n";
    for hint in hints::read(kit, lab)? {
        let Some(Task { hours, mark }) = opening.tasks.get(&hint.task.to_string()) else {
            continue;
        };
        let mark = "●".repeat(*mark) + &"○".repeat(3_usize.saturating_sub(*mark));
        out += &format!("| {} | {} | {hours} | {mark} |\n", hint.task, hint.title);
    }
    out += &format!("| | to read, predict, measure and explain | {} | |\n", opening.reading);
    Ok(out + "\n</details>\n")
}
