//! `class.csv`: a row for each submission.

use super::{points, trouble};
use crate::escape;
use crate::record::Record;

/// Names, totals, points of each task and measure, and the first thing that went wrong.
pub(crate) fn csv(records: &[Record]) -> String {
    let Some(first) = records.first() else { return String::new() };
    let mut header =
        ["name", "lab", "state", "points", "out of", "not graded"].map(escape::csv).to_vec();
    header.extend(first.tasks_in_order().iter().map(|task| escape::csv(&task.id)));
    header.extend(first.measures.iter().map(|measure| escape::csv(measure.kind.name())));
    header.push(escape::csv("first trouble"));
    let rows = records.iter().map(|record| row(record, first));
    [header].into_iter().chain(rows).map(|row| row.join(",") + "\n").collect()
}

/// A row, with the columns of the first record.
fn row(record: &Record, first: &Record) -> Vec<String> {
    let mut row = vec![
        escape::csv(&record.name),
        record.lab.to_string(),
        escape::csv(trouble(record.status).unwrap_or("graded")),
        points(record.points),
        points(record.out_of),
        points(record.open_points()),
    ];
    for task in first.tasks_in_order() {
        let own = record.tasks.iter().find(|own| own.id == task.id);
        row.push(own.map_or(String::new(), |task| points(task.points)));
    }
    for measure in &first.measures {
        let own = record.measures.iter().find(|own| own.kind == measure.kind && own.counts());
        row.push(own.map_or(String::new(), |measure| points(measure.points)));
    }
    let lost = record.tasks_in_order().into_iter().find(|task| !task.passed);
    let why = match lost {
        _ if !record.message.is_empty() => record.message.lines().next().unwrap_or("").to_owned(),
        Some(task) => format!("{}: {}", task.id, task.message),
        None => String::new(),
    };
    row.push(escape::csv(&why));
    row
}

#[cfg(test)]
mod tests {
    use super::csv;
    use crate::record::Record;

    #[test]
    fn a_row_for_each_and_no_formula() {
        let mut record = Record::sample();
        record.name = "=cmd|' /C calc'!A0".into();
        record.tasks[1].message = "a \"b\",\nc".into();
        let text = csv(&[record.clone(), record]);
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(
            lines[0],
            "\"name\",\"lab\",\"state\",\"points\",\"out of\",\"not graded\",\"1.1\",\"1.2\",\"first trouble\""
        );
        assert_eq!(
            lines[1],
            "\"'=cmd|' /C calc'!A0\",1,\"graded\",60,100,0,60,0,\"1.2: a \"\"b\"\", c\""
        );
        assert_eq!(lines.len(), 3);
    }
}
