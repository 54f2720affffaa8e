//! `cargo lab viva`: writes a sheet of oral questions about each student's own program.
//!
//! Some questions show the program with one line changed ([`changes`]). Others ask how its lines
//! run ([`trace`]). Every key comes from a run of the changed program on the lab's tests, or from a
//! run of the program with probes.

mod changes;
mod sheet;
mod trace;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

use anyhow::{Result, anyhow, ensure};
use clap::Args;

use self::changes::{Line, changes, own_lines};
use self::sheet::Sheet;
use self::trace::{PARTICLES, STEPS, Trace, probe};
use crate::asking::{ANSWER, Questions, TaskResult};
use crate::build::Tree;
use crate::sandbox::{Limits, Sandbox};
use crate::submission;
use crate::submission::names::named;
use crate::timing::PROGRAM;
use lab_kit::escape::line;
use lab_kit::files::write_file;
use lab_kit::process::kill_all_on_interrupt;
use lab_kit::sources::Sources;
use lab_kit::{Facts, Given, Kit, Lab, Workers, rubric};
use oracle::Random;

/// Number of questions on a sheet.
const QUESTIONS: usize = 5;

/// Maximal number of changed programs that are built for a sheet. Some do not compile, and some
/// pass all tests.
const TRIES: usize = 16;

/// Time limit of a question.
const RUN: Duration = Duration::from_secs(10);

/// Write oral questions about each student's own program (for instructors)
///
/// Each sheet has five questions and a key. Some questions change a line of the student's program, and the key lists
/// the tests that fail. Further questions are about how often a line runs, and about lines that run at the same time.
/// Programs run in the sandbox.
#[derive(Args)]
pub(crate) struct Options {
    /// Submissions, or folders of them
    #[arg(required = true, value_name = "PATH")]
    paths: Vec<PathBuf>,
    /// The lab
    #[arg(long, value_name = "N")]
    lab: Lab,
    /// Draws the questions; the same seed gives the same questions
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// The folder of sheets; target/lab/viva/labN if not given
    #[arg(long, value_name = "DIR")]
    into: Option<PathBuf>,
}

