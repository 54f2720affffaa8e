//! Asks a submission the questions of its lab, and has the judging program judge the answers.
//!
//! The program that runs a submission sends answers and contains no right answer. The grader's own
//! program, which is built from the solution, judges them.

mod answered;
mod question_list;

use std::collections::BTreeSet;
use std::os::unix::process::ExitStatusExt;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use anyhow::{Result, ensure};

use crate::sandbox::Sandbox;
use crate::sandbox::faults::{believed, could_end, machine_works, named};
use answered::{Answered, Judge, Judged};
use lab_kit::harness::located_panic;
use lab_kit::machine::on_all_cores;
use lab_kit::process::Finished;
use lab_kit::{Kit, Lab};
use question_list::Question;

/// Message for a program that was killed, by the grader or by the system.
const KILLED: &str = "it was ended, because it needed more memory than a submission is allowed";

/// Number of printed bytes above which the grader attributes a missing answer to the printing.
const MUCH: usize = 1 << 19;
/// Message about a program that gave no answer because it printed too many bytes.
const PRINTS: &str = "it prints too much: remove the output for each particle or pair";

/// Message for a task if each of its questions needs another task that is wrong.
const UNASKED: &str = "not asked, because each of its questions needs a task that is wrong";

/// Name of the answering program.
pub(crate) const ANSWER: &str = "answer";
/// Name of the judging program.
pub(crate) const JUDGE: &str = "judge";

/// Factor for time limits.
///
/// The limits of the solution and of the judge are a submission's limit times this factor, because
/// no mark depends on their times.
///
/// A submission's limit is at least the solution's time times this factor, because the machine may
/// be busy.
const PATIENCE: u32 = 10;

/// Questions of a lab, the solution's programs, and a time limit for each question.
pub(crate) struct Questions {
    judge: Judge,
    solution: PathBuf,
    all: Vec<Asked>,
}

struct Asked {
    question: Question,
    /// Number of answers that the question asks for.
    answers: usize,
    /// Time limit of a submission for all these answers.
    limit: Duration,
}

/// A submission's result in a task.
#[derive(Default)]
pub(crate) struct TaskResult {
    /// First mistake, in the order of the questions; `None` if there is no mistake.
    pub(crate) wrong: Option<String>,
    /// Share of the answers that are right, from 0 to 1.
    pub(crate) share: f64,
    /// Names of the questions with a wrong answer.
    pub(crate) failed: Vec<String>,
    /// Output of the program, cut to a maximal length.
    pub(crate) printed: String,
}

impl Questions {
    /// Asks the solution in `folder` all questions of a lab, which it must answer correctly.
    pub(crate) fn of(
        kit: &Kit,
        lab: Lab,
        sandbox: &Sandbox,
        folder: &Path,
        seed: u64,
    ) -> Result<Self> {
        // The judge is the grader's own program, so a generous limit is safe.
        let judge = Judge::new(kit, lab, folder, PATIENCE * sandbox.limits.run);
        let all = question_list::read(&judge.program)?;
        let mut questions = Self { judge, solution: folder.to_owned(), all: Vec::new() };
        let asked = on_all_cores(&all, |question| {
            let start = Instant::now();
            let judged = questions.ask_solution(sandbox, question, seed)?;
            let limit = sandbox.limits.run.max(PATIENCE * start.elapsed());
            Ok(Asked { question: question.clone(), answers: judged.asked, limit })
        });
        questions.all = asked.into_iter().collect::<Result<_>>()?;
        Ok(questions)
    }

    /// Asks the solution a question.
    ///
    /// # Errors
    /// If an answer is wrong.
    fn ask_solution(&self, sandbox: &Sandbox, question: &Question, seed: u64) -> Result<Judged> {
        let limit = PATIENCE * sandbox.limits.run;
        let Answered { finished, judged } =
            self.judge.ask(sandbox, &self.solution, question, seed, limit)?;
        let test = &question.test;
        ensure!(!judged.broke_off, "the solution fails in {test}: {}", named(&finished.stderr));
        ensure!(judged.wrong.is_empty(), "the solution is wrong in {test}: {}", judged.wrong);
        Ok(judged)
    }

    /// Asks the submission in `folder` about each of these tasks.
    ///
    /// A question is skipped if it needs a different task whose answers are wrong. So a mistake
    /// costs the points of one task only.
    pub(crate) fn ask<'a>(
        &self,
        sandbox: &Sandbox,
        folder: &Path,
        tasks: impl Iterator<Item = &'a str>,
        seed: u64,
    ) -> Result<Vec<TaskResult>> {
        let tasks: Vec<&str> = tasks.collect();
        let mut marks: Vec<Marks> = tasks.iter().map(|_| Marks::default()).collect();
        let mut wrong = BTreeSet::new();
        for asked in &self.all {
            let Question { task, after, .. } = &asked.question;
            let Some(at) = tasks.iter().position(|other| other == task) else { continue };
            if after.iter().any(|needed| wrong.contains(needed)) {
                continue;
            }
            if marks[at].timed_out {
                marks[at].asked += asked.answers;
                continue;
            }
            let answered = self.ask_one(sandbox, folder, asked, seed)?;
            if !answered.judged.wrong.is_empty() {
                marks[at].result.failed.push(asked.question.test.clone());
                wrong.insert(task.clone());
            }
            marks[at].add(answered, asked.limit);
        }
        Ok(marks.into_iter().map(Marks::end).collect())
    }

    /// Asks a submission a question.
    ///
    /// An answer counts as wrong only if the solution answers the same question with the same seed
    /// correctly.
    fn ask_one(
        &self,
        sandbox: &Sandbox,
        folder: &Path,
        Asked { question, limit, .. }: &Asked,
        seed: u64,
    ) -> Result<Answered> {
        let answered = believed(
            || self.judge.ask(sandbox, folder, question, seed, *limit),
            |it| it.judged.broke_off && could_end(&it.finished),
            || self.ask_solution(sandbox, question, seed).map(drop),
        )?;
        if !answered.judged.wrong.is_empty() {
            machine_works(|| self.ask_solution(sandbox, question, seed).map(drop))?;
        }
        Ok(answered)
    }
}

/// A submission's intermediate result in a task.
#[derive(Default)]
struct Marks {
    result: TaskResult,
    asked: usize,
    right: usize,
    /// Whether a question was not answered in time. If so, further questions are skipped.
    timed_out: bool,
}

impl Marks {
    fn add(&mut self, Answered { finished, judged }: Answered, limit: Duration) {
        self.asked += judged.asked;
        self.right += judged.right;
        self.timed_out = finished.status.is_none();
        self.result.printed += &format!("{}{}", finished.stdout, finished.stderr);
        if !judged.wrong.is_empty() && self.result.wrong.is_none() {
            self.result.wrong = Some(words(&judged, &finished, limit));
        }
    }

    fn end(self) -> TaskResult {
        if self.asked == 0 {
            return TaskResult { wrong: Some(UNASKED.into()), ..self.result };
        }
        TaskResult { share: self.right as f64 / self.asked as f64, ..self.result }
    }
}

/// Explains why answers are wrong. If the program crashed, the explanation is the program's own
/// error message.
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
        Some(_) => match located_panic(&finished.stderr) {
            Some(message) => message.lines().next().unwrap_or_default().chars().take(300).collect(),
            None => wrong,
        },
    }
}
