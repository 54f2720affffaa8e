//! `feedback/NAME.md`: the letter to a student.

use super::{Words, points, sentences, trouble};
use crate::record::{Attempt, Record, Status, Task};
use crate::timing::contest;
use lab_kit::escape::{fenced, line, markdown};

/// Words that follow the points of a task that is right in part.
const IN_PART: &str = " **in part**";

/// Writes the letter, in Markdown.
pub(crate) fn letter(record: &Record, words: &Words) -> String {
    let name = markdown(record.marked.student.as_ref().unwrap_or(&record.found.name));
    format!("# {}\n\n**{name}**: {}", words.lab, body(record, words))
}

/// Writes the body of the letter, without the student's name.
pub(crate) fn body(record: &Record, words: &Words) -> String {
    around(record, words, &tasks(record, words))
}

/// Writes the body of the letter, with `tasks` as the text about the tasks.
///
/// The letter contains `tasks` only if the tasks were judged.
pub(crate) fn around(record: &Record, words: &Words, tasks: &str) -> String {
    let mut out = standing(record, words);
    if record.open_points() > 0.0 {
        let open = points(record.open_points());
        out += &format!(
            " {open} points are open: they depend on times that were not graded (see below)."
        );
    }
    for sentence in sentences::by_hand(record, None) {
        out += &format!(" {}", markdown(&sentence));
    }
    out += "\n\n";
    if record.found.status == Status::Failed {
        // The error message is for the staff only, because it may name their folders.
        out += "It could not be graded yet. The cause is the grading machine, and not your \
                submission.\n\n";
    } else if let Some(trouble) = trouble(record.found.status) {
        out += &format!("The submission {trouble}.\n\n{}\n", fenced(&record.found.message));
        if record.found.status == Status::NotBuilt {
            out += "`cargo lab check` compiles a lab as the grader does; hand in a version that \
                 passes this check.\n\n";
        }
    } else {
        out += tasks;
        out += &speed(record, words);
        if let Some(entry) = &record.found.contest {
            let summary = markdown(&line(&contest::summary(entry)));
            out += &format!("## Contest\n\nYour entry: {summary}.\n\n");
        }
    }
    if !record.found.changed.is_empty() {
        let changed =
            record.found.changed.iter().map(|path| file(path)).collect::<Vec<_>>().join(", ");
        out += &format!(
            "## Given files that were changed\n\nOnly files with tasks are yours, and new ones. Of these the kit's \
             were compiled: {changed}.\n\n"
        );
    }
    if !record.found.left_out.is_empty() {
        out += "## Files that were not taken\n\n";
        for left in &record.found.left_out {
            out += &format!("- {}: {}\n", file(&left.path), markdown(&left.reason));
        }
        out.push('\n');
    }
    let of = record.found.hash.get(..12).unwrap_or(&record.found.hash);
    if !of.is_empty() {
        out +=
            &format!("*Graded from sources {of} with the inputs of seed {}.*\n", record.found.seed);
    }
    out
}

/// Formats a path as Markdown code, so that no character of the path can end the code.
fn file(path: &str) -> String {
    if path.contains('`') { markdown(path) } else { format!("`{}`", line(path)) }
}

/// Describes how many points the submission has, and whether they are the student's mark.
fn standing(record: &Record, words: &Words) -> String {
    let given =
        format!("{} of {} points.", points(record.marked.points), points(words.full(record)));
    match (record.has_mark(), record.marked.attempt) {
        (true, Attempt::Counts) => given,
        (true, Attempt::Another) => given + " Another of your submissions counts.",
        (true, Attempt::Undecided) => {
            given + " You handed in more than once: there is no mark until one is left."
        }
        (false, Attempt::Another) => "Another of your submissions counts.".into(),
        (false, _) => "There is no mark yet.".into(),
    }
}

fn tasks(record: &Record, words: &Words) -> String {
    let mut out = String::from("| task | points |\n|---|---|\n");
    for task in &record.tasks {
        let given = points(task.points);
        let most = points(task.out_of);
        let mark = mark(record, task);
        out += &format!("| {} | {given} of {most}{mark} |\n", words.task(&task.id));
    }
    out.push('\n');
    if record.tasks.iter().any(|task| mark(record, task) == IN_PART) {
        out += "A task that is right in part earns points in proportion to its right answers.\n\n";
    }
    for task in &record.tasks {
        for sentence in sentences::by_hand(record, Some(&task.id)) {
            out += &format!("Task {}: {}\n\n", task.id, markdown(&sentence));
        }
    }
    let lost: Vec<&Task> = record.tasks.iter().filter(|task| !task.passed).collect();
    if lost.is_empty() {
        return out + "Every task is right.\n\n";
    }
    out += "## What is not right\n\n";
    if lost.len() > 1 {
        out += "Begin with the first task: later mistakes may follow from it.\n\n";
    }
    for task in lost {
        out += &format!(
            "### {}\n\n{}\n",
            markdown(&words.task(&task.id)),
            fenced(&line(&task.message))
        );
        if let Some(reading) = words.reading(&task.id) {
            out += &format!("Read {reading}. ");
        }
        out += &format!("`cargo lab hint {}` has hints.\n\n", task.id);
    }
    out
}

