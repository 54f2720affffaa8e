//! Results of the last run of a lab's tests, kept under `target/`.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use anyhow::Result;
use serde::{Deserialize, Serialize};

use crate::memory::{recall, remember};
use crate::tasks::{self, Progress};
use lab_kit::answers::Task;
use lab_kit::files::digest;
use lab_kit::harness::{Build, BuildError, Outcome, build};
use lab_kit::machine::on_all_cores;
use lab_kit::starter::{Record, read_below};
use lab_kit::{Kit, Lab, Workers};

/// Time limit of a test with threads. Such a test takes seconds, so a longer one is endless.
const LIMIT: Duration = Duration::from_secs(30);

/// Time limit of a test with ranks or a device. These start more slowly, and tests with ranks have
/// their own watchdog.
const LONG_LIMIT: Duration = Duration::from_secs(180);

/// Last result of every test of a lab.
#[derive(Debug, Default, Serialize, Deserialize)]
pub(crate) struct Results {
    pub(crate) outcomes: Vec<Outcome>,
    /// Hash of the lab's source when each test ran, by the test's name.
    sources: BTreeMap<String, String>,
}

/// Results of a single run of tests.
#[derive(Debug, Default, Serialize)]
pub(crate) struct Run {
    /// The lab's tasks, or the chosen one, with the outcomes of their tests.
    pub(crate) tasks: Vec<Progress>,
    /// Outcomes of tests that belong to no task.
    pub(crate) others: Vec<Outcome>,
    /// Number of tests that did not run, because an earlier test did not end.
    pub(crate) left_out: usize,
}

impl Run {
    /// Returns the outcomes of all tests.
    pub(crate) fn outcomes(&self) -> impl Iterator<Item = &Outcome> {
        self.tasks.iter().flat_map(|task| &task.tests).chain(&self.others)
    }

    /// Returns the failures of tests that belong to no task.
    pub(crate) fn other_failures(&self) -> Vec<&Outcome> {
        self.others.iter().filter(|outcome| !outcome.passes()).collect()
    }

    /// Whether every test has run and passes.
    pub(crate) fn passes(&self) -> bool {
        self.left_out == 0 && self.outcomes().all(Outcome::passes)
    }
}

/// Builds a student's lab, runs all its tests or the tests of one task, and keeps the results.
///
/// It calls `advance` at every step.
pub(crate) fn run(
    kit: &Kit,
    lab: Lab,
    only: Option<Task>,
    tests: Build,
    advance: impl Fn(Step<'_>) + Sync,
) -> Result<Run, BuildError> {
    let source = source(kit, lab)?;
    let threads = kit.facts(lab)?.workers == Workers::Threads;
    let limit = if threads { LIMIT } else { LONG_LIMIT };
    let program = build(tests)?;
    let mut tests = program.tests()?;
    tests.retain(|test| only.is_none() || Task::of_test(test) == only);
    advance(Step::Tests(tests.len()));
    // After an endless loop, most other tests would exceed their time limits too.
    let timed_out = AtomicBool::new(false);
    let outcomes = on_all_cores(&tests, |test| {
        if timed_out.load(Ordering::Relaxed) {
            return Ok(None);
        }
        advance(Step::Begun(test));
        let outcome = program.run(test, &[], limit)?;
        timed_out.fetch_or(outcome.hung(), Ordering::Relaxed);
        advance(Step::Ended(test));
        Ok(Some(outcome))
    });
    let outcomes: Result<Vec<_>> = outcomes.into_iter().collect();
    let outcomes: Vec<Outcome> = outcomes?.into_iter().flatten().collect();
    let left_out = tests.len() - outcomes.len();
    let mut results = match Results::read(kit, lab) {
        Some(results) if only.is_some() || left_out > 0 => results,
        _ => Results::default(),
    };
    results.add(&outcomes, &source);
    results.write(kit, lab)?;
    let mut tasks = tasks::progress(kit, lab, &outcomes)?;
    tasks.retain(|progress| only.is_none_or(|task| progress.task == task));
    let mut others = outcomes;
    others.retain(|outcome| Task::of_test(&outcome.test).is_none());
    Ok(Run { tasks, others, left_out })
}

/// Progress of a run of tests.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Step<'a> {
    /// The tests are built, and this is their number.
    Tests(usize),
    /// This test starts.
    Begun(&'a str),
    /// This test has ended.
    Ended(&'a str),
}

impl Results {
    /// Reads the last results; `None` if there are no results, or if they cannot be read.
    pub(crate) fn read(kit: &Kit, lab: Lab) -> Option<Self> {
        recall(kit, &name(lab))
    }

    /// Whether the lab's source is unchanged since every test ran.
    pub(crate) fn is_fresh(&self, kit: &Kit, lab: Lab) -> Result<bool> {
        let source = source(kit, lab)?;
        Ok(self.sources.values().all(|seen| *seen == source))
    }

    /// Replaces the earlier outcomes of these tests.
    fn add(&mut self, outcomes: &[Outcome], source: &str) {
        for outcome in outcomes {
            self.outcomes.retain(|old| old.test != outcome.test);
            self.outcomes.push(outcome.clone());
            self.sources.insert(outcome.test.clone(), source.to_owned());
        }
    }

    fn write(&self, kit: &Kit, lab: Lab) -> Result<()> {
        remember(kit, &name(lab), self)
    }
}

/// Returns the file of a lab's results.
pub(crate) fn file(kit: &Kit, lab: Lab) -> PathBuf {
    kit.memory().join(name(lab))
}

fn name(lab: Lab) -> String {
    format!("results/lab{lab}.json")
}

/// Returns a hash of the lab's source files and their names.
pub(crate) fn source(kit: &Kit, lab: Lab) -> Result<String> {
    let files = read_below(&kit.starter(lab).join("src"))?;
    Ok(digest(Record::of(&files).to_text().as_bytes()))
}

#[cfg(test)]
mod tests {
    use super::Results;
    use crate::list::Overview;
    use lab_kit::Kit;
    use lab_kit::files::write_file;
    use lab_kit::harness::{Outcome, Verdict};

    #[test]
    fn tests_of_one_task_count_beside_the_others() {
        let folder = tempfile::tempdir().unwrap();
        let kit = Kit::at(folder.path());
        let lab = "1".parse().unwrap();
        let mut results = Results::default();
        for (source, test, verdict, done, stale) in [
            ("1.1", "task_1_1::a", Verdict::Passed, 1, false),
            ("1.1", "task_1_2::a", Verdict::Failed, 1, false),
            // Task 1.1 was tested with a different source.
            ("1.1, 1.2", "task_1_2::a", Verdict::Passed, 2, true),
            ("1.1, 1.2", "task_1_1::a", Verdict::Passed, 2, false),
        ] {
            write_file(&kit.path("labs/lab1/src/lib.rs"), source).unwrap();
            let outcome = Outcome::new(test, verdict, "");
            results.add(&[outcome], &super::source(&kit, lab).unwrap());
            results.write(&kit, lab).unwrap();
            let overview = Overview::of(&kit, lab).unwrap();
            assert_eq!((overview.done(), overview.stale), (done, stale), "{source}, {test}");
        }
    }
}
