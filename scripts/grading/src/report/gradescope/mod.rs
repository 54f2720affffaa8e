//! `gradescope/NAME.json`: Gradescope's results.json.
//!
//! Its documentation: <https://gradescope-autograders.readthedocs.io/en/latest/specs/>. Outputs are
//! shown as text in a `<pre>`, so nothing of them is markup.

#[cfg(test)]
mod form;

use serde_json::{Value, json};

use super::{Words, points, trouble, words};
use crate::escape::{line, plain};
use crate::record::Record;

/// What Gradescope shows of a record: a test for each task and each measure.
pub(crate) fn results(record: &Record, words: &Words) -> Value {
    let tasks = record.tasks_in_order().into_iter().map(|task| {
        let mut output = line(&task.message);
        if let Some(reading) = words.reading(&task.id).filter(|_| !task.passed) {
            output = format!("{output}\nRead {reading}.").trim_start().to_owned();
        }
        for sentence in words::by_hand(record, Some(&task.id)) {
            output = format!("{output}\n{}", line(&sentence)).trim_start().to_owned();
        }
        json!({
            "name": words.task(&task.id), "number": task.id,
            "score": task.points, "max_score": task.out_of, "output": output,
        })
    });
    let measures = record.measures.iter().map(|measure| {
        // What is not graded must not lower the total.
        let (score, most) =
            if measure.counts() { (measure.points, measure.out_of) } else { (0.0, 0.0) };
        json!({
            "name": line(&words::heading(measure)), "score": score, "max_score": most,
            "output": line(&words::measured(measure)),
        })
    });
    let tests: Vec<Value> = tasks.chain(measures).collect();
    json!({
        "score": record.points,
        "output": output(record, words),
        "stdout_visibility": "hidden",
        "extra_data": {
            "sources": record.hash, "grader": record.grader, "seed": record.seed,
            "toolchain": record.toolchain, "machine": record.machine, "sandboxed": record.sandboxed,
        },
        "tests": tests,
    })
}

fn output(record: &Record, words: &Words) -> String {
    let (given, most) = (points(record.points), points(words.full(record)));
    let mut text = format!("{given} of {most} points.");
    if record.open_points() > 0.0 {
        let open = points(record.open_points());
        text += &format!(" {open} points are open: they hang on times that were not graded.");
    }
    if !record.sandboxed {
        text += "\nIt ran without a sandbox: none can be made here.";
    }
    for sentence in words::by_hand(record, None) {
        text += &format!("\n{}", line(&sentence));
    }
    if let Some(trouble) = trouble(record.status) {
        text += &format!("\nThe submission {trouble}.\n\n{}", plain(&record.message));
    }
    for sentence in words::speed(record) {
        text += &format!("\n{}", line(&sentence));
    }
    for path in &record.changed {
        text += &format!("\nGiven, so the kit's was compiled and not yours: {}", line(path));
    }
    for left in &record.left_out {
        text += &format!("\nNot taken: {}: {}", line(&left.path), line(&left.reason));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::form::Results;
    use super::results;
    use crate::record::{Record, Status, Verdict};
    use crate::report::Words;

    fn check(record: &Record) -> Results {
        let value = results(record, &Words::default());
        let results = Results::read(value).unwrap();
        let tests = results.tests.as_deref().unwrap_or_default();
        let sum: f64 = tests.iter().filter_map(|test| test.score).sum();
        assert!((sum - record.points).abs() < 1e-9, "{sum}");
        assert!(tests.iter().all(|test| test.score <= test.max_score));
        results
    }

    #[test]
    fn it_has_the_documented_form() {
        assert_eq!(check(&Record::sample()).tests.unwrap().len(), 2);
        let record = Record::sample_of_speed(Verdict::TooNoisy);
        let results = check(&record);
        assert!(results.output.unwrap().contains("25 points are open"));
        assert_eq!(results.tests.unwrap()[2].max_score, Some(0.0));
    }

    #[test]
    fn a_broken_submission_has_it_too() {
        let mut record = Record::sample();
        (record.status, record.message) = (Status::Unreadable, "\u{1b}[2Jnot an archive".into());
        record.points = 0.0;
        record.tasks.iter_mut().for_each(|task| task.points = 0.0);
        let output = check(&record).output.unwrap();
        assert!(output.contains("could not be read") && !output.contains('\u{1b}'), "{output}");
    }
}
