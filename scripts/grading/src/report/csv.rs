//! `class.csv`: a row for each submission.

use anyhow::Result;

use super::{points, scale, trouble};
use crate::record::Record;
use lab_kit::escape;

/// Maximum number of characters of a mistake's message in the table. The letter contains the whole
/// message.
const LONGEST_TROUBLE: usize = 200;

/// Writes the table: names, totals, points of each task and measure, and the first mistake.
pub(crate) fn csv(records: &[Record]) -> Result<String> {
    let Some(first) = records.first() else { return Ok(String::new()) };
    let full = scale(records);
    let mut out = csv::Writer::from_writer(Vec::new());
    out.write_record(row(first, first, full).into_iter().map(|(column, _)| column))?;
    for record in records {
        out.write_record(row(record, first, full).iter().map(|(_, text)| escape::cell(text)))?;
    }
    Ok(String::from_utf8(out.into_inner()?)?)
}

/// Returns a row with the columns of the first record: pairs of a column's name and its text.
fn row(record: &Record, first: &Record, full: f64) -> Vec<(String, String)> {
    let decided = record.marked.by_hand.iter().filter_map(|one| match (one.points, one.days) {
        (Some(_), _) => Some(one.task.as_deref().unwrap_or("all")),
        (None, Some(_)) => Some("days"),
        (None, None) => None,
    });
    let known = [
        ("name", record.found.name.clone()),
        ("student", record.marked.student.clone().unwrap_or_default()),
        ("pseudonym", record.marked.pseudonym.clone().unwrap_or_default()),
        ("lab", record.found.lab.to_string()),
        ("state", trouble(record.found.status).unwrap_or("graded").into()),
        ("points", if record.has_mark() { points(record.marked.points) } else { String::new() }),
        ("of", points(full)),
        ("open", points(record.open_points())),
        ("days late", record.marked.late.as_ref().map_or(0, |late| late.days).to_string()),
        ("by hand", decided.collect::<Vec<_>>().join(" ")),
    ];
    let mut row = known.map(|(column, text)| (column.to_owned(), text)).to_vec();
    for task in &first.tasks {
        let own = record.tasks.iter().find(|own| own.id == task.id);
        row.push((task.id.clone(), own.map_or(String::new(), |task| points(task.points))));
    }
    for measure in &first.marked.measures {
        let own =
            record.marked.measures.iter().find(|own| own.kind == measure.kind && own.counts());
        let given = own.map_or(String::new(), |measure| points(measure.points));
        row.push((measure.kind.name().to_owned(), given));
    }
    let lost = record.tasks.iter().find(|task| !task.passed);
    let trouble = match lost {
        _ if !record.found.message.is_empty() => {
            record.found.message.lines().next().unwrap_or("").to_owned()
        }
        Some(task) => format!("{}: {}", task.id, task.message),
        None => String::new(),
    };
    row.push(("first trouble".into(), escape::cut(&trouble, LONGEST_TROUBLE)));
    row
}

#[cfg(test)]
mod tests {
    use super::csv;
    use crate::record::{Decision, Record, Status};

    fn decision(task: Option<&str>, points: Option<f64>, days: Option<u32>) -> Decision {
        let task = task.map(Into::into);
        Decision { student: "ada".into(), task, points, days, reason: "r".into() }
    }

    #[test]
    fn what_was_given_by_hand_is_named() {
        let mut record = Record::sample();
        record.marked.by_hand = vec![
            decision(None, None, Some(0)),
            decision(None, None, None),
            decision(Some("1.2"), Some(3.0), None),
            decision(None, Some(3.0), None),
        ];
        let text = csv(&[record]).unwrap();
        assert!(text.contains(",days 1.2 all,"), "{text}");
    }

    #[test]
    fn a_row_for_each_and_no_formula() {
        let mut record = Record::sample();
        record.found.name = "=cmd|' /C calc'!A0".into();
        record.tasks[1].message = "a \"b\",\nc".into();
        let text = csv(&[record.clone(), record]).unwrap();
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(
            lines[0],
            "name,student,pseudonym,lab,state,points,of,open,days late,by hand,1.1,1.2,first trouble"
        );
        assert_eq!(
            lines[1],
            "'=cmd|' /C calc'!A0,,,1,graded,60,100,0,0,,60,0,\"1.2: a \"\"b\"\", c\""
        );
        assert_eq!(lines.len(), 3);
    }

    #[test]
    fn what_is_no_mark_is_not_written_as_one() {
        let mut unreadable = Record::sample();
        unreadable.found.status = Status::Unreadable;
        unreadable.marked.points = 0.0;
        let text = csv(&[unreadable]).unwrap();
        assert!(text.contains(",1,could not be read,,100,"), "{text}");
    }
}
