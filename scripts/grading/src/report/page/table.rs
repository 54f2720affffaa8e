//! A line for each submission.

use super::share;
use crate::escape::{html, line};
use crate::record::{Measure, Record, Task, Verdict};
use crate::report::{points, trouble};

/// The table.
pub(crate) fn table(records: &[Record]) -> String {
    let Some(first) = records.first() else { return String::new() };
    let mut out = String::from(
        "<h2>Submissions</h2>\n<div class=\"wide\"><table>\n<thead><tr><th>name</th><th class=\"points\">points</th>",
    );
    for task in first.tasks_in_order() {
        out += &format!("<th>{}</th>", html(&task.id));
    }
    for measure in &first.measures {
        out += &format!("<th>{}</th>", measure.kind.name());
    }
    out += "</tr></thead>\n<tbody>\n";
    for (number, record) in records.iter().enumerate() {
        let name = html(&line(&record.name));
        out += &format!(
            "<tr><td title=\"{name}\"><a href=\"#s{number}\">{name}</a></td>\
             <td class=\"points\">{} of {}<span class=\"bar\"><i style=\"width:{:.0}%\"></i></span></td>",
            points(record.points),
            points(record.out_of),
            100.0 * share(record)
        );
        if let Some(trouble) = trouble(record.status) {
            let columns = first.tasks.len() + first.measures.len();
            out += &format!("<td class=\"ended\" colspan=\"{columns}\">{trouble}</td></tr>\n");
            continue;
        }
        for task in first.tasks_in_order() {
            out += &cell(record.tasks.iter().find(|own| own.id == task.id));
        }
        for measure in &first.measures {
            out += &grade(record.measures.iter().find(|own| own.kind == measure.kind));
        }
        out += "</tr>\n";
    }
    out + "</tbody>\n</table></div>\n<p class=\"soft\">\u{2713} right, \u{2717} not right, ? not \
           graded. A number is the grade of a measure, of 100.</p>\n"
}

fn cell(task: Option<&Task>) -> String {
    match task {
        Some(task) if task.passed => "<td><span class=\"good\">\u{2713}</span></td>".into(),
        Some(task) => format!(
            "<td><span class=\"bad\" title=\"{}\">\u{2717}</span></td>",
            html(&line(&task.message))
        ),
        None => "<td></td>".into(),
    }
}

fn grade(measure: Option<&Measure>) -> String {
    let Some(measure) = measure else { return "<td></td>".into() };
    let (class, text) = match (measure.verdict, measure.grade) {
        (Verdict::Graded, Some(grade)) => {
            (if grade >= 75.0 { "good" } else { "bad" }, format!("{grade:.0}"))
        }
        (Verdict::Wrong, _) => ("bad", "\u{2717}".into()),
        _ => ("open", "?".into()),
    };
    let why = html(&line(&measure.message));
    format!("<td><span class=\"{class}\" title=\"{why}\">{text}</span></td>")
}
