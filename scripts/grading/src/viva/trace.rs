//! Traces of a student's program: which lines run, how often, on which workers, and together.

use std::collections::{BTreeMap, BTreeSet};
use std::io::Write;
use std::process::Stdio;
use std::time::Duration;

use anyhow::{Context, Result};

use super::changes::Line;
use crate::sandbox::Sandbox;
use crate::timing::PROGRAM;
use lab_kit::process::{ends, start};
use lab_kit::submission::Sources;

/// Nanoseconds that a probe waits, so that other workers can reach their lines meanwhile.
const PAUSE: u128 = 1_000_000;

/// Executions of a program's lines.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Trace {
    /// Number of executions of each line.
    pub(super) counts: BTreeMap<usize, usize>,
    /// Number of workers that executed each line.
    pub(super) workers: BTreeMap<usize, usize>,
    /// Lines that different workers began while one worker was at a line.
    pub(super) together: BTreeMap<usize, BTreeSet<usize>>,
}

/// Returns the sources with a probe before each statement among `lines`.
pub(super) fn probed(sources: &Sources, lines: &[Line]) -> Sources {
    let mut sources = sources.clone();
    for (path, bytes) in sources.iter_mut().filter(|(path, _)| path.ends_with(".rs")) {
        let text = String::from_utf8_lossy(bytes).into_owned();
        let (mut out, mut last) = (String::new(), '{');
        for (at, line) in text.lines().enumerate() {
            let own = lines.iter().position(|own| own.path == *path && own.at == at);
            if let Some(number) = own.filter(|_| "{};".contains(last) && is_statement(line)) {
                out += &format!(
                    "eprintln!(\"@viva {number} {{}}-{{:?}} {{}}\", std::process::id(), std::thread::current().id(), \
                     std::time::UNIX_EPOCH.elapsed().map_or(0, |time| time.as_nanos())); \
                     std::thread::sleep(std::time::Duration::from_nanos({PAUSE})); "
                );
            }
            out += &format!("{line}\n");
            let code = line.split("//").next().unwrap_or_default().trim();
            last = code.chars().last().unwrap_or(last);
        }
        *bytes = out.into_bytes();
    }
    sources
}

/// Whether a line that follows a brace or a semicolon begins a statement.
fn is_statement(line: &str) -> bool {
    let line = line.trim();
    let items = [
        "fn ", "pub", "use ", "struct ", "enum ", "impl", "mod ", "const ", "static ", "type ",
        "trait ",
    ];
    line.starts_with(|c: char| c.is_alphanumeric() || "_*(".contains(c))
        && !items.iter().any(|item| line.starts_with(item))
        && !line.contains("=>")
        && !line.ends_with(',')
}

impl Trace {
    /// Reads the output of a program's probes.
    pub(super) fn read(output: &str) -> Self {
        let event = |line: &'_ str| {
            let mut words = line.split_once("@viva ")?.1.split(' ');
            let (number, worker) = (words.next()?.parse().ok()?, words.next()?.to_owned());
            Some((words.next()?.parse().ok()?, number, worker))
        };
        let mut events: Vec<(u128, usize, String)> = output.lines().filter_map(event).collect();
        events.sort();
        let mut trace = Self::default();
        let mut workers: BTreeMap<usize, BTreeSet<&str>> = BTreeMap::new();
        for (index, (time, line, worker)) in events.iter().enumerate() {
            *trace.counts.entry(*line).or_default() += 1;
            workers.entry(*line).or_default().insert(worker);
            let rest = events[index + 1..].iter();
            for (_, other, by) in rest.take_while(|(later, ..)| *later < time + PAUSE) {
                if by != worker {
                    trace.together.entry(*line).or_default().insert(*other);
                    trace.together.entry(*other).or_default().insert(*line);
                }
            }
        }
        trace.workers = workers.into_iter().map(|(line, by)| (line, by.len())).collect();
        trace
    }

    /// Runs a variant of a probed program on a small scene.
    pub(super) fn of_run(
        sandbox: &Sandbox,
        folder: &std::path::Path,
        variant: &str,
        workers: usize,
    ) -> Result<Self> {
        let mut command = sandbox.program(folder, PROGRAM, None);
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
}

/// Number of particles and of steps of a traced run, and its time limit.
pub(super) const PARTICLES: usize = 60;
pub(super) const STEPS: usize = 3;
const LIMIT: Duration = Duration::from_secs(60);
