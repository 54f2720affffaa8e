//! A lab's hints, folded into its chapter: beside the text of each task.

use std::path::Path;

use anyhow::{Result, ensure};

use lab_kit::{Kit, Lab, hints};

/// What the three hints of a task are called.
const TIERS: [&str; hints::TIERS] = ["a nudge", "the idea", "nearly the answer"];

/// The page `file` of the book with the hints of each task at the end of the task's section, one
/// fold a task; the lab's facts say which section that is.
pub(crate) fn beside_tasks(kit: &Kit, file: &Path, text: &str) -> Result<String> {
    // Pages in folders are no chapters.
    let number = file.to_str().and_then(|name| name.strip_prefix("lab")?.strip_suffix(".md"));
    let Some(lab) = number.and_then(|number| number.parse::<Lab>().ok()) else {
        return Ok(text.to_owned());
    };
    let all = hints::read(kit, lab)?;
    if all.is_empty() {
        return Ok(text.to_owned());
    }
    let facts = kit.facts(lab)?;
    let fold =
        |hints: &hints::Hints| (&*facts.tasks[&hints.task.to_string()].section, folded(hints));
    let mut folds: Vec<(&str, String)> = all.iter().map(fold).collect();
    let mut out = String::new();
    let mut heading = "";
    let mut in_code = false;
    for line in text.split_inclusive('\n') {
        in_code ^= line.starts_with("```");
        if line.starts_with('#') && !in_code {
            out += &take(&mut folds, heading);
            heading = line.trim_start_matches('#').trim();
        }
        out.push_str(line);
    }
    out += &take(&mut folds, heading);
    let lost = folds.first().map(|(section, _)| *section);
    ensure!(lost.is_none(), "no section '{}'", lost.unwrap_or_default());
    Ok(out)
}

/// The folds of a section, which are then no longer among the others.
fn take(folds: &mut Vec<(&str, String)>, section: &str) -> String {
    folds.extract_if(.., |(of, _)| *of == section).map(|(_, fold)| fold).collect()
}

fn folded(hints: &hints::Hints) -> String {
    let tiers = TIERS.iter().zip(&hints.tiers);
    let tiers = tiers.map(|(tier, hint)| {
        format!("<details><summary>{tier}</summary>\n\n{hint}\n\n</details>\n\n")
    });
    format!(
        "<details class=\"hint\"><summary>Hints for task {}: {}</summary>\n\n{}</details>\n\n",
        hints.task,
        hints.title,
        tiers.collect::<String>()
    )
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::beside_tasks;
    use lab_kit::Kit;

    const FACTS: &str = "title = 'x'\ndiscs = 'soft'\nworkers = 'threads'\n[tasks]\n\
        '1.1' = { title = 'the force', points = 50, hours = 1.0, mark = 1, section = 'Force', \
        hints = ['Look.', 'Think.', 'Write.'] }\n\
        '1.2' = { title = 'the move', points = 50, hours = 1.0, mark = 1, section = 'Move', hints = ['a', 'b', 'c'] }\n";

    /// A page of a kit with hints for two tasks.
    fn filled(page: &str, text: &str) -> anyhow::Result<String> {
        let folder = tempfile::tempdir().unwrap();
        let kit = Kit::of_files(folder.path(), &[("labs/lab1/lab.toml", FACTS)]);
        beside_tasks(&kit, Path::new(page), text)
    }

    #[test]
    fn each_task_has_its_hints_in_its_section() {
        let page = "# Lab\n\n### Force\n\nPush.\n\n```sh\n# Move\n```\n\n### Move\n\nGo.\n";
        let text = filled("lab1.md", page).unwrap();
        let order = ["Push.", "Think.", "### Move", "Go.", "the move"].map(|part| text.find(part));
        assert!(order.is_sorted() && order[0].is_some(), "{text}");
        assert_eq!(text.matches("<details").count(), 8);

        assert_eq!(filled("models.md", page).unwrap(), page);
        let error = filled("lab1.md", "# Lab\n\n### Force\n").unwrap_err();
        assert!(error.to_string().contains("no section 'Move'"), "{error}");
    }
}
