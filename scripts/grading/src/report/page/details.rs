//! Each submission in words.

use maud::{Markup, html};

use crate::escape::{line, plain};
use crate::record::Record;
use crate::report::{Words, points, scale, trouble, words};

/// What went wrong, folded, in words.
pub(crate) fn details(records: &[Record], words: &Words) -> Markup {
    let full = scale(records);
    html! {
        h2 { "One by one" }
        @for (number, record) in records.iter().enumerate() {
            details {
                summary { b { (line(&record.name)) } ", " (state(record, full)) }
                div id={ "s" (number) } { (body(record, words)) }
            }
        }
    }
}

fn state(record: &Record, full: f64) -> String {
    let points = || format!("{} of {} points", points(record.points), points(full));
    trouble(record.status).map_or_else(points, str::to_owned)
}

fn body(record: &Record, words: &Words) -> Markup {
    html! {
        @for sentence in words::by_hand(record, None) { p { (line(&sentence)) } }
        @if !record.message.is_empty() { pre { (plain(&record.message)) } }
        @if trouble(record.status).is_none() {
            @for task in record.tasks_in_order() {
                @if !task.passed {
                    p { "\u{2717} " (words.task(&task.id)) }
                    pre { (plain(&task.message)) }
                }
                @for sentence in words::by_hand(record, Some(&task.id)) {
                    p { "Task " (task.id) ": " (line(&sentence)) }
                }
            }
            @for measure in &record.measures {
                p { b { (line(&words::heading(measure))) "." } " " (line(&words::measured(measure))) }
            }
            @for sentence in words::speed(record) { p.soft { (code(&line(&sentence))) } }
        }
        @for left in &record.left_out {
            p.soft { "Not taken: " (line(&left.path)) ": " (line(&left.reason)) }
        }
    }
}

/// What stands between two backticks, as code.
fn code(text: &str) -> Markup {
    let parts: Vec<&str> = text.split('`').collect();
    html! {
        @for (at, part) in parts.iter().enumerate() {
            @if at % 2 == 0 { (part) }
            @else if at + 1 < parts.len() { code { (part) } }
            @else { "`" (part) }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::code;

    #[test]
    fn only_pairs_of_backticks_are_code() {
        assert_eq!(code("`team` with 2 threads").0, "<code>team</code> with 2 threads");
        assert_eq!(code("one ` alone").0, "one ` alone");
        assert_eq!(code("`a` and `b").0, "<code>a</code> and `b");
    }
}
