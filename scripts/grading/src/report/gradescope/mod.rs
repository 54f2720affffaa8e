//! `gradescope/NAME.json`: Gradescope's results.json.
//!
//! Its documentation: <https://gradescope-autograders.readthedocs.io/en/latest/specs/>. Above the tests stands the
//! letter, in Markdown; outputs of tests are shown as text, so nothing of them is markup.

#[cfg(test)]
mod form;

use serde_json::{Value, json};

use super::{Words, letter, words};
use crate::escape::line;
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
    let mut output = letter::around(record, words, "");
    if !record.sandboxed {
        output += "It ran without a sandbox: none can be made here.\n";
    }
    json!({
        "score": record.points,
        "output": output,
        "output_format": "md",
        "stdout_visibility": "hidden",
        "extra_data": {
            "sources": record.hash, "grader": record.grader, "seed": record.seed,
            "toolchain": record.toolchain, "machine": record.machine, "sandboxed": record.sandboxed,
        },
        "tests": tests,
    })
}

#[cfg(test)]
mod tests {
    use super::form::Results;
    use super::results;
    use crate::record::{Record, Status, Verdict};
    use crate::report::Words;

    fn check(record: &Record) -> Results {
        let value = results(record, &Words::default());
        let results: Results = serde_json::from_value(value).unwrap();
        let sum: f64 = results.tests.iter().map(|test| test.score).sum();
        assert!((sum - record.points).abs() < 1e-9, "{sum}");
        assert!(results.tests.iter().all(|test| test.score <= test.max_score));
        results
    }

    #[test]
    fn it_has_the_documented_form() {
        assert_eq!(check(&Record::sample()).tests.len(), 2);
        let record = Record::sample_of_speed(Verdict::TooNoisy);
        let results = check(&record);
        assert!(results.output.contains("25 points are open"));
        assert_eq!(results.tests[2].max_score, 0.0);
    }

    #[test]
    fn a_broken_submission_has_it_too() {
        let mut record = Record::sample();
        (record.status, record.message) = (Status::Unreadable, "\u{1b}[2Jnot an archive".into());
        record.points = 0.0;
        record.tasks.iter_mut().for_each(|task| task.points = 0.0);
        let output = check(&record).output;
        assert!(output.contains("could not be read") && !output.contains('\u{1b}'), "{output}");
    }
}