/// Writes the sheets.
pub(crate) fn run(kit: &Kit, options: &Options) -> Result<ExitCode> {
    let lab = options.lab;
    let facts = rubric::read(kit, lab)?;
    let limits = Limits { run: RUN, build: 60 * RUN, loopback: facts.workers == Workers::Ranks };
    let sandbox = Sandbox::find(kit, false, limits)?;
    let into = options.into.clone();
    let into = into.unwrap_or_else(|| kit.memory().join(format!("viva/lab{lab}")));
    let submissions = submission::list_all(kit, &options.paths)?;
    kill_all_on_interrupt();
    eprintln!("Building the solution");
    let tree = Tree::lay(kit, lab, &sandbox)?;
    let solution = tree.reference(kit, &sandbox)?;
    let questions = Questions::of(kit, lab, &sandbox, solution.path(), options.seed)?;
    let given = Given::of(kit, lab)?;
    let examiner = Examiner { kit, lab, facts, sandbox, tree, questions, given };
    let mut all = true;
    for (name, path) in named(submissions) {
        let seed = name
            .bytes()
            .fold(options.seed, |seed, byte| Random::new(seed ^ u64::from(byte)).bits());
        match examiner.sheet(&path, seed) {
            Ok(sheet) => {
                let file = into.join(format!("{name}.md"));
                write_file(&file, sheet.page(lab, &name, options.seed))?;
                println!("{}", file.display());
            }
            Err(error) => {
                eprintln!("no sheet for {}: {}", line(&name), line(&format!("{error:#}")));
                all = false;
            }
        }
    }
    Ok(if all { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Programs and facts for the sheets of a lab.
struct Examiner<'a> {
    kit: &'a Kit,
    lab: Lab,
    facts: Facts,
    sandbox: Sandbox,
    tree: Tree,
    questions: Questions,
    given: Given,
}

impl Examiner<'_> {
    /// Returns the sheet of the submission at `path`.
    fn sheet(&self, path: &Path, seed: u64) -> Result<Sheet> {
        let sources = submission::buildable(self.kit, self.lab, &self.given, path)?;
        let tasks: Vec<&str> = self.facts.tasks.keys().map(String::as_str).collect();
        let own = self.failures(&sources, &tasks, seed)?;
        let own = own.map_err(|why| anyhow!("it does not compile: {why}"))?;
        let is_wrong = |task: &str| own.iter().any(|(wrong, _)| wrong == task);
        let mut lines = own_lines(self.kit, self.lab, &sources)?;
        lines.retain(|line| line.task.is_none_or(|task| !is_wrong(&task.to_string())));
        ensure!(!lines.is_empty(), "no task of it is right");
        let mut random = Random::new(seed);
        let mut sheet = Sheet::default();
        self.ask_about_runs(&sources, &lines, &mut random, &mut sheet)?;
        let mut changes = changes(self.kit, self.lab, &lines)?;
        // Known mistakes come first, because their keys explain them.
        changes.sort_by_cached_key(|change| (change.story.is_none(), random.bits()));
        let mut asked = BTreeSet::new();
        let mut tries = 0;
        for change in changes {
            if sheet.questions.len() == QUESTIONS || tries == TRIES {
                break;
            }
            if asked.contains(&change.line.task) {
                continue;
            }
            tries += 1;
            let mut changed = sources.clone();
            change.apply(&mut changed);
            // The tests of a line's task are enough to reveal a change. Running the tests of all
            // tasks would take longer.
            let task = change.line.task.map(|task| task.to_string());
            let tasks = task.as_ref().map_or(tasks.clone(), |task| vec![task]);
            let Ok(failures) = self.failures(&changed, &tasks, seed)? else { continue };
            let lost = failures.iter().filter(|(task, _)| !is_wrong(task));
            let mut key: String = lost.map(|(_, result)| failed(result)).collect();
            if !key.is_empty() {
                key.extend(change.story.map(|story| format!("A known mistake: {story}")));
                asked.extend(change.line.task.map(Some));
                let of = task.map_or(String::new(), |task| format!(" of task {task}"));
                let question = format!(
                    "Here is your program with one line changed. Which test{of} fails, what does a user see, and why?"
                );
                sheet.ask(&sources, &change.line, &change.new, &question, key);
            }
        }
        Ok(sheet)
    }

    /// Asks a program about these tasks. Returns the tasks that are wrong, or the compiler's
    /// errors.
    fn failures(
        &self,
        sources: &Sources,
        tasks: &[&str],
        seed: u64,
    ) -> Result<Result<Vec<(String, TaskResult)>, String>> {
        let folder = match self.tree.build_some(&self.sandbox, sources, &[ANSWER])? {
            Ok(folder) => folder,
            Err(why) => return Ok(Err(why)),
        };
        let asked = tasks.iter().copied();
        let results = self.questions.ask(&self.sandbox, folder.path(), asked, seed)?;
        let all = tasks.iter().map(|task| (*task).to_owned()).zip(results);
        Ok(Ok(all.filter(|(_, result)| result.wrong.is_some()).collect()))
    }

    /// Asks how often a line runs with one more worker, and which lines run at the same time.
    fn ask_about_runs(
        &self,
        sources: &Sources,
        lines: &[Line],
        random: &mut Random,
        sheet: &mut Sheet,
    ) -> Result<()> {
        let variants = self.facts.variants.iter().filter(|v| v.task.is_some() && !v.serial);
        let variants: Vec<_> = variants.collect();
        if variants.is_empty() || self.facts.workers == Workers::Device {
            return Ok(());
        }
        let mut probed = sources.clone();
        probe(&mut probed, lines);
        // If a line cannot have a probe, the build fails. The sheet then has other questions.
        let Ok(folder) = self.tree.build_some(&self.sandbox, &probed, &[PROGRAM])? else {
            return Ok(());
        };
        let variant = &variants[random.below(variants.len())].name;
        let two = Trace::of(&self.sandbox, folder.path(), variant, 2)?;
        let again = Trace::of(&self.sandbox, folder.path(), variant, 2)?;
        let three = Trace::of(&self.sandbox, folder.path(), variant, 3)?;
        // A count that differs from run to run, such as the number of repeated attempts, has no
        // key.
        let steady = two.counts.iter().filter(|(line, n)| again.counts.get(line) == Some(n));
        let more = steady.filter_map(|(line, n)| Some((*line, *n, *three.counts.get(line)?)));
        let counts: Vec<_> = more.filter(|(_, count, more)| count != more).collect();
        if !counts.is_empty() {
            let (at, count, more) = counts[random.below(counts.len())];
            let question = format!(
                "`{variant}` takes {STEPS} steps with {PARTICLES} particles and executes this line {count} times with 2 \
                 workers. How often with 3, and why?"
            );
            sheet.ask(sources, &lines[at], &lines[at].text, &question, format!("{more} times."));
        }
        let together: Vec<_> = three.together.into_iter().collect();
        if !together.is_empty() {
            let (at, others) = &together[random.below(together.len())];
            let question = format!(
                "In a run of `{variant}` one worker is at this line. Name a line of yours that a different worker can \
                 execute at the same time. Why do they not disturb each other?"
            );
            let others: Vec<_> = others.iter().map(|at| format!("`{}`", lines[*at].text)).collect();
            let key = format!("Seen at the same time: {}.", others.join(", "));
            sheet.ask(sources, &lines[*at], &lines[*at].text, &question, key);
        }
        Ok(())
    }
}

/// Returns the tests of a task that fail, and the first message; empty if the task was not asked.
fn failed(TaskResult { failed, wrong, .. }: &TaskResult) -> String {
    if failed.is_empty() {
        return String::new();
    }
    let wrong = wrong.as_deref().unwrap_or_default();
    format!("Fails: `{}`.\n\n```text\n{wrong}\n```\n\n", failed.join("`, `"))
}
