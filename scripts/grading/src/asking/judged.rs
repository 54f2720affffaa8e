//! Runs the grader's own program, which judges the answers that a submission's program wrote.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use anyhow::{Context, Result, ensure};

use super::question_list::Question;
use lab_kit::process::run;
use lab_kit::{Kit, Lab};

/// Verdict on the answers to a question.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Judged {
    /// Number of requested answers, and number of right answers.
    pub(crate) asked: usize,
    pub(crate) right: usize,
    /// Whether the answers end too early.
    pub(crate) broke_off: bool,
    /// First wrong answer: its question and the mistake. Empty if all answers are right.
    pub(crate) wrong: String,
}

/// The judging program, built from the solution.
pub(crate) struct Judge {
    pub(super) program: PathBuf,
    /// Common prefix of the paths of the lab's snapshots.
    snapshots: PathBuf,
    limit: Duration,
}

impl Judge {
    pub(crate) fn new(kit: &Kit, lab: Lab, program: PathBuf, limit: Duration) -> Self {
        Self { program, snapshots: kit.path(format!("tests/snapshots/lab{lab}__")), limit }
    }

    /// Judges the answers in a file.
    ///
    /// # Errors
    /// If the judging program fails. The submission is never the cause.
    pub(crate) fn judge(&self, question: &Question, seed: u64, answers: &Path) -> Result<Judged> {
        let mut command = Command::new(&self.program);
        command.args([&question.test, &seed.to_string()]).args([answers, &self.snapshots]);
        let done = run(&mut command, self.limit)?;
        let succeeded = done.status.is_some_and(|status| status.success());
        let test = &question.test;
        ensure!(succeeded, "the grader's own program failed at {test}: {}", done.stderr.trim());
        parse(&done.stdout).with_context(|| format!("no verdict of {test}: {}", done.stdout))
    }
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
