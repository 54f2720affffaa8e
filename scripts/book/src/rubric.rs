//! The rubric as a page: what every task and every measure is worth.

use anyhow::Result;

use lab_kit::Kit;
use lab_kit::facts::Timed;
use lab_kit::hints;
use lab_kit::rubric;

/// A section for each lab that can be graded: its tasks with their points, and what is timed.
pub(crate) fn tables(kit: &Kit) -> Result<String> {
    let mut out = String::new();
    for (lab, rubric) in rubric::all(kit)? {
        out +=
            &format!("\n## Lab {lab}: {}\n\n| task | | points |\n|---|---|---|\n", kit.title(lab));
        for hints::Hints { task, title, .. } in hints::read(kit, lab)? {
            let points = rubric.tasks.get(&task.to_string()).map_or(0.0, |task| task.points);
            out += &format!("| {task} | {title} | {points} |\n");
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
    use super::tables;
    use lab_kit::Kit;

    #[test]
    fn tasks_stand_in_order_and_measures_below() {
        let folder = tempfile::tempdir().unwrap();
        let hints = "## Task 7.2: two\n1. a\n2. b\n3. c\n\n## Task 7.10: ten\n1. a\n2. b\n3. c\n";
        let facts = "title = 'x'\ndiscs = 'hard'\nworkers = 'threads'\n[tasks]\n\
                     '7.10' = { points = 60, hours = 1.0, mark = 1, section = 'x' }\n\
                     '7.2' = { points = 40, hours = 1.0, mark = 1, section = 'x' }\n\
                     [speed]\npoints = 20\nvariant = 'cells'\nn = 100\n";
        let files = [
            ("labs/lab7/hints.md", hints),
            ("solutions/lab7/Cargo.toml", ""),
            ("solutions/lab7/lab.toml", facts),
        ];
        let kit = Kit::of_files(folder.path(), &files);
        let text = tables(&kit).unwrap();
        let rows =
            "| 7.2 | two | 40 |\n| 7.10 | ten | 60 |\n| *speed* | `cells` at n = 100 | 20 |\n";
        assert!(text.contains("\n## Lab 7: ") && text.ends_with(rows), "{text}");
    }
}
