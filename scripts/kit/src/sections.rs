//! Which section of the book a task belongs to: `book/sections.toml`.

use std::collections::BTreeMap;

use anyhow::Result;

use crate::files::read_toml;
use crate::kit::Kit;

/// Where to read about a task.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// The chapter's file below `book/src`.
    pub page: String,
    /// The section's heading.
    pub heading: String,
}

/// The sections by task, such as `3.2`.
///
/// # Errors
/// The file cannot be read.
pub fn read(kit: &Kit) -> Result<BTreeMap<String, Section>> {
    let rows: BTreeMap<String, [String; 2]> = read_toml(&kit.path("book/sections.toml"))?;
    Ok(rows.into_iter().map(|(task, [page, heading])| (task, Section { page, heading })).collect())
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::read;
    use crate::kit::Kit;

    #[test]
    fn sections_are_where_the_list_says() {
        let kit = Kit::find().unwrap();
        let sections = read(&kit).unwrap();
        for (task, section) in &sections {
            let text = fs::read_to_string(kit.path("book/src").join(&section.page)).unwrap();
            let is_it = |line: &str| line.trim_start_matches('#').trim() == section.heading;
            let there = text.lines().any(|line| line.starts_with("##") && is_it(line));
            assert!(there, "task {task}: {} has no '{}'", section.page, section.heading);
        }
    }
}
