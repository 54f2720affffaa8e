//! Reports about a class: a page, a table, a letter to each student, and Gradescope's file.

mod changed_marks;
mod csv;
mod gradescope;
mod letter;
mod moodle;
mod page;
mod sentences;

pub(crate) use changed_marks::changes;

use std::collections::BTreeMap;
use std::path::Path;

use anyhow::Result;

use crate::record::{self, Record, Status, points, scale};
use crate::roster::{Attendance, ClassFile};
use lab_kit::files::write_file;
use lab_kit::task_list;
use lab_kit::{Facts, Kit, Lab};
use lab_measure::commands::contest::publish;

/// Texts that a report needs in addition to a record.
#[derive(Default)]
struct Words {
    /// Number and title of the lab.
    lab: String,
    /// Points that the whole class is marked out of.
    full: f64,
    /// Titles of tasks, by their numbers.
    titles: BTreeMap<String, String>,
    /// Path of the lab's chapter; `None` if there is no chapter yet.
    chapter: Option<String>,
    /// Facts about the lab, such as its kind of workers and the sections of its chapter.
    facts: Facts,
}

/// Writes all reports into `folder`.
///
/// These are `index.html`, `class.csv`, `feedback/NAME.md` and `gradescope/NAME.json`. A roster
/// adds `marks.csv`, and an export from Moodle adds `moodle-feedback.zip`.
pub(crate) fn write(
    kit: &Kit,
    lab: Lab,
    records: &[Record],
    (class, attendance): (&ClassFile, &Attendance),
    folder: &Path,
) -> Result<()> {
    let words = Words { full: scale(records), ..Words::of(kit, lab)? };
    let shown = shown(records);
    let mut to_see_to = attendance.words(records);
    if records.iter().any(|record| record.marked.pseudonym.is_some()) {
        // A page with pseudonyms contains no names, so it lists only how many students are
        // concerned.
        to_see_to.iter_mut().for_each(|(_, who)| *who = vec![who.len().to_string()]);
    }
    write_file(&folder.join("index.html"), page::page(&shown, &to_see_to, &words))?;
    write_file(&folder.join("class.csv"), &csv::csv(records)?)?;
    if let Some(marks) = class.marks(records, attendance)? {
        write_file(&folder.join("marks.csv"), &marks)?;
    }
    let mut letters = Vec::new();
    for record in records {
        let name = &record.found.name;
        let letter = letter::letter(record, &words);
        write_file(&folder.join(format!("feedback/{name}.md")), &letter)?;
        letters.push((name.as_str(), letter));
        // If the grader failed, the submission must not be uploaded with 0 points.
        if record.found.status != Status::Failed {
            let results = serde_json::to_string_pretty(&gradescope::results(record, &words))?;
            write_file(&folder.join(format!("gradescope/{name}.json")), &results)?;
        }
    }
    if let Some(archive) = moodle::archive(&letters)? {
        write_file(&folder.join("moodle-feedback.zip"), archive)?;
    }
    Ok(())
}

/// Writes the contest's page into the folder `contest` in `folder`, and prints its path. Does nothing
/// if no record contains an entry.
///
/// Call this function last, so that an error hides no other results.
pub(crate) fn publish_contest(kit: &Kit, records: &[Record], folder: &Path) -> Result<()> {
    let entries = records.iter().filter_map(|record| {
        Some((record.found.name.clone(), vec![record.found.contest.clone()?]))
    });
    let entries: Vec<_> = entries.collect();
    if !entries.is_empty() {
        let page = publish(kit, entries, &folder.join("contest"))?;
        println!("The contest: {}", page.display());
    }
    Ok(())
}

/// Returns the records as a page shows them. If several records have the same name, the names of
/// the submissions are added.
fn shown(records: &[Record]) -> Vec<Record> {
    let mut shown: Vec<Record> = records.iter().map(Record::shown).collect();
    let mut many: BTreeMap<String, usize> = BTreeMap::new();
    shown.iter().for_each(|record| *many.entry(record.found.name.clone()).or_default() += 1);
    for (shown, record) in shown.iter_mut().zip(records) {
        if many[&shown.found.name] > 1 && shown.marked.pseudonym.is_none() {
            shown.found.name = format!("{} ({})", shown.found.name, record.found.name);
        }
    }
    record::sort(&mut shown);
    shown
}

