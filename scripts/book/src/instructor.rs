//! What instructors' pages ask for: the labs at a glance, and the known-wrong answers to each.

use std::collections::{BTreeMap, BTreeSet};

use anyhow::{Result, ensure};

use lab_kit::answers;
use lab_kit::hints;
use lab_kit::wrong;
use lab_kit::{Kit, Lab};

use crate::opening;

/// The known-wrong answers to a lab, from `tests/wrong`: a list for each task.
///
/// # Errors
/// The lab has none, or one of its files is not as it should be.
pub(crate) fn mistakes(kit: &Kit, lab: &str) -> Result<String> {
    let lab: Lab = lab.parse().map_err(anyhow::Error::msg)?;
    let mut by_task = BTreeMap::new();
    for wrong in wrong::read(kit, lab)? {
        by_task.entry(wrong.region.task).or_insert_with(Vec::new).push(wrong);
    }
    ensure!(!by_task.is_empty(), "tests/wrong/lab{lab} has nothing in it");
    let hints = hints::read(kit, lab)?;
    let mut out = String::new();
    for (task, wrongs) in by_task {
        let title = hints.iter().find(|hints| hints.task == task);
        let title = title.map_or(String::new(), |hints| format!(": {}", hints.title));
        out += &format!("\n**Task {task}{title}**\n\n");
        for wrong in wrongs {
            let [first, others @ ..] = &wrong.fails[..] else { continue };
            let others = match others.len() {
                0 => String::new(),
                1 => " and one more".into(),
                count => format!(" and {count} more"),
            };
            out += &format!("- {} *Caught by* `{first}`{others}.\n", wrong.story);
        }
    }
    Ok(out)
}

/// A row for each lab: how long it takes, how large it is, what it needs.
///
/// # Errors
/// A solution or `book/chapters.toml` cannot be read.
pub(crate) fn labs(kit: &Kit) -> Result<String> {
    let mut out = String::from(
        "| lab | title | time and needs | tasks | known-wrong answers |\n|---|---|---|---|---|\n",
    );
    for lab in kit.solutions()? {
        let files = answers::read_solution(kit, lab)?;
        let tasks: BTreeSet<_> = files
            .iter()
            .flat_map(|file| file.marked.regions())
            .map(|region| region.id.task)
            .collect();
        let time = opening::needs(kit, lab)?;
        let (title, wrongs) = (kit.title(lab), wrong::read(kit, lab)?.len());
        out += &format!("| {lab} | {title} | {time} | {} | {wrongs} |\n", tasks.len());
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::{labs, mistakes};
    use lab_kit::Kit;

    #[test]
    fn mistakes_stand_with_their_tasks() {
        let folder = tempfile::tempdir().unwrap();
        let hints = "## Task 1.1: the force\n1. a\n2. b\n3. c\n";
        let one =
            "// region: 1.1b\n// fails: task_1_1_a, task_1_1_b\n// story: No wall.\nsecret()\n";
        let files = [("labs/lab1/hints.md", hints), ("tests/wrong/lab1/one.rs", one)];
        let kit = Kit::of_files(folder.path(), &files);
        assert_eq!(
            mistakes(&kit, "1").unwrap(),
            "\n**Task 1.1: the force**\n\n- No wall. *Caught by* `task_1_1_a` and one more.\n"
        );
        mistakes(&kit, "2").unwrap_err();
    }

    #[test]
    fn every_lab_of_the_kit_has_a_row_and_its_mistakes() {
        let kit = Kit::find().unwrap();
        let table = labs(&kit).unwrap();
        let page = fs::read_to_string(kit.path("book/src/instructor/mistakes.md")).unwrap();
        for lab in kit.solutions().unwrap() {
            assert!(table.contains(&format!("\n| {lab} | ")), "{table}");
            assert!(page.contains(&format!("{{{{#mistakes {lab}}}}}")), "lab {lab}");
            assert!(mistakes(&kit, &lab.to_string()).is_ok(), "lab {lab}");
        }
    }
}
