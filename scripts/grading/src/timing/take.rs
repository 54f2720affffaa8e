//! One run of a timed program.

use std::hash::{BuildHasher, RandomState};
use std::io::{BufRead, BufReader, Read, Write};
use std::path::Path;
use std::process::{ChildStdout, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread;
use std::time::{Duration, Instant};

use anyhow::{Context, Result, ensure};

use super::processors::{confined, peak, seconds};
use crate::record::{Outcome, Run, Whose};
use crate::sandbox::Sandbox;
use crate::sandbox::faults::{believed, is_sign};
use lab_kit::process::{ends, panic_in, start as start_process};
use oracle::contest::Kind;

/// Name of the timed program in its folder.
pub(crate) const PROGRAM: &str = "timed";

/// Time limit for starting a program and making its scene. Neither is timed.
const START: Duration = Duration::from_secs(20);

/// Time limit for reading the error messages of a program that crashed.
const REST: Duration = Duration::from_secs(5);

/// Maximal number of bytes that a program may print.
const MOST: u64 = 1 << 28;

/// A request to the timed program.
pub(crate) struct Order<'a> {
    /// Whether to run the serial program of the earlier labs.
    pub(crate) serial: bool,
    pub(crate) variant: &'a str,
    pub(crate) workers: usize,
    pub(crate) n: usize,
    pub(crate) seed: u32,
    pub(crate) steps: u64,
    pub(crate) kind: Kind,
}

impl<'a> Order<'a> {
    /// Requests a run on the official scene of this seed.
    pub(crate) fn of(run: &'a Run, seed: u32) -> Self {
        let Run { variant, workers, n, steps, .. } = run;
        let serial = run.whose == Whose::Serial;
        let kind = Kind::Official;
        Self { serial, variant, workers: *workers, n: *n, seed, steps: *steps, kind }
    }
}

/// Result of a run.
pub(crate) struct Taken {
    /// Seconds from the line that lets the program begin to its last particle, on the grader's
    /// clock.
    pub(crate) seconds: f64,
    /// Processor time in these seconds; `None` if the system does not report it.
    pub(crate) processors: Option<f64>,
    /// Largest memory of the processes in bytes; `None` if the system does not report it.
    pub(crate) memory: Option<u64>,
    /// x, y, vx, vy of each particle.
    pub(crate) state: Vec<f64>,
}

/// Reason why no result came back: the time was up, the program ended, or its output was malformed.
pub(crate) type Trouble = (Outcome, String);

/// Message for a program that ended without an error message.
const SILENT: &str = "it broke off without a result";

/// Whether a fault of the machine could have ended a program.
pub(crate) fn is_doubtful(taken: &Result<Taken, Trouble>) -> bool {
    taken
        .as_ref()
        .is_err_and(|(outcome, why)| *outcome == Outcome::Wrong && (why == SILENT || is_sign(why)))
}

/// A message from the timed program.
enum Reply {
    Ready,
    State(Instant, Vec<f64>),
    /// The program printed more than [`MOST`] bytes.
    TooMuch,
}

/// Runs a program in `folder` on `processors` processors, in a new process.
///
/// The process has ended when this function returns, because otherwise it would disturb the next
/// run.
pub(crate) fn take(
    sandbox: &Sandbox,
    folder: &Path,
    order: &Order<'_>,
    processors: usize,
    limit: Duration,
) -> Result<Result<Taken, Trouble>> {
    let nonce = nonce();
    let mut command = sandbox.program(folder, PROGRAM);
    command.args([&nonce, &order.workers.to_string()]);
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut process = confined(processors, || start_process(&mut command))
        .context("a timed program does not start")?;
    let child = &mut process.child;
    let stdin = child.stdin.take();
    let stdout = child.stdout.take();
    let (mut stdin, stdout) = stdin.zip(stdout).context("it has no pipes")?;
    let complaints = ends(child.stderr.take());
    let root = child.id();
    let (send, receive) = channel();
    let most = 32 * order.n;
    thread::spawn(move || listen(stdout, &nonce, most, &send));
    let Order { variant, workers, n, seed, steps, .. } = order;
    let whose = if order.serial { "serial" } else { "lab" };
    let kind = order.kind.name();
    // If the program has closed its stdin, the missing answer is reported later.
    let _ = writeln!(stdin, "{whose} {variant} {workers} {n} {seed} {steps} {kind}");

    match receive.recv_timeout(START) {
        Ok(Reply::Ready) => {}
        Ok(_) => return Ok(wrong("it talks before it is asked")),
        Err(error) => return Ok(Err(ended(error, START, &complaints))),
    }
    let before = seconds(root);
    let start = Instant::now();
    let _ = writeln!(stdin, "begin");
    let (end, state) = match receive.recv_timeout(limit) {
        Ok(Reply::State(end, state)) => (end, state),
        Ok(Reply::TooMuch) => {
            return Ok(wrong(
                "it prints too much while it is timed: remove the output in each step",
            ));
        }
        Ok(_) => return Ok(wrong("it talks nonsense")),
        Err(error) => return Ok(Err(ended(error, limit, &complaints))),
    };
    let after = seconds(root);
    Ok(Ok(Taken {
        seconds: end.duration_since(start).as_secs_f64(),
        processors: before.zip(after).map(|(before, after)| (after - before).max(0.0)),
        memory: peak(root),
        state,
    }))
}

