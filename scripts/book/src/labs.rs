//! Texts about labs, made from their facts.
//!
//! The texts are the opening of each chapter, the table of labs, and the list of points for tasks
//! and measurements.

use anyhow::Result;

use lab_kit::facts::Timed;
use lab_kit::{Facts, Kit, Lab, Workers, answers, rubric, task_list, wrong};

use crate::chapter_tasks::{difficulty, optional};

/// Returns a line with the hours that a lab takes and the tools that it needs.
pub(crate) fn needs(facts: &Facts) -> String {
    let hours = facts.reading + facts.tasks.values().map(|task| task.hours).sum::<f64>();
    format!("About {hours:.0} hours. You need {}.", facts.workers.need())
}

/// Returns the opening of a lab's chapter.
pub(crate) fn opening(kit: &Kit, lab: &str) -> Result<String> {
    let lab: Lab = lab.parse().map_err(anyhow::Error::msg)?;
    let facts = kit.facts(lab)?;
    let mut out = format!("*{}*\n\n**Afterwards you can**\n\n", needs(&facts));
    for what in &facts.able {
        out += &format!("- {what}\n");
    }
    out += "\n**Before you begin** you should know\n\n";
    for what in &facts.before {
        out += &format!("- {what}\n");
    }
    out += "\n<details><summary>Hours and difficulty, task by task</summary>\n\n\
            | task | | hours | difficulty |\n|---|---|---:|---|\n";
    for (id, task) in task_list::read(kit, lab)? {
        let mark = difficulty(&task) + optional(&task);
        out += &format!("| {id} | {} | {} | {mark} |\n", task.title, task.hours);
    }
    out += &format!("| | to read, predict, measure and explain | {} | |\n", facts.reading);
    Ok(out + "\n</details>\n")
}

/// Returns a table with each lab's time, size and needed software.
pub(crate) fn labs(kit: &Kit) -> Result<String> {
    let mut out = String::from(
        "| lab | title | time and needs | tasks | known-wrong answers |\n|---|---|---|---|---|\n",
    );
    for lab in kit.solutions() {
        let tasks = answers::tasks(kit, lab)?;
        let facts = kit.facts(lab)?;
        let time = needs(&facts);
        let wrongs = wrong::read(kit, lab)?.len();
        out += &format!("| {lab} | {} | {time} | {} | {wrongs} |\n", facts.title, tasks.len());
    }
    Ok(out)
}

/// Returns the numbers of the labs with these workers, as `5, 6, 8`.
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

/// Returns a section for each lab that can be graded: its tasks with their points, and its
/// measurements.
pub(crate) fn rubric(kit: &Kit) -> Result<String> {
    let mut out = String::new();
    for (lab, rubric) in rubric::all(kit)? {
        out +=
            &format!("\n## Lab {lab}: {}\n\n| task | | points |\n|---|---|---|\n", kit.title(lab));
        for (id, task) in task_list::read(kit, lab)? {
            out += &format!("| {id} | {}{} | {} |\n", task.title, optional(&task), task.points);
        }
        let timed: [(&str, &Option<Timed>, &str); 3] = [
            ("complexity", &rubric.complexity, "up to"),
            ("scaling", &rubric.scaling, "at"),
            ("speed", &rubric.speed, "at"),
        ];
        for (name, timed, at) in timed {
            if let Some(Timed { points, variant, n }) = timed {
                out += &format!("| *{name}* | `{variant}` {at} n = {n} | {points} |\n");
            }
        }
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_opening_says_what_the_list_says() {
        let folder = tempfile::tempdir().unwrap();
        let facts = "title = 'all'\ndiscs = 'soft'\nworkers = 'threads'\n\
            able = ['fly']\nbefore = ['[it](x.md)']\nreading = 1.0\n\
            [tasks]\n'1.1' = { title = 'the force', points = 100, hours = 1.5, mark = 2, section = 'A', \
            hints = ['a', 'b', 'c'] }\n";
        let kit = Kit::of_files(folder.path(), &[("solutions/lab1/lab.toml", facts)]);
        let text = opening(&kit, "1").unwrap();
        assert!(text.starts_with("*About 2 hours. You need only Rust.*"), "{text}");
        for part in ["\n- fly\n", "\n- [it](x.md)\n", "| 1.1 | the force | 1.5 | ●●○ |"] {
            assert!(text.contains(part), "{text}");
        }
        assert!(opening(&kit, "2").is_err());
    }

    #[test]
    fn every_lab_of_the_kit_has_a_row() {
        let kit = Kit::find().unwrap();
        let table = labs(&kit).unwrap();
        for lab in kit.solutions() {
            assert!(table.contains(&format!("\n| {lab} | ")), "{table}");
        }
        assert_eq!(labs_with(&kit, "device").unwrap(), "9");
        labs_with(&kit, "nobody").unwrap_err();
    }

    #[test]
    fn tasks_stand_in_order_and_measures_below() {
        let folder = tempfile::tempdir().unwrap();
        let facts = "title = 'x'\ndiscs = 'hard'\nworkers = 'threads'\n[tasks]\n\
                     '7.10' = { title = 'ten', points = 60, hours = 1.0, mark = 1, section = 'x', hints = ['a', 'b', 'c'] }\n\
                     '7.2' = { title = 'two', points = 40, hours = 1.0, mark = 1, section = 'x', hints = ['a', 'b', 'c'] }\n\
                     [speed]\npoints = 20\nvariant = 'cells'\nn = 100\n";
        let files = [("solutions/lab7/Cargo.toml", ""), ("solutions/lab7/lab.toml", facts)];
        let kit = Kit::of_files(folder.path(), &files);
        let text = super::rubric(&kit).unwrap();
        let rows =
            "| 7.2 | two | 40 |\n| 7.10 | ten | 60 |\n| *speed* | `cells` at n = 100 | 20 |\n";
        assert!(text.contains("\n## Lab 7: ") && text.ends_with(rows), "{text}");
    }
}
