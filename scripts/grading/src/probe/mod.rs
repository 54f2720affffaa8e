//! Asking a submission and the solution the same, and comparing.

mod answers;
mod runs;

use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::Command;
use std::time::Duration;

use anyhow::{Context, Result, ensure};

pub(crate) use answers::Answer;
use answers::{answers, compare};

use crate::sandbox::{Sandbox, is_launcher};
use lab_kit::process::run as run_process;

/// What is said of a program that was ended by us or by the system.
const KILLED: &str = "it was ended: it needed more memory than it may have";

/// A sandbox that did not start is tried again so often, after so long.
const RETRIES: usize = 3;
const PAUSE: Duration = Duration::from_secs(2);

/// The name of the probe program in its folder.
pub(crate) const PROGRAM: &str = "probe";

/// What the solution answers; it must.
pub(crate) fn reference(
    sandbox: &Sandbox,
    folder: &Path,
    task: &str,
    seed: u64,
) -> Result<Vec<Answer>> {
    let (mut command, nonce) = question(sandbox, folder, task, seed);
    let finished = run_process(&mut command, sandbox.limits().run)?;
    let answers = answers(&finished.stdout, &nonce).context("the solution's probe is malformed")?;
    let ended = answers.last().is_some_and(|last| last.question == "end");
    ensure!(
        ended && answers.len() > 1,
        "the solution's probe of task {task} broke off: {}",
        finished.stderr
    );
    Ok(answers)
}

/// What is wrong with a submission's answers; none if nothing is.
pub(crate) fn wrong(
    sandbox: &Sandbox,
    folder: &Path,
    task: &str,
    seed: u64,
    expected: &[Answer],
) -> Result<Option<String>> {
    let (mut command, nonce) = question(sandbox, folder, task, seed);
    let mut finished = run_process(&mut command, sandbox.limits().run)?;
    // A busy machine may refuse the sandbox itself a process: that is nobody's mistake.
    for _ in 0..RETRIES {
        if !(finished.stdout.is_empty() && is_launcher(&finished.stderr)) {
            break;
        }
        std::thread::sleep(PAUSE);
        finished = run_process(&mut command, sandbox.limits().run)?;
    }
    let Some(given) = answers(&finished.stdout, &nonce) else {
        return Ok(Some("its answers are malformed".into()));
    };
    let difference = compare(expected, &given);
    Ok(match difference {
        Some(what) if given.len() < expected.len() => Some(match finished.status {
            None => format!("no answer within {} s", sandbox.limits().run.as_secs()),
            Some(status) if status.signal() == Some(9) => KILLED.into(),
            Some(_) if is_launcher(&finished.stderr) => first_line(&finished.stderr),
            Some(_) => panic_of(&finished.stderr).unwrap_or(what),
        }),
        other => other,
    })
}

/// The probe that is asked about a task, and the mark of its answers.
fn question(sandbox: &Sandbox, folder: &Path, task: &str, seed: u64) -> (Command, String) {
    let nonce = nonce(seed, task);
    let mut command = sandbox.program(folder, PROGRAM);
    command.args([task, &seed.to_string(), &nonce]);
    (command, nonce)
}

fn first_line(text: &str) -> String {
    text.lines().next().unwrap_or_default().chars().take(300).collect()
}

fn panic_of(stderr: &str) -> Option<String> {
    let mut lines = stderr.lines().skip_while(|line| !line.contains(" panicked at "));
    lines.next()?;
    Some(lines.next()?.chars().take(300).collect())
}

/// Marks our lines among whatever a program prints. It is no secret to the program: only right
/// answers count, whoever writes them.
fn nonce(seed: u64, task: &str) -> String {
    use hmac_sha256::Hash;
    let digest = Hash::hash(format!("{seed} {task} {}", std::process::id()).as_bytes());
    digest.iter().take(8).map(|byte| format!("{byte:02x}")).collect()
}
