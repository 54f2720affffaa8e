//! Adds a lab's tasks to its chapter: an anchor where each task begins, and folded hints.

use std::path::Path;

use anyhow::{Result, ensure};

use lab_kit::answers::Task;
use lab_kit::facts::TaskFacts;
use lab_kit::{Kit, Lab, task_list};

/// The names of the three hints of a task.
const TIERS: [&str; task_list::TIERS] = ["a nudge", "the idea", "nearly the answer"];

/// Returns the page `file` of the book with its tasks inserted.
///
/// Below the heading of its section, each task has a line with an anchor, and tables of tasks link
/// to the anchors. If `with_hints`, each section ends with the hints of its tasks. The lab's facts
/// contain the section of each task. Pages that are not the chapter of a lab stay as they are.
///
/// # Errors
/// A task's section is not in the chapter.
pub(crate) fn placed(kit: &Kit, file: &Path, text: &str, with_hints: bool) -> Result<String> {
    // Pages in folders are not chapters.
    let number = file.to_str().and_then(|name| name.strip_prefix("lab")?.strip_suffix(".md"));
    let Some(lab) = number.and_then(|number| number.parse::<Lab>().ok()) else {
        return Ok(text.to_owned());
    };
    let tasks = task_list::read(kit, lab)?;
    if tasks.is_empty() {
        return Ok(text.to_owned());
    }
    let mut open: Vec<_> = tasks.iter().collect();
    let mut out = String::new();
    // The hints of the tasks that belong to this section.
    let mut folds = String::new();
    let mut in_code = false;
    for line in text.split_inclusive('\n') {
        in_code ^= line.starts_with("```");
        if !line.starts_with('#') || in_code {
            out += &linked(line, &tasks);
            continue;
        }
        out += &folds;
        out.push_str(line);
        let heading = line.trim_start_matches('#').trim();
        folds.clear();
        for (task, facts) in open.extract_if(.., |(_, facts)| facts.section == heading) {
            out += &place(*task, facts);
            if with_hints {
                folds += &folded(*task, facts);
            }
        }
    }
    out += &folds;
    let lost = open.first().map(|(_, facts)| &*facts.section);
    ensure!(lost.is_none(), "no section '{}'", lost.unwrap_or_default());
    Ok(out)
}

/// Returns a line with the task's number, title, hours and difficulty, and the anchor `task-N-M`.
fn place(task: Task, facts: &TaskFacts) -> String {
    let anchor = task.anchor();
    let TaskFacts { title, hours, .. } = facts;
    let difficulty = difficulty(facts) + optional(facts);
    format!(
        "\n<p class=\"task\" id=\"{anchor}\"><a href=\"#{anchor}\">Task {task}</a> {title} \
         <span>{hours} h, {difficulty}</span></p>\n"
    )
}

/// Returns the difficulty of a task as one to three filled circles.
pub(crate) fn difficulty(task: &TaskFacts) -> String {
    "●".repeat(task.mark) + &"○".repeat(3_usize.saturating_sub(task.mark))
}

/// Returns `, optional` for a task that is not a core task; empty for a core task.
pub(crate) fn optional(task: &TaskFacts) -> &'static str {
    if task.optional { ", optional" } else { "" }
}

/// Returns the line. If it is the row of a task in a table, the task's number becomes a link.
fn linked(line: &str, tasks: &[(Task, TaskFacts)]) -> String {
    for (task, _) in tasks {
        if let Some(rest) = line.strip_prefix(&format!("| {task} |")) {
            return format!("| [{task}](#{}) |{rest}", task.anchor());
        }
    }
    line.to_owned()
}

fn folded(task: Task, facts: &TaskFacts) -> String {
    let mut tiers = String::new();
    for (tier, hint) in TIERS.iter().zip(&facts.hints) {
        tiers += &format!("<details><summary>{tier}</summary>\n\n{hint}\n\n</details>\n\n");
    }
    format!(
        "<details class=\"hint\"><summary>Hints for task {task}: {}</summary>\n\n{tiers}</details>\n\n",
        facts.title
    )
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::placed;
    use lab_kit::Kit;

    const FACTS: &str = "title = 'x'\ndiscs = 'soft'\nworkers = 'threads'\n[tasks]\n\
        '1.1' = { title = 'the force', points = 50, hours = 1.0, mark = 1, section = 'Force', \
        hints = ['Look.', 'Think.', 'Write.'] }\n\
        '1.2' = { title = 'the move', points = 50, hours = 0.5, mark = 3, optional = true, section = 'Move', hints = ['a', 'b', 'c'] }\n";

    const PAGE: &str = "# Lab\n\n| 1.2 | `f` |\n| 9.9 | x |\n\n### Force\n\nPush.\n\n```sh\n# Move\n```\n\n### Move\n\nGo.\n";

    /// Calls [`placed`] with the text of a page, in a kit whose only lab has two tasks.
    fn filled(page: &str, text: &str, with_hints: bool) -> anyhow::Result<String> {
        let folder = tempfile::tempdir().unwrap();
        let kit = Kit::of_files(folder.path(), &[("labs/lab1/lab.toml", FACTS)]);
        placed(&kit, Path::new(page), text, with_hints)
    }

    #[test]
    fn each_task_has_its_place_and_its_hints_in_its_section() {
        let text = filled("lab1.md", PAGE, true).unwrap();
        let order = [
            "### Force",
            "id=\"task-1-1\"",
            "Push.",
            "Think.",
            "### Move",
            "Go.",
            "Hints for task 1.2",
        ];
        let order = order.map(|part| text.find(part));
        assert!(order.is_sorted() && order[0].is_some(), "{text}");
        assert_eq!(text.matches("<details").count(), 8);
        let task = ">Task 1.2</a> the move <span>0.5 h, ●●●, optional</span></p>\n";
        assert!(text.contains(task), "{text}");
        assert!(text.contains("| [1.2](#task-1-2) | `f` |\n| 9.9 | x |\n"), "{text}");

        let text = filled("lab1.md", PAGE, false).unwrap();
        assert!(text.contains("task-1-1") && !text.contains("<details"), "{text}");
        assert_eq!(filled("models.md", PAGE, true).unwrap(), PAGE);
    }

    #[test]
    fn a_section_that_is_missing_is_named() {
        let error = filled("lab1.md", "# Lab\n\n### Force\n", true).unwrap_err();
        assert!(error.to_string().contains("no section 'Move'"), "{error}");
    }
}
