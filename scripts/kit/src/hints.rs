//! A lab's hints, as `labs/labN/hints.md` holds them.
//!
//! A section `## Task N.T: title` for each task, with an ordered list of three hints: a nudge, the
//! idea, nearly the answer. The book shows the same file.

use std::path::Path;

use anyhow::{Result, bail, ensure};

use crate::answers::Task;
use crate::files::read_text;
use crate::kit::Kit;
use crate::lab::Lab;

/// How many hints every task has.
pub const TIERS: usize = 3;

/// The hints of a task.
#[derive(Debug, PartialEq)]
pub struct Hints {
    /// The task.
    pub task: Task,
    /// Its title.
    pub title: String,
    /// From a nudge to nearly the answer.
    pub tiers: Vec<String>,
}

/// Reads the hints of a lab, in the order of its tasks; none if it has no file of hints yet.
pub fn read(kit: &Kit, lab: Lab) -> Result<Vec<Hints>> {
    let path = kit.starter(lab).join("hints.md");
    if !path.exists() {
        return Ok(Vec::new());
    }
    parse(Path::new(&format!("labs/lab{lab}/hints.md")), &read_text(&path)?)
}

fn parse(file: &Path, text: &str) -> Result<Vec<Hints>> {
    let mut all: Vec<Hints> = Vec::new();
    for (index, line) in text.lines().enumerate() {
        let location = || format!("{}:{}", file.display(), index + 1);
        if let Some(heading) = line.strip_prefix("## ") {
            let parts = heading.strip_prefix("Task ").and_then(|rest| rest.split_once(':'));
            let Some((task, title)) = parts else {
                bail!("{}: expected '## Task 3.2: title'", location());
            };
            let task = task.trim().parse().map_err(|e| anyhow::anyhow!("{}: {e}", location()))?;
            all.push(Hints { task, title: title.trim().into(), tiers: Vec::new() });
            continue;
        }
        // What comes before the first task is for the book's readers.
        let Some(hints) = all.last_mut() else { continue };
        if let Some(hint) = numbered(line) {
            hints.tiers.push(hint.into());
        } else if let Some(hint) = hints.tiers.last_mut() {
            hint.push('\n');
            hint.push_str(line.strip_prefix("   ").unwrap_or(line));
        } else {
            ensure!(line.trim().is_empty(), "{}: expected a numbered hint", location());
        }
    }
    for hints in &mut all {
        hints.tiers.iter_mut().for_each(|hint| *hint = hint.trim().into());
        let (task, found) = (hints.task, hints.tiers.len());
        ensure!(found == TIERS, "{}: task {task} has {found} hints, not {TIERS}", file.display());
    }
    Ok(all)
}

/// The text of a line `1. text`.
fn numbered(line: &str) -> Option<&str> {
    let (number, text) = line.split_once(". ")?;
    number.bytes().all(|b| b.is_ascii_digit()).then_some(text)
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::parse;

    #[test]
    fn hints_are_read_with_their_code() {
        let text = "# Hints\nText.\n\n## Task 1.2: the move\n\n1. Nudge.\n2. The idea,\n   in two lines.\n3. Nearly:\n\n   ```rust\n   x += 1.0;\n   ```\n";
        let all = parse(Path::new("hints.md"), text).unwrap();
        assert_eq!(all.len(), 1);
        assert_eq!((all[0].task.to_string(), &*all[0].title), ("1.2".into(), "the move"));
        assert_eq!(all[0].tiers[1], "The idea,\nin two lines.");
        assert_eq!(all[0].tiers[2], "Nearly:\n\n```rust\nx += 1.0;\n```");
    }

    #[test]
    fn a_missing_tier_is_an_error() {
        let error = parse(Path::new("hints.md"), "## Task 1.2: a\n1. x\n2. y\n").unwrap_err();
        assert_eq!(error.to_string(), "hints.md: task 1.2 has 2 hints, not 3");
    }
}
