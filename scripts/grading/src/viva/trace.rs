//! Traces of a student's program: how often lines run, and which run at the same time.

use std::collections::{BTreeMap, BTreeSet};
use std::io::Write;
use std::path::Path;
use std::process::Stdio;
use std::time::Duration;

use anyhow::{Context, Result};

use super::changes::{Change, Line};
use crate::sandbox::Sandbox;
use crate::timing::PROGRAM;
use lab_kit::process::{ends, start};
use lab_kit::sources::Sources;

/// Nanoseconds that a probe waits, so that different workers reach their lines during this time.
const PAUSE: u128 = 1_000_000;

/// Number of times that a line's probe waits.
///
/// An inner loop runs a line ten thousand times. If the probe waited a millisecond each time, a
/// trace would take minutes.
const PAUSES: u32 = 10;

/// Number of particles of a traced run.
pub(super) const PARTICLES: usize = 60;
/// Number of steps of a traced run.
pub(super) const STEPS: usize = 3;
/// Time limit of a traced run.
const LIMIT: Duration = Duration::from_secs(60);

/// Executions of a program's lines.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Trace {
    /// Number of executions of each line.
    pub(super) counts: BTreeMap<usize, usize>,
    /// For each line, the lines that other workers began while one worker was running this line.
    pub(super) together: BTreeMap<usize, BTreeSet<usize>>,
}

/// Adds a probe before each statement among `lines`.
pub(super) fn probe(sources: &mut Sources, lines: &[Line]) {
    for (number, line) in lines.iter().enumerate().filter(|(_, line)| is_statement(line)) {
        let new = format!(
            "{{ use std::{{process, sync::atomic, thread, time}}; \
             static RUNS: atomic::AtomicU32 = atomic::AtomicU32::new(0); \
             let waits = RUNS.fetch_add(1, atomic::Ordering::Relaxed) < {PAUSES}; \
             let now = time::UNIX_EPOCH.elapsed().map_or(0, |now| now.as_nanos() * u128::from(waits)); \
             eprintln!(\"@viva {number} {{}}-{{:?}} {{now}}\", process::id(), thread::current().id()); \
             if waits {{ thread::sleep(time::Duration::from_nanos({PAUSE})); }} }} {}",
            line.text
        );
        Change { line: line.clone(), new, story: None }.apply(sources);
    }
}

/// Whether a line begins a statement of Rust, so that a probe can be put before it.
fn is_statement(Line { path, text, begins, .. }: &Line) -> bool {
    let is_item = text.starts_with("pub") || text.split(' ').any(|word| word == "fn");
    let is_whole = *begins && text.ends_with([';', '{']) && !text.contains("=>");
    path.ends_with(".rs") && is_whole && !is_item && !text.starts_with(['}', '.', '#'])
}

impl Trace {
    /// Runs a variant of a program with probes on a small scene.
    pub(super) fn of(
        sandbox: &Sandbox,
        folder: &Path,
        variant: &str,
        workers: usize,
    ) -> Result<Self> {
        let mut command = sandbox.program(folder, PROGRAM);
        command.args(["viva", &workers.to_string()]);
        command.stdin(Stdio::piped()).stdout(Stdio::null()).stderr(Stdio::piped());
        let mut process = start(&mut command)?;
        let mut order = process.child.stdin.take().context("it has no input")?;
        // A program that has ended leaves an empty trace.
        let _ = writeln!(order, "lab {variant} {workers} {PARTICLES} 7 {STEPS}");
        drop(order);
        let output = ends(process.child.stderr.take());
        Ok(Self::read(&output.recv_timeout(LIMIT).unwrap_or_default()))
    }

    /// Reads the output of probes. The time of a probe that did not wait is 0.
    fn read(output: &str) -> Self {
        let mut trace = Self::default();
        let mut waits: Vec<(u128, usize, &str)> = Vec::new();
        for words in output.lines().filter_map(|line| Some(line.split_once("@viva ")?.1)) {
            if let [line, worker, time] = words.split(' ').collect::<Vec<_>>()[..]
                && let (Ok(line), Ok(time)) = (line.parse(), time.parse())
            {
                *trace.counts.entry(line).or_default() += 1;
                waits.extend((time > 0).then_some((time, line, worker)));
            }
        }
        waits.sort();
        for (index, (time, line, worker)) in waits.iter().enumerate() {
            let meanwhile = waits[index..].iter().take_while(|(later, ..)| *later < time + PAUSE);
            for (_, other, _) in meanwhile.filter(|(.., by)| by != worker) {
                trace.together.entry(*line).or_default().insert(*other);
            }
        }
        trace
    }
}

#[cfg(test)]
mod tests {
    use super::{PAUSE, Trace};

    #[test]
    fn lines_of_different_workers_within_a_pause_are_together() {
        let trace = Trace::read(&format!(
            "x @viva 1 a 7\nx @viva 2 b {}\nx @viva 1 a {}\n@viva 3\nx @viva 1 b 0\n",
            PAUSE + 6,
            PAUSE + 7
        ));
        assert_eq!(trace.counts, [(1, 3), (2, 1)].into());
        assert_eq!(trace.together, [(1, [2].into()), (2, [1].into())].into());
    }
}
