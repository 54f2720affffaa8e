//! What a lab's tests said the last time, kept under `target/`.

use std::fs;
use std::path::PathBuf;
use std::time::Duration;

use anyhow::{Context, Result};
use hmac_sha256::Hash;
use serde::{Deserialize, Serialize};

use lab_kit::answers::Task;
use lab_kit::harness::{Build, BuildError, Outcome, build};
use lab_kit::machine::on_all_cores;
use lab_kit::{Kit, Lab, files_below};

/// A single test may take so long.
const LIMIT: Duration = Duration::from_secs(180);

/// What the tests of a lab said.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct Results {
    /// What the lab's source was then.
    source: String,
    /// Every test and what came of it.
    pub(crate) outcomes: Vec<Outcome>,
}

/// Builds a student's lab and runs its tests: all, and remembers what came of them, or those of one
/// task. `advance` is called with the number of tests, then after each of them.
pub(crate) fn run(
    kit: &Kit,
    lab: Lab,
    only: Option<Task>,
    colour: bool,
    advance: impl Fn(Step) + Sync,
) -> Result<Results, BuildError> {
    let source = source(kit, lab).map_err(|e| BuildError::Cargo(format!("{e:#}")))?;
    let package = format!("lab{lab}");
    let program = build(Build { cargo: kit.cargo(), package: &package, lab, quiet: true, colour })?;
    let trouble = |e: anyhow::Error| BuildError::Cargo(format!("{e:#}"));
    let mut tests = program.tests().map_err(trouble)?;
    tests.retain(|test| only.is_none() || Task::of_test(test) == only);
    advance(Step::Tests(tests.len()));
    let run = |test: &String| {
        let outcome = program.run(test, &[], LIMIT);
        advance(Step::Tested);
        outcome
    };
    let outcomes: Result<Vec<_>> = on_all_cores(&tests, run).into_iter().collect();
    let results = Results { source, outcomes: outcomes.map_err(trouble)? };
    if only.is_none() {
        results.write(kit, lab).map_err(trouble)?;
    }
    Ok(results)
}

/// Runs the tests of one task, and puts what comes of them in the place of what came of them
/// before. It is not remembered: the other tests saw another source.
pub(crate) fn rerun(
    kit: &Kit,
    lab: Lab,
    task: Task,
    mut last: Results,
    colour: bool,
) -> Result<Results, BuildError> {
    let new = run(kit, lab, Some(task), colour, |_| {})?;
    last.outcomes.retain(|outcome| Task::of_test(&outcome.test) != Some(task));
    last.outcomes.extend(new.outcomes);
    Ok(last)
}

/// How far a run of tests is.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Step {
    /// They are built; there are so many.
    Tests(usize),
    /// One more has run.
    Tested,
}

impl Results {
    /// The results of the last run; none if there was none that can be read.
    pub(crate) fn read(kit: &Kit, lab: Lab) -> Option<Self> {
        let text = fs::read_to_string(place(kit, lab)).ok()?;
        serde_json::from_str(&text).ok()
    }

    /// Whether the lab's source is still what was tested.
    pub(crate) fn is_fresh(&self, kit: &Kit, lab: Lab) -> Result<bool> {
        Ok(self.source == source(kit, lab)?)
    }

    fn write(&self, kit: &Kit, lab: Lab) -> Result<()> {
        let path = place(kit, lab);
        let unwritten = || format!("cannot write {}", path.display());
        fs::create_dir_all(path.parent().unwrap_or(kit.root())).with_context(unwritten)?;
        let text = serde_json::to_vec_pretty(self)?;
        common::write_whole(&path, |out| out.write_all(&text)).with_context(unwritten)
    }
}

fn place(kit: &Kit, lab: Lab) -> PathBuf {
    kit.memory().join(format!("results/lab{lab}.json"))
}

/// A hash over the lab's source files and their names.
pub(crate) fn source(kit: &Kit, lab: Lab) -> Result<String> {
    let mut hash = Hash::new();
    let folder = kit.starter(lab);
    for path in files_below(&folder.join("src"))? {
        let bytes = fs::read(&path).with_context(|| format!("cannot read {}", path.display()))?;
        hash.update(path.strip_prefix(&folder)?.as_os_str().as_encoded_bytes());
        hash.update(&(bytes.len() as u64).to_le_bytes()[..]);
        hash.update(bytes);
    }
    Ok(hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect())
}
