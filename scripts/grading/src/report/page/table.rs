//! A line for each submission.

use maud::{Markup, html};

use super::bars::bar;
use super::share;
use crate::escape::line;
use crate::record::{Measure, Record, Task, Verdict};
use crate::report::{points, trouble};

/// The table.
pub(crate) fn table(records: &[Record]) -> Markup {
    let Some(first) = records.first() else { return Markup::default() };
    html! {
        h2 { "Submissions" }
        div.wide {
            table {
                thead {
                    tr {
                        th { "name" }
                        th.points { "points" }
                        @for task in first.tasks_in_order() { th { (task.id) } }
                        @for measure in &first.measures { th { (measure.kind.name()) } }
                    }
                }
                tbody {
                    @for (number, record) in records.iter().enumerate() { (row(number, record, first)) }
                }
            }
        }
        p.soft {
            "\u{2713} right, \u{2717} not right, ? open: not graded, and its points are not given yet. A number is the grade of a measure, of 100."
        }
    }
}

/// A row, with the columns of the first record.
fn row(number: usize, record: &Record, first: &Record) -> Markup {
    let name = line(&record.name);
    html! {
        tr {
            td title=(name) { a href={ "#s" (number) } { (name) } }
            td.points { (points(record.points)) " of " (points(record.out_of)) (bar(share(record))) }
            @if let Some(trouble) = trouble(record.status) {
                td.ended colspan=(first.tasks.len() + first.measures.len()) { (trouble) }
            } @else {
                @for task in first.tasks_in_order() {
                    td { @if let Some(own) = record.tasks.iter().find(|own| own.id == task.id) { (tick(own)) } }
                }
                @for measure in &first.measures {
                    @let own = record.measures.iter().find(|own| own.kind == measure.kind);
                    td { @if let Some(own) = own { (grade(own)) } }
                }
            }
        }
    }
}

fn tick(task: &Task) -> Markup {
    if task.passed {
        return html! { span.good { "\u{2713}" } };
    }
    html! { span.bad title=(line(&task.message)) { "\u{2717}" } }
}

fn grade(measure: &Measure) -> Markup {
    let (class, text) = match (measure.verdict, measure.grade) {
        (Verdict::Graded, Some(grade)) => {
            (if grade >= 75.0 { "good" } else { "bad" }, format!("{grade:.0}"))
        }
        (Verdict::Wrong, _) => ("bad", "\u{2717}".into()),
        _ => ("open", "?".into()),
    };
    html! { span class=(class) title=(line(&measure.message)) { (text) } }
}
