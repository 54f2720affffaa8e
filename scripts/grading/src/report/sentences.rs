//! Sentences about speed, which a student reads.

use std::collections::BTreeMap;

use super::{Words, points};
use crate::record::{Decision, Measure, Outcome, Record, Run, Verdict, Whose};
use crate::timing::seconds_of;
use lab_kit::Workers;
use lab_kit::table::three_digits;

/// Returns the heading of a measure: `scaling of team: 18.5 of 20 points`.
pub(crate) fn heading(measure: &Measure) -> String {
    let what = format!("{} of {}", measure.kind.name(), measure.variant);
    match measure.verdict {
        Verdict::Graded | Verdict::Wrong => {
            format!("{what}: {} of {} points", points(measure.points), points(measure.out_of))
        }
        Verdict::TooNoisy => format!("{what}: open, too noisy to grade"),
        Verdict::NotTimed => format!("{what}: open, not timed"),
    }
}

/// Returns the measurement as a sentence.
pub(crate) fn measured(measure: &Measure) -> String {
    let mut letters = measure.message.chars();
    let first = letters.next().into_iter().flat_map(char::to_uppercase);
    first.chain(letters).chain(['.']).collect()
}

/// Returns a person's decisions about a task or a measure as sentences.
///
/// Without a task, the sentences are about decisions on the whole submission, and about its
/// lateness.
pub(crate) fn by_hand(record: &Record, task: Option<&str>) -> Vec<String> {
    let mut remarks = Vec::new();
    let late = record.marked.late.as_ref().filter(|_| record.has_mark());
    if let (None, Some(late)) = (task, late) {
        let days = late.days();
        let lost = points(100.0 * late.lost);
        remarks.push(format!("It came {days} late, which costs {lost} % of the points."));
    }
    for Decision { points: given, reason, .. } in record.decided(task) {
        let reason = reason.trim().trim_end_matches('.');
        remarks.push(match given {
            Some(given) => format!("Your instructor gave {} points: {reason}.", points(*given)),
            None => format!("Your instructor says: {reason}."),
        });
    }
    remarks
}

/// Returns sentences about the speed of the submission's programs.
pub(crate) fn speed(record: &Record, words: &Words) -> Vec<String> {
    let own = record.found.runs.iter().filter(|run| run.whose == Whose::Own && run.steps > 0);
    // One run of each variant is enough: the largest scene with the most threads.
    let mut chosen: BTreeMap<&str, &Run> = BTreeMap::new();
    for run in own.filter(|run| run.outcome == Outcome::Timed) {
        let largest = chosen.entry(&run.variant).or_insert(run);
        if (largest.n, largest.workers) < (run.n, run.workers) {
            *largest = run;
        }
    }
    chosen.into_values().flat_map(|run| sentences(record, run, words)).collect()
}

fn sentences(record: &Record, run: &Run, words: &Words) -> Vec<String> {
    let Some(seconds) = seconds_of(&record.found, run) else { return Vec::new() };
    let worker = if words.facts.workers == Workers::Ranks { "rank" } else { "thread" };
    let workers =
        if run.workers == 1 { format!("1 {worker}") } else { format!("{} {worker}s", run.workers) };
    let nanoseconds = seconds * 1e9 / (run.n as f64 * run.steps as f64);
    let mut remarks = vec![format!(
        "`{}` with {workers} on {} particles took {} ns per particle and step.",
        run.variant,
        run.n,
        three_digits(nanoseconds)
    )];
    let wall: f64 = run.seconds.iter().sum();
    if let Some(busy) = run.processors.filter(|busy| *busy > 0.0 && wall > 0.0) {
        let used = busy / wall;
        let mut text = format!("It kept {used:.2} of {} processors busy.", run.workers);
        if run.workers > 1 && used < 0.75 * run.workers as f64 {
            text += &format!(" The rest of the time {worker}s waited, or had not been started.");
        }
        remarks.push(text);
    }
    remarks
}

#[cfg(test)]
mod tests {
    use super::speed;
    use crate::record::{Record, Run, Whose};
    use crate::report::Words;

    #[test]
    fn the_largest_run_is_told() {
        let mut record = Record::sample();
        for (n, workers) in [(1000, 1), (100_000, 2), (100_000, 1)] {
            let run = Run::planned(Whose::Own, "queues", n, workers, 50);
            record.found.runs.push(Run { seconds: vec![0.2; 5], processors: Some(1.1), ..run });
        }
        let remarks = speed(&record, &Words::default());
        assert_eq!(
            remarks[0],
            "`queues` with 2 threads on 100000 particles took 40.0 ns per particle and step."
        );
        assert!(
            remarks[1].contains("1.10 of 2 processors") && remarks[1].contains("waited"),
            "{remarks:?}"
        );
        assert_eq!(remarks.len(), 2);
    }
}
