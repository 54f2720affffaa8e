//! Table with a row for each submission.

use maud::{Markup, html};

use super::bars::bar;
use crate::record::{Attempt, Measure, Record, Task, Verdict};
use crate::report::{points, scale, sentences, trouble};
use lab_kit::escape::line;

/// Writes the table.
pub(crate) fn table(records: &[Record]) -> Markup {
    let Some(first) = records.first() else { return Markup::default() };
    let full = scale(records);
    html! {
        h2 { "Submissions" }
        div.wide {
            table {
                thead {
                    tr {
                        th { "name" }
                        th.points { "of " (points(full)) }
                        @for task in &first.tasks { th { (task.id) } }
                        @for measure in &first.marked.measures { th { (measure.kind.name()) } }
                    }
                }
                tbody {
                    @for (number, record) in records.iter().enumerate() { (row(number, record, first, full)) }
                }
            }
        }
        p.soft {
            "\u{2713} right, \u{2717} not right, ? open: not graded, and its points are not given yet. "
            "A number is the grade of a measure, of 100. Points in a frame were given by hand."
        }
    }
}

/// Writes a row, with the columns of the first record.
fn row(number: usize, record: &Record, first: &Record, full: f64) -> Markup {
    let name = line(&record.found.name);
    html! {
        tr.aside[record.marked.attempt != Attempt::Counts] {
            td {
                a href={ "#s" (number) } { (name) }
                @if !record.found.changed.is_empty() {
                    span.soft title=(line(&record.found.changed.join(" "))) { " changed given files" }
                }
                @if record.marked.attempt != Attempt::Counts { span.soft { " does not count" } }
            }
            td.points title=(sentences::by_hand(record, None).join(" ")) {
                @if record.has_mark() { (given(record, full)) }
            }
            @if let Some(trouble) = trouble(record.found.status) {
                td.ended colspan=(first.tasks.len() + first.marked.measures.len()) { (trouble) }
            } @else {
                @for task in &first.tasks {
                    td { @if let Some(own) = record.tasks.iter().find(|own| own.id == task.id) { (tick(record, own)) } }
                }
                @for measure in &first.marked.measures {
                    @let own = record.marked.measures.iter().find(|own| own.kind == measure.kind);
                    td { @if let Some(own) = own { (grade(record, own)) } }
                }
            }
        }
    }
}

/// Writes the points, the points that are still open, and the days late.
fn given(record: &Record, full: f64) -> Markup {
    let open = full - record.worth(Measure::counts);
    html! {
        @if record.decided(None).any(|one| one.points.is_some()) {
            span.hand { (points(record.marked.points)) }
        } @else {
            (points(record.marked.points))
        }
        @if open > 0.0 { " + " (points(open)) "?" }
        @if let Some(late) = &record.marked.late { span.soft { " " (late.days) " d late" } }
        (bar(record.marked.points / full))
    }
}

/// Writes points that a person gave, with the reason; `None` if no person gave points.
fn hand(record: &Record, task: &str, given: f64) -> Option<Markup> {
    let why = sentences::by_hand(record, Some(task)).join(" ");
    record.is_by_hand(task).then(|| html! { span.hand title=(line(&why)) { (points(given)) } })
}

fn tick(record: &Record, task: &Task) -> Markup {
    if let Some(points) = hand(record, &task.id, task.points) {
        return points;
    }
    if task.passed {
        return html! { span.good { "\u{2713}" } };
    }
    html! { span.bad title=(line(&task.message)) { "\u{2717}" } }
}

fn grade(record: &Record, measure: &Measure) -> Markup {
    if let Some(points) = hand(record, measure.kind.name(), measure.points) {
        return points;
    }
    let (class, text) = match (measure.verdict, measure.grade) {
        (Verdict::Graded, Some(grade)) => {
            (if grade >= 75.0 { "good" } else { "bad" }, format!("{grade:.0}"))
        }
        (Verdict::Wrong, _) => ("bad", "\u{2717}".into()),
        _ => ("open", "?".into()),
    };
    html! { span class=(class) title=(line(&measure.message)) { (text) } }
}
