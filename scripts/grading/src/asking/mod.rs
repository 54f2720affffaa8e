//! Asking a submission the questions of its lab, and having its answers judged.
//!
//! The program that runs a submission writes answers to a file, and nothing in it knows what is right.
//! The grader's own program, which is built from the solution, judges the file.

mod judged;
mod table;

use std::collections::BTreeSet;
use std::fs::{self, Permissions};
use std::os::unix::fs::PermissionsExt;
use std::os::unix::process::ExitStatusExt;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use anyhow::{Result, ensure};
use tempfile::TempDir;

use crate::sandbox::{Sandbox, is_launcher, patiently};
pub(crate) use judged::Judge;
use judged::Judged;
use lab_kit::harness::located_panic;
use lab_kit::process::{Finished, run as run_process};
use table::Question;

/// What is said of a program that was ended by us or by the system.
const KILLED: &str = "it was ended: it needed more memory than it may have";

/// And of one that printed this number of bytes and gave no answer: printing is what took its time.
const MUCH: usize = 1 << 19;
const PRINTS: &str = "it prints too much: take out what prints for each particle or pair";

/// What is said of a task of which no question could be asked: nothing is known to be right.
const UNASKED: &str = "not asked, because each of its questions needs a task that is wrong";

/// The name of the program that answers, and of the one that judges.
pub(crate) const ANSWER: &str = "answer";
pub(crate) const JUDGE: &str = "judge";

/// The solution gets this many times the time that a submission may take: no mark hangs on it. A submission gets this
/// many times what the solution took, if that is more: the machine may be busy.
const PATIENCE: u32 = 10;

/// The questions of a lab, and how long the solution took for each.
pub(crate) struct Questions {
    judge: Judge,
    all: Vec<Asked>,
}

struct Asked {
    question: Question,
    /// How many answers it asks for.
    answers: usize,
    /// How long a submission may take for them.
    limit: Duration,
}

/// What a submission said about a task.
#[derive(Default)]
pub(crate) struct Said {
    /// What is wrong with it, in the order of the questions; none if nothing is.
    pub(crate) wrong: Option<String>,
    /// The share of the answers that are right.
    pub(crate) share: f64,
    /// What it printed, as far as it is kept.
    pub(crate) printed: String,
}

impl Questions {
    /// Asks the solution in `folder`; all that it answers must be right.
    pub(crate) fn of(sandbox: &Sandbox, folder: &Path, judge: Judge, seed: u64) -> Result<Self> {
        let usual = sandbox.limits.run;
        let mut all = Vec::new();
        for question in table::read(&judge.program)? {
            let start = Instant::now();
            let answers = Answers::of(sandbox, folder, &question, seed, PATIENCE * usual)?;
            let limit = usual.max(PATIENCE * start.elapsed());
            let judged = judge.judge(&question, seed, &answers.file())?;
            ensure!(
                judged.wrong.is_empty() && !judged.broke_off,
                "the solution is wrong in {}: {}\n{}",
                question.test,
                judged.wrong,
                answers.finished.stderr
            );
            all.push(Asked { question, answers: judged.asked, limit });
        }
        Ok(Self { judge, all })
    }

    /// What a submission in `folder` says about each of these tasks. A question that needs another task is
    /// left out if that one is wrong, so that a mistake costs one task.
    pub(crate) fn ask<'a>(
        &self,
        sandbox: &Sandbox,
        folder: &Path,
        tasks: impl Iterator<Item = &'a str>,
        seed: u64,
    ) -> Result<Vec<Said>> {
        let tasks: Vec<&str> = tasks.collect();
        let mut said: Vec<Marks> = tasks.iter().map(|_| Marks::default()).collect();
        let mut wrong = BTreeSet::new();
        for asked in &self.all {
            let Question { task, after, .. } = &asked.question;
            let Some(at) = tasks.iter().position(|other| other == task) else { continue };
            if after.iter().any(|needed| wrong.contains(needed)) {
                continue;
            }
            said[at].add(&self.judge, asked, sandbox, folder, seed)?;
            if said[at].said.wrong.is_some() {
                wrong.insert(task.clone());
            }
        }
        Ok(said.into_iter().map(Marks::end).collect())
    }
}

