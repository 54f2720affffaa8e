//! Runs a submission's program on one question, and has its answers judged.

use std::fs::File;
use std::io::{self, Read};
use std::net::Shutdown;
use std::os::fd::OwnedFd;
use std::os::unix::net::UnixStream;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::thread;
use std::time::Duration;

use anyhow::{Context, Result, ensure};

use super::question_list::Question;
use super::{ANSWER, JUDGE};
use crate::sandbox::Sandbox;
use lab_kit::process::{Finished, run, run_with};
use lab_kit::{Kit, Lab};

/// Greatest length of all answers to a question, in bytes.
const MOST: u64 = 1 << 28;

/// A program's end, and the verdict on its answers to a question.
pub(super) struct Answered {
    pub(super) finished: Finished,
    pub(super) judged: Judged,
}

/// Verdict on the answers to a question.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Judged {
    /// Number of requested answers, and number of right answers.
    pub(super) asked: usize,
    pub(super) right: usize,
    /// Whether the answers end too early.
    pub(super) broke_off: bool,
    /// First wrong answer: its question and the mistake. Empty if all answers are right.
    pub(super) wrong: String,
}

/// The judging program, built from the solution.
pub(super) struct Judge {
    pub(super) program: PathBuf,
    /// Common prefix of the paths of the lab's snapshots.
    snapshots: PathBuf,
    limit: Duration,
}

impl Judge {
    /// Takes the judging program of a lab from the `folder` of the solution's programs.
    pub(super) fn new(kit: &Kit, lab: Lab, folder: &Path, limit: Duration) -> Self {
        let snapshots = kit.path(format!("tests/snapshots/lab{lab}__"));
        Self { program: folder.join(JUDGE), snapshots, limit }
    }

    /// Runs the answering program in `folder` on a question, and judges its answers outside the
    /// sandbox.
    pub(super) fn ask(
        &self,
        sandbox: &Sandbox,
        folder: &Path,
        question: &Question,
        seed: u64,
        limit: Duration,
    ) -> Result<Answered> {
        let kept = sandbox.folder()?;
        let answers = kept.path().join("answers");
        let mut command = sandbox.program(folder, ANSWER);
        command.args([&question.test, &seed.to_string()]);
        let finished = answer(&mut command, limit, File::create(&answers)?)?;
        let judged = self.judge(question, seed, &answers)?;
        Ok(Answered { finished, judged })
    }

    /// Judges the answers in a file.
    ///
    /// # Errors
    /// If the judging program fails. The submission is never the cause.
    fn judge(&self, question: &Question, seed: u64, answers: &Path) -> Result<Judged> {
        let mut command = Command::new(&self.program);
        command.args([&question.test, &seed.to_string()]).args([answers, &self.snapshots]);
        let done = run(&mut command, self.limit)?;
        let succeeded = done.status.is_some_and(|status| status.success());
        let test = &question.test;
        ensure!(succeeded, "the grader's own program failed at {test}: {}", done.stderr.trim());
        parse(&done.stdout).with_context(|| format!("no verdict of {test}: {}", done.stdout))
    }
}

/// Runs a program and copies its answers into `file`.
///
/// The program writes its answers to a socket, which is its standard input when it starts. A socket
/// cannot be opened by a path, so the code of a submission cannot write to it.
fn answer(command: &mut Command, limit: Duration, mut file: File) -> Result<Finished> {
    let (ours, theirs) = UnixStream::pair()?;
    let (finished, copied) = thread::scope(|scope| {
        let copying = scope.spawn(|| {
            let copied = io::copy(&mut (&ours).take(MOST), &mut file);
            close(&ours);
            copied
        });
        let finished = run_with(command, OwnedFd::from(theirs).into(), limit);
        // A remaining process of the program may keep the other end open. The answers that are
        // already in the socket can still be read.
        close(&ours);
        (finished, copying.join().expect("copying does not panic"))
    });
    copied.context("cannot keep the answers")?;
    Ok(finished?)
}

fn close(socket: &UnixStream) {
    // If the other end is closed already, an error here does no harm.
    let _ = socket.shutdown(Shutdown::Both);
}

/// Parses the judge's output: a line with three numbers, then the text about the first wrong
/// answer.
fn parse(text: &str) -> Option<Judged> {
    let (first, wrong) = text.split_once('\n')?;
    let mut numbers = first.split(' ').map(|number| number.parse().ok());
    let asked = numbers.next()??;
    let right = numbers.next()??;
    let broke_off = numbers.next()??;
    Some(Judged { asked, right, broke_off: broke_off == 1, wrong: wrong.trim_end().into() })
}

#[cfg(test)]
mod tests {
    use super::{Judged, parse};

    #[test]
    fn a_verdict_is_read() {
        let wrong = "two pairs: navg\n     found: [3]\n  expected: [4]";
        let judged = Judged { asked: 5, right: 4, broke_off: true, wrong: wrong.into() };
        assert_eq!(parse(&format!("5 4 1\n{wrong}")), Some(judged));
        assert_eq!(parse("5 5 0\n"), Some(Judged { asked: 5, right: 5, ..Judged::default() }));
        assert_eq!(parse("5 5\n"), None);
        assert_eq!(parse(""), None);
    }
}