/// Returns the words that follow the points of a task in the table; empty if the task is right.
fn mark(record: &Record, task: &Task) -> &'static str {
    match (record.is_by_hand(&task.id), task.passed) {
        (true, _) => " **by hand**",
        (false, true) => "",
        (false, false) if task.points > 0.0 => IN_PART,
        (false, false) => " **not right**",
    }
}

fn speed(record: &Record, words: &Words) -> String {
    if record.marked.measures.is_empty() {
        return String::new();
    }
    let mut out = String::from("## Speed\n\n");
    for measure in &record.marked.measures {
        let (head, sentences) =
            (sentences::heading(measure), markdown(&sentences::measured(measure)));
        out += &format!("- **{head}.** {sentences}");
        for sentence in sentences::by_hand(record, Some(measure.kind.name())) {
            out += &format!(" {}", markdown(&sentence));
        }
        out.push('\n');
    }
    for sentence in sentences::speed(record, words) {
        out += &format!("- {sentence}\n");
    }
    out + "\n"
}

#[cfg(test)]
mod tests {
    use super::letter;
    use crate::record::{Attempt, Lateness, LeftOut, Record, Status};
    use crate::report::Words;

    #[test]
    fn it_says_what_failed_and_where_to_read() {
        let mut record = Record::sample();
        record.tasks[1].message = "bounce <b>of</b> 0.12\n```\n# x".into();
        let text = letter(&record, &Words { lab: "Lab 1: all pairs".into(), ..Words::default() });
        assert!(text.contains("60 of 100 points") && text.contains("### Task 1.2"), "{text}");
        assert!(text.contains("\n````text\nbounce <b>of</b> 0.12 ``` # x\n````\n"), "{text}");
        assert!(text.contains("cargo lab hint 1.2"), "{text}");
    }

    #[test]
    fn a_submission_that_does_not_compile_gets_the_compilers_words() {
        let mut record = Record::sample();
        record.found.status = Status::NotBuilt;
        record.found.message = "error[E0425]: `x`\n --> src/lib.rs".into();
        record.found.name = "[evil](http://x)<script>".into();
        let text = letter(&record, &Words::default());
        assert!(text.contains("does not compile") && text.contains("error[E0425]: `x`"), "{text}");
        assert!(text.contains("\\[evil\\]\\(http\\://x\\)\\<script\\>"), "{text}");
        assert!(!text.contains("What is not right"), "{text}");
    }

    #[test]
    fn a_path_is_code() {
        let mut record = Record::sample();
        let left_out = ["a_b.rs", "`<b>`"];
        record.found.left_out = left_out
            .map(|path| LeftOut { path: path.into(), reason: "no plain file".into() })
            .into();
        let text = letter(&record, &Words::default());
        assert!(text.contains("\n- `a_b.rs`: no plain file\n- \\`\\<b\\>\\`: no"), "{text}");
    }

    #[test]
    fn a_fault_of_the_machine_is_no_news_for_a_student() {
        let mut record = Record::sample();
        (record.found.status, record.found.message) =
            (Status::Failed, "cannot write /home/staff/x".into());
        let text = letter(&record, &Words::default());
        assert!(text.contains("could not be graded yet") && !text.contains("/home"), "{text}");
    }

    fn begins(record: &Record) -> String {
        let text = letter(record, &Words::default());
        text.lines().nth(2).unwrap().replace("**ada**: ", "")
    }

    #[test]
    fn what_is_no_mark_is_not_said_as_one() {
        let mut record = Record::sample();
        record.marked.late = Some(Lateness { days: 2, lost: 0.2 });
        record.marked.attempt = Attempt::Another;
        let sentences = begins(&record);
        assert!(
            sentences.starts_with("60 of 100 points. Another of your submissions counts. "),
            "{sentences}"
        );
        (record.found.status, record.marked.points) = (Status::Unreadable, 0.0);
        assert_eq!(begins(&record), "Another of your submissions counts.");
        record.marked.attempt = Attempt::Counts;
        assert_eq!(begins(&record), "There is no mark yet.");
    }
}
