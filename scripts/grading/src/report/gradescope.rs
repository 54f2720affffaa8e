//! `gradescope/NAME.json`: Gradescope's results.json.
//!
//! Its documentation: <https://gradescope-autograders.readthedocs.io/en/latest/specs/>. The letter
//! is shown above the tests, as Markdown. The output of a test is shown as text, so it cannot
//! contain markup.

use serde_json::{Value, json};

use super::{Words, letter, sentences};
use crate::record::Record;
use lab_kit::escape::line;
use lab_measure::commands::contest::{Entry, unranked};

/// Converts a record for Gradescope: a test for each task and each measure.
pub(crate) fn results(record: &Record, words: &Words) -> Value {
    let tasks = record.tasks.iter().map(|task| {
        let mut output = line(&task.message);
        if let Some(reading) = words.reading(&task.id).filter(|_| !task.passed) {
            output = format!("{output}\nRead {reading}.").trim_start().to_owned();
        }
        for sentence in sentences::by_hand(record, Some(&task.id)) {
            output = format!("{output}\n{}", line(&sentence)).trim_start().to_owned();
        }
        json!({
            "name": words.task(&task.id), "number": task.id,
            "score": task.points, "max_score": task.out_of, "output": output,
        })
    });
    let measures = record.marked.measures.iter().map(|measure| {
        // A measure without a grade must not lower the total.
        let (score, most) =
            if measure.counts() { (measure.points, measure.out_of) } else { (0.0, 0.0) };
        json!({
            "name": line(&sentences::heading(measure)), "score": score, "max_score": most,
            "output": line(&sentences::measured(measure)),
        })
    });
    let tests: Vec<Value> = tasks.chain(measures).collect();
    let mut output = letter::around(record, words, "");
    if !record.found.sandboxed {
        output += "It ran without a sandbox: none can be made here.\n";
    }
    let mut results = json!({
        "score": record.marked.points,
        "output": output,
        "output_format": "md",
        "stdout_visibility": "hidden",
        "extra_data": {
            "sources": record.found.hash, "grader": record.found.grader, "seed": record.found.seed,
            "toolchain": record.found.toolchain, "machine": record.found.machine, "sandboxed": record.found.sandboxed,
        },
        "tests": tests,
    });
    if let Some(entry) = &record.found.contest {
        results["leaderboard"] = leaderboard(entry);
    }
    results
}

/// Lists the numbers that Gradescope's leaderboard compares. The list is empty if the entry is not
/// ranked.
fn leaderboard(entry: &Entry) -> Value {
    if unranked(entry).is_some() {
        return json!([]);
    }
    let numbers = [("time", entry.time), ("error", entry.error)].into_iter();
    let rows = numbers.filter_map(|(name, span)| {
        Some(json!({ "name": name, "value": span?.median, "order": "asc" }))
    });
    rows.collect()
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use oracle::contest::Kind;
    use serde_json::{Value, json};

    use super::results;
    use crate::record::{Record, Status, Verdict};
    use crate::report::Words;

    /// Keys of the results that Gradescope documents.
    const KEYS: &str = "extra_data output output_format score stdout_visibility tests";
    /// Keys of a test that Gradescope documents.
    const KEYS_OF_A_TEST: &str = "max_score name number output score";

    fn keys(object: &Value) -> impl Iterator<Item = &String> {
        object.as_object().unwrap().keys()
    }

    /// Returns the text above the tests, and the points and the maximum points of each test.
    fn check(record: &Record) -> (String, Vec<[f64; 2]>) {
        let results = results(record, &Words::default());
        assert!(keys(&results).eq(KEYS.split(' ')));
        let tests = results["tests"].as_array().unwrap().iter().map(|test| {
            assert!(keys(test).all(|key| KEYS_OF_A_TEST.contains(key.as_str())));
            ["score", "max_score"].map(|key| test[key].as_f64().unwrap())
        });
        let tests: Vec<[f64; 2]> = tests.collect();
        assert_eq!(results["score"].as_f64(), Some(record.marked.points));
        assert!(
            (tests.iter().map(|test| test[0]).sum::<f64>() - record.marked.points).abs() < 1e-9
        );
        assert!(tests.iter().all(|[score, most]| score <= most), "{tests:?}");
        (results["output"].as_str().unwrap().to_owned(), tests)
    }

    #[test]
    fn it_has_the_documented_form() {
        assert_eq!(check(&Record::sample()).1.len(), 2);
        let record = Record::sample_of_speed(Verdict::TooNoisy);
        let (output, tests) = check(&record);
        assert!(output.contains("25 points are open"));
        assert_eq!(tests[2][1], 0.0);
    }

    /// Returns the leaderboard and the letter of an entry with this error.
    fn shown(error: f64) -> (String, String) {
        let round = json!([{ "time": 0.5, "error": error }]);
        let kinds = Kind::ALL.map(|kind| (kind.name(), round.clone()));
        let entry = json!({
            "program": "lab14:entry", "kinds": BTreeMap::from(kinds), "instructions": null,
            "time": { "min": 0.5, "median": 0.5 }, "error": { "min": error, "median": error },
            "faults": [],
        });
        let mut record = Record::sample();
        record.found.contest = Some(serde_json::from_value(entry).unwrap());
        let results = results(&record, &Words::default());
        (results["leaderboard"].to_string(), results["output"].to_string())
    }

    #[test]
    fn the_leaderboard_lists_only_ranked_entries() {
        let (rows, letter) = shown(1.0);
        let time = r#"{"name":"time","order":"asc","value":0.5}"#;
        let error = r#"{"name":"error","order":"asc","value":1.0}"#;
        assert_eq!(rows, format!("[{time},{error}]"));
        assert!(!letter.contains("not ranked"), "{letter}");
        let (rows, letter) = shown(2.0);
        assert_eq!(rows, "[]");
        assert!(letter.contains("not ranked: official: the error is above 1.05."), "{letter}");
    }

    #[test]
    fn a_broken_submission_has_it_too() {
        let mut record = Record::sample();
        (record.found.status, record.found.message) =
            (Status::Unreadable, "\u{1b}[2Jnot an archive".into());
        record.marked.points = 0.0;
        record.tasks.iter_mut().for_each(|task| task.points = 0.0);
        let (output, _) = check(&record);
        assert!(output.contains("could not be read") && !output.contains('\u{1b}'), "{output}");
    }
}
