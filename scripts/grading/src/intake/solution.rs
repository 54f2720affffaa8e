//! The kit's own solutions, as if they had been handed in.

use std::path::Path;

use anyhow::{Context, Result};

use lab_kit::submission::{Sources, collect};
use lab_kit::{Kit, Lab};

/// A solution, under the lab's own name.
pub(crate) fn solution(kit: &Kit, lab: Lab) -> Result<Sources> {
    let collected = collect(&kit.solution(lab))?;
    let mut sources = collected.files;
    for (path, bytes) in &mut sources {
        if Path::new(path).extension().is_some_and(|extension| extension == "rs") {
            let text = String::from_utf8(std::mem::take(bytes)).context("a source is no text")?;
            *bytes = as_starter(lab, &text).into_bytes();
        }
    }
    Ok(sources)
}

/// A source of the solution under the name that students' packages have.
pub(crate) fn as_starter(lab: Lab, text: &str) -> String {
    text.replace(&format!("solution{lab}::"), &format!("lab{lab}::"))
}
