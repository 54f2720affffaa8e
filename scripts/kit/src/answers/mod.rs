//! Marks in a solution's source that enclose the answers to tasks.
//!
//! ```text
//!     // task 1.2: the move with its bounce
//!     …answer…
//!     // end 1.2
//! ```
//! The lines between these marks are the answer to task 1.2, inside a function. Outside functions,
//! `// answer only` to `// end answer only` enclose items that only an answer needs. The starter
//! contains neither, and `cargo lab prove` replaces an answer by known-wrong bodies.

mod parse;
mod task;

pub(crate) use parse::indent;
use parse::wrong_mark;
pub use parse::{Part, Region, parse};
pub use task::{RegionId, Task};

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use anyhow::Result;

use crate::files::{read_text, sources_below};
use crate::kit::Kit;
use crate::lab::Lab;

/// A source file of a solution, divided at its marks.
pub struct MarkedFile {
    /// Path relative to the solution's folder, such as `src/force.rs`.
    pub path: PathBuf,
    /// Parts of the text, in order.
    pub parts: Vec<Part>,
}

impl MarkedFile {
    /// Returns the answers in the file.
    pub fn regions(&self) -> impl Iterator<Item = &Region> {
        self.parts.iter().filter_map(|part| match part {
            Part::Answer(region) => Some(region),
            _ => None,
        })
    }

    /// Whether the file is a shader.
    pub fn is_shader(&self) -> bool {
        self.path.extension().is_some_and(|e| e == "wgsl")
    }
}

/// Reads all Rust files and shaders (WGSL) of a lab's solution.
///
/// # Errors
/// If a file cannot be read or parsed, or if two regions have the same id.
pub fn read_solution(kit: &Kit, lab: Lab) -> Result<Vec<MarkedFile>> {
    let folder = kit.solution(lab);
    let mut seen: BTreeMap<RegionId, String> = BTreeMap::new();
    let mut files = Vec::new();
    for path in sources_below(&folder.join("src"))? {
        if path.extension().is_none_or(|e| e != "rs" && e != "wgsl") {
            continue;
        }
        let shown = path.strip_prefix(kit.root()).unwrap_or(&path);
        let parts = parse(shown, &read_text(&path)?)?;
        let file = MarkedFile { path: path.strip_prefix(&folder)?.to_owned(), parts };
        check_ids(shown, &file, lab, &mut seen)?;
        files.push(file);
    }
    Ok(files)
}

/// Returns the tasks of a lab's solution.
pub fn tasks(kit: &Kit, lab: Lab) -> Result<BTreeSet<Task>> {
    let files = read_solution(kit, lab)?;
    let regions = files.iter().flat_map(|file| file.regions());
    Ok(regions.map(|region| region.id.task).collect())
}

fn check_ids(
    shown: &Path,
    file: &MarkedFile,
    lab: Lab,
    seen: &mut BTreeMap<RegionId, String>,
) -> Result<()> {
    for region in file.regions() {
        let Region { id, line, .. } = region;
        let fault = if id.task.lab != lab {
            format!("task {id} is in lab {lab}")
        } else if let Some(before) = seen.insert(*id, format!("{}:{line}", shown.display())) {
            format!(
                "task {id} is here a second time, after {before}: give it a letter, such as {}b",
                id.task
            )
        } else {
            continue;
        };
        return Err(wrong_mark(shown, *line, &fault));
    }
    Ok(())
}