/// Two folders of programs that are compared, the submission's and the solution's, and the sandbox
/// that runs them.
#[derive(Clone, Copy)]
pub(crate) struct Compared<'a> {
    pub(crate) sandbox: &'a Sandbox,
    /// Folder of the submission's programs.
    pub(crate) own: &'a Path,
    /// Folder of the solution's programs, and of the serial program.
    pub(crate) solution: &'a Path,
}

impl Compared<'_> {
    /// Runs the submission's program if `is_own`, and the solution's otherwise, as [`take`] does.
    /// Repeats a run that a fault of the machine may have ended.
    pub(crate) fn take(
        &self,
        is_own: bool,
        order: &Order<'_>,
        processors: usize,
        limit: Duration,
    ) -> Result<Result<Taken, Trouble>> {
        let folder = if is_own { self.own } else { self.solution };
        believed(
            || take(self.sandbox, folder, order, processors, limit),
            is_doubtful,
            || self.sandbox.works(),
        )
    }
}

/// Returns the trouble of a program that breaks the rules of a timed run.
fn wrong(why: &str) -> Result<Taken, Trouble> {
    Err((Outcome::Wrong, why.into()))
}

/// Explains why a run has no result: the time was up, or the program crashed with an error message.
fn ended(error: RecvTimeoutError, limit: Duration, complaints: &Receiver<String>) -> Trouble {
    if error == RecvTimeoutError::Timeout {
        return (Outcome::TooSlow, format!("no result within {:.0} s", limit.as_secs_f64()));
    }
    let complaint = complaints.recv_timeout(REST).unwrap_or_default();
    let first = complaint.lines().find(|line| !line.trim().is_empty());
    let line = panic_in(&complaint).or(first).unwrap_or(SILENT);
    (Outcome::Wrong, line.chars().take(300).collect())
}

/// Returns a random mark for the program's messages to the grader.
///
/// The mark reveals nothing about the scene.
fn nonce() -> String {
    format!("{:016x}", RandomState::new().hash_one(()))
}

/// Forwards the program's messages to the grader and ignores its other output.
fn listen(stdout: ChildStdout, nonce: &str, most: usize, send: &Sender<Reply>) -> Result<()> {
    let mut reader = BufReader::with_capacity(1 << 18, stdout.take(MOST));
    let mark = format!("@{nonce} ");
    let mut line = Vec::new();
    loop {
        line.clear();
        if reader.read_until(b'\n', &mut line)? == 0 {
            if reader.get_ref().limit() == 0 {
                let _ = send.send(Reply::TooMuch);
            }
            return Ok(());
        }
        let text = String::from_utf8_lossy(&line);
        let Some(text) = text.trim_end().strip_prefix(&mark) else { continue };
        let message = match text.split_once(' ').unwrap_or((text, "")) {
            ("ready", _) => Reply::Ready,
            ("state", length) => {
                let length: usize = length.parse()?;
                ensure!(length <= most, "it sends more than there are particles");
                let mut bytes = vec![0; length];
                reader.read_exact(&mut bytes)?;
                let end = Instant::now();
                let (numbers, _) = bytes.as_chunks();
                Reply::State(
                    end,
                    numbers.iter().map(|number| f64::from_le_bytes(*number)).collect(),
                )
            }
            _ => continue,
        };
        if send.send(message).is_err() {
            return Ok(());
        }
    }
}
