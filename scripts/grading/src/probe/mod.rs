//! Asking a submission and the solution the same, and comparing.

mod answers;
mod runs;

use std::fs::{self, Permissions};
use std::os::unix::fs::PermissionsExt;
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::time::{Duration, Instant};

use anyhow::{Context, Result, ensure};

use answers::{Answer, answers, compare, share};

use crate::sandbox::{Sandbox, is_launcher, patiently};
use lab_kit::harness::located_panic;
use lab_kit::process::{Finished, run as run_process};

/// What is said of a program that was ended by us or by the system.
const KILLED: &str = "it was ended: it needed more memory than it may have";

/// And of one that printed this number of bytes and gave no answer: printing is what took its time.
const MUCH: usize = 1 << 19;
const PRINTS: &str = "it prints too much: take out what prints for each particle or pair";

/// The name of the probe program in its folder.
pub(crate) const PROGRAM: &str = "probe";

/// The solution gets this many times the time that a submission may take: no mark hangs on it. A submission gets this
/// many times what the solution took, if that is more: the machine may be busy.
const PATIENCE: u32 = 10;

/// What the solution answers about a task.
pub(crate) struct Expected {
    answers: Vec<Answer>,
    /// How long a submission may take for the same.
    limit: Duration,
}

/// What the solution answers; it must.
pub(crate) fn reference(
    sandbox: &Sandbox,
    folder: &Path,
    task: &str,
    seed: u64,
) -> Result<Expected> {
    let (start, usual) = (Instant::now(), sandbox.limits.run);
    let (finished, written) = ask(sandbox, folder, task, seed, PATIENCE * usual)?;
    let limit = usual.max(PATIENCE * start.elapsed());
    let answers = answers(&written).context("the solution's probe is malformed")?;
    let ended = answers.last().is_some_and(|last| last.question == "end");
    ensure!(
        ended && answers.len() > 1,
        "the solution's probe of task {task} broke off: {}",
        finished.stderr
    );
    Ok(Expected { answers, limit })
}

/// What a submission said about a task.
pub(crate) struct Said {
    /// What is wrong with it; none if nothing is.
    pub(crate) wrong: Option<String>,
    /// The share of the questions that it answered rightly.
    pub(crate) share: f64,
    /// What it printed, as far as it is kept.
    pub(crate) printed: String,
}

/// What a submission says, beside the solution's answers.
pub(crate) fn said(
    sandbox: &Sandbox,
    folder: &Path,
    task: &str,
    seed: u64,
    Expected { answers: expected, limit }: &Expected,
) -> Result<Said> {
    let refused = |(finished, written): &(Finished, String)| {
        finished.status.is_some() && written.is_empty() && is_launcher(&finished.stderr)
    };
    let (finished, written) = patiently(|| ask(sandbox, folder, task, seed, *limit), refused)?;
    let printed = format!("{}{}", finished.stdout, finished.stderr);
    let Some(given) = answers(&written) else {
        return Ok(Said { wrong: Some("its answers are malformed".into()), share: 0.0, printed });
    };
    let difference = compare(expected, &given);
    let wrong = match difference {
        Some(what) if given.len() < expected.len() => Some(match finished.status {
            None if finished.stdout.len().max(finished.stderr.len()) >= MUCH => PRINTS.into(),
            None => {
                let question = &expected[given.len()].question;
                format!("no answer within {} s to: {question}", limit.as_secs())
            }
            Some(status) if status.signal() == Some(9) => KILLED.into(),
            Some(_) if is_launcher(&finished.stderr) => first_line(&finished.stderr),
            Some(_) => located_panic(&finished.stderr).map_or(what, |said| first_line(&said)),
        }),
        other => other,
    };
    Ok(Said { wrong, share: share(expected, &given), printed })
}

/// Asks about a task. The answers come in a file of their own, whatever the program prints. It could write
/// there as well, but only right answers count, whichever program writes them.
fn ask(
    sandbox: &Sandbox,
    folder: &Path,
    task: &str,
    seed: u64,
    limit: Duration,
) -> Result<(Finished, String)> {
    let scratch = sandbox.folder()?;
    let file = scratch.path().join("answers");
    fs::write(&file, "")?;
    // Programs run as nobody.
    fs::set_permissions(&file, Permissions::from_mode(0o666))?;
    let mut command = sandbox.program(folder, PROGRAM, Some(&file));
    command.args([task, &seed.to_string()]);
    let finished = run_process(&mut command, limit)?;
    Ok((finished, String::from_utf8_lossy(&fs::read(&file)?).into_owned()))
}

fn first_line(text: &str) -> String {
    text.lines().next().unwrap_or_default().chars().take(300).collect()
}