impl Words {
    fn of(kit: &Kit, lab: Lab) -> Result<Self> {
        let titles = task_list::read(kit, lab)?;
        let titles = titles.into_iter().map(|(task, facts)| (task.to_string(), facts.title));
        Ok(Self {
            lab: format!("Lab {lab}: {}", kit.title(lab)),
            full: 0.0,
            titles: titles.collect(),
            chapter: kit.chapter(lab),
            facts: kit.facts(lab)?,
        })
    }

    /// Returns the points that a record is marked out of, which are the same in every report.
    fn full(&self, record: &Record) -> f64 {
        self.full.max(scale(std::slice::from_ref(record)))
    }

    /// Returns the title of a task: `Task 3.2: which rows belong to which thread`.
    fn task(&self, id: &str) -> String {
        let title = self.titles.get(id);
        title.map_or(format!("Task {id}"), |title| format!("Task {id}: {title}"))
    }

    /// Returns the chapter and section to read about a task.
    fn reading(&self, id: &str) -> Option<String> {
        let chapter = self.chapter.as_ref()?;
        let section = self.facts.tasks.get(id).map(|task| &task.section);
        Some(section.map_or_else(
            || chapter.clone(),
            |heading| format!("\u{201c}{heading}\u{201d} in {} ({chapter})", self.lab),
        ))
    }
}

/// Returns the stage that a submission reached, in a few words; `None` if it was graded.
fn trouble(status: Status) -> Option<&'static str> {
    match status {
        Status::Unreadable => Some("could not be read"),
        Status::Empty => Some("has nothing for this lab"),
        Status::Refused => Some("was refused"),
        Status::NotBuilt => Some("does not compile"),
        Status::Failed => Some("could not be graded"),
        Status::Graded => None,
    }
}

#[cfg(test)]
mod tests {
    use super::{points, scale};
    use crate::record::{Attempt, Record, Verdict};

    #[test]
    fn points_have_no_needless_zeros() {
        let all = [15.0, 7.5, 12.36, 0.0, 100.0];
        assert_eq!(all.map(points), ["15", "7.5", "12.36", "0", "100"]);
    }

    #[test]
    fn attempts_that_do_not_count_are_told_apart_and_not_counted() {
        let mut records = ["7_1", "7_2"].map(Record::sample_called);
        records.iter_mut().for_each(|record| record.marked.student = Some("Ada".into()));
        records[1].marked.attempt = Attempt::Another;
        let text = super::page::page(&super::shown(&records), &[], &super::Words::default());
        assert!(text.contains(">Ada (7_1)</a>") && text.contains(">Ada (7_2)</a>"), "{text}");
        assert_eq!(text.matches("<tr class=\"aside\">").count(), 1, "{text}");
        assert!(text.contains("1 of 1") && !text.contains("of 2</span>"), "{text}");
    }

    #[test]
    fn a_class_has_one_scale() {
        let [noisy, timed, untimed] =
            [Verdict::TooNoisy, Verdict::Graded, Verdict::NotTimed].map(Record::sample_of_speed);
        let text = super::page::page(&[noisy, timed], &[], &super::Words::default());
        assert!(text.contains("<th class=\"points\">of 125</th>"), "{text}");
        assert!(text.contains("60 + 25?"), "what is open is said: {text}");
        assert_eq!(text.matches(" of 125 points</summary>").count(), 2, "{text}");
        assert_eq!(scale(std::slice::from_ref(&untimed)), 100.0, "nobody was asked for more");
        let words =
            super::Words { full: scale(std::slice::from_ref(&untimed)), ..Default::default() };
        let letter = super::letter::body(&untimed, &words);
        assert!(letter.starts_with("60 of 100 points. 25 points are open"), "{letter}");
    }
}
