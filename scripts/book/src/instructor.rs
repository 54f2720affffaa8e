//! What instructors' pages ask for: the labs at a glance, and the known-wrong answers to each.

use std::collections::BTreeMap;

use anyhow::Result;

use lab_kit::answers;
use lab_kit::hints;
use lab_kit::wrong;
use lab_kit::{Kit, Lab, Workers};

use crate::opening;

/// The known-wrong answers to each lab, from `tests/wrong`: a section for each, a list for each task.
///
/// # Errors
/// A file is not as it should be.
pub(crate) fn mistakes(kit: &Kit) -> Result<String> {
    let mut out = String::new();
    for lab in kit.solutions() {
        out += &format!("\n## Lab {lab}: {}\n{}", kit.title(lab), mistakes_in(kit, lab)?);
    }
    Ok(out)
}

fn mistakes_in(kit: &Kit, lab: Lab) -> Result<String> {
    let mut by_task = BTreeMap::new();
    for wrong in wrong::read(kit, lab)? {
        by_task.entry(wrong.region.task).or_insert_with(Vec::new).push(wrong);
    }
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
pub(crate) fn labs(kit: &Kit) -> Result<String> {
    let mut out = String::from(
        "| lab | title | time and needs | tasks | known-wrong answers |\n|---|---|---|---|---|\n",
    );
    for lab in kit.solutions() {
        let tasks = answers::tasks(kit, lab)?;
        let facts = kit.facts(lab)?;
        let (title, time) = (&facts.title, opening::needs(&facts));
        let wrongs = wrong::read(kit, lab)?.len();
        out += &format!("| {lab} | {title} | {time} | {} | {wrongs} |\n", tasks.len());
    }
    Ok(out)
}

/// The numbers of the labs with such workers, as `5, 6, 8`.
pub(crate) fn labs_with(kit: &Kit, workers: &str) -> Result<String> {
    let workers: Workers = serde_json::from_value(workers.into())?;
    let mut numbers = Vec::new();
    for lab in kit.starters() {
        if kit.facts(lab)?.workers == workers {
            numbers.push(lab.to_string());
        }
    }
    Ok(numbers.join(", "))
}

#[cfg(test)]
mod tests {
    use super::{labs, labs_with, mistakes, mistakes_in};
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
            mistakes_in(&kit, "1".parse().unwrap()).unwrap(),
            "\n**Task 1.1: the force**\n\n- No wall. *Caught by* `task_1_1_a` and one more.\n"
        );
    }

    #[test]
    fn every_lab_of_the_kit_has_a_row_and_its_mistakes() {
        let kit = Kit::find().unwrap();
        let table = labs(&kit).unwrap();
        let mistakes = mistakes(&kit).unwrap();
        for lab in kit.solutions() {
            assert!(table.contains(&format!("\n| {lab} | ")), "{table}");
            assert!(mistakes.contains(&format!("\n## Lab {lab}: ")), "lab {lab}");
        }
        assert_eq!(labs_with(&kit, "device").unwrap(), "9");
        labs_with(&kit, "nobody").unwrap_err();
    }
}