/// What a submission has said about a task so far.
#[derive(Default)]
struct Marks {
    said: Said,
    asked: usize,
    right: usize,
    /// Whether a question was not answered in time: further ones would not be, either.
    hangs: bool,
}

impl Marks {
    fn add(
        &mut self,
        judge: &Judge,
        asked: &Asked,
        sandbox: &Sandbox,
        folder: &Path,
        seed: u64,
    ) -> Result<()> {
        self.asked += asked.answers;
        if self.hangs {
            return Ok(());
        }
        let answers = Answers::of(sandbox, folder, &asked.question, seed, asked.limit)?;
        let judged = judge.judge(&asked.question, seed, &answers.file())?;
        self.right += judged.right.min(asked.answers);
        self.hangs = answers.finished.status.is_none();
        let Finished { stdout, stderr, .. } = &answers.finished;
        self.said.printed += &format!("{stdout}{stderr}");
        if !judged.wrong.is_empty() && self.said.wrong.is_none() {
            self.said.wrong = Some(words(&judged, &answers.finished, asked.limit));
        }
        Ok(())
    }

    fn end(self) -> Said {
        if self.asked == 0 {
            return Said { wrong: Some(UNASKED.into()), ..self.said };
        }
        Said { share: self.right as f64 / self.asked as f64, ..self.said }
    }
}

/// Why answers are wrong. A program that broke off says why itself.
fn words(judged: &Judged, finished: &Finished, limit: Duration) -> String {
    let wrong = judged.wrong.replacen('\n', ": ", 1);
    if !judged.broke_off {
        return wrong;
    }
    let question = judged.wrong.lines().next().unwrap_or_default();
    match finished.status {
        None if finished.stdout.len().max(finished.stderr.len()) >= MUCH => PRINTS.into(),
        None => format!("no answer within {} s to: {question}", limit.as_secs()),
        Some(status) if status.signal() == Some(9) => KILLED.into(),
        Some(_) if is_launcher(&finished.stderr) => first_line(&finished.stderr),
        Some(_) => located_panic(&finished.stderr).map_or(wrong, |said| first_line(&said)),
    }
}

/// What a program did to answer a question.
struct Answers {
    finished: Finished,
    folder: TempDir,
}

impl Answers {
    /// Has a program answer. The answers come in a file of their own, whatever the program prints. It could
    /// write anything there, but only right answers count, whoever writes them.
    fn of(
        sandbox: &Sandbox,
        folder: &Path,
        question: &Question,
        seed: u64,
        limit: Duration,
    ) -> Result<Self> {
        let once = || Self::once(sandbox, folder, question, seed, limit);
        let refused = |answers: &Self| {
            let empty = fs::metadata(answers.file()).is_ok_and(|file| file.len() == 0);
            answers.finished.status.is_some() && empty && is_launcher(&answers.finished.stderr)
        };
        patiently(once, refused)
    }

    fn once(
        sandbox: &Sandbox,
        folder: &Path,
        question: &Question,
        seed: u64,
        limit: Duration,
    ) -> Result<Self> {
        let written = sandbox.folder()?;
        let file = written.path().join("answers");
        fs::write(&file, "")?;
        // Programs run as nobody.
        fs::set_permissions(&file, Permissions::from_mode(0o666))?;
        let mut command = sandbox.program(folder, ANSWER, Some(&file));
        command.args([&question.test, &seed.to_string()]);
        Ok(Self { finished: run_process(&mut command, limit)?, folder: written })
    }

    fn file(&self) -> PathBuf {
        self.folder.path().join("answers")
    }
}

fn first_line(text: &str) -> String {
    text.lines().next().unwrap_or_default().chars().take(300).collect()
}
