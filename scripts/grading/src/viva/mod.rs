//! `cargo lab viva`: writes a sheet of oral questions about each student's own program.
//!
//! Some questions show the program with one line changed ([`changes`]). Others are about its lines
//! as they run ([`trace`]). Every key comes from a run: of the changed program on the lab's tests,
//! or of the program with probes.

mod changes;
mod sheet;
mod trace;

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

use anyhow::{Result, anyhow, bail, ensure};
use clap::Args;
use tempfile::TempDir;

use self::changes::{Line, changes, own_lines};
use self::sheet::Sheet;
use self::trace::{PARTICLES, STEPS, Trace, probed};
use crate::asking::{JUDGE, Judge, Questions, Said};
use crate::build::Tree;
use crate::escape::line;
use crate::intake::names::named;
use crate::intake::{self, forbidden};
use crate::sandbox::{Limits, Sandbox};
use lab_kit::files::write_file;
use lab_kit::process::kill_all_on_interrupt;
use lab_kit::submission::Sources;
use lab_kit::{Facts, Given, Kit, Lab, Workers, rubric};
use oracle::Random;

/// Number of questions on a sheet.
const QUESTIONS: usize = 5;

/// Maximal number of changed programs that are built for a sheet. Some do not compile, and some
/// pass all tests.
const TRIES: usize = 16;

/// Write oral questions about each student's own program (for instructors)
///
/// Each sheet has five questions and a key. Some questions change a line of the student's program, and the key lists
/// the tests that fail. Others ask how often a line runs, and what runs at the same time. Programs run in the sandbox.
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
    let (lab, run, build) = (options.lab, Duration::from_secs(10), Duration::from_secs(600));
    let facts = rubric::read(kit, lab)?;
    let loopback = facts.workers == Workers::Ranks;
    let sandbox = Sandbox::find(kit, false, Limits { run, build, loopback })?;
    let into = options.into.clone();
    let into = into.unwrap_or_else(|| kit.memory().join(format!("viva/lab{lab}")));
    let mut submissions = Vec::new();
    for path in &options.paths {
        submissions.extend(intake::submissions(kit, path)?);
    }
    kill_all_on_interrupt();
    eprintln!("Building the solution");
    let tree = Tree::lay(kit, lab, &sandbox)?;
    let solution = tree.reference(kit, &sandbox)?;
    let judge = Judge::new(kit, lab, solution.path().join(JUDGE), 10 * run);
    let questions = Questions::of(&sandbox, solution.path(), judge, options.seed)?;
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
        let sources = intake::take(self.kit, self.lab, &self.given, path)?.files;
        ensure!(!sources.is_empty(), "it has no file with a task of lab {}", self.lab);
        if let Some(why) = forbidden::find(&sources) {
            bail!("{why}");
        }
        let own = self.asked(&sources, seed)?;
        let own = own.map_err(|why| anyhow!("it does not compile: {why}"))?;
        let mut lines = own_lines(self.kit, self.lab, &sources)?;
        let tasks: Vec<&String> = self.facts.tasks.keys().collect();
        lines.retain(|line| {
            let task = line.task.map(|task| task.to_string());
            task.and_then(|task| tasks.iter().position(|own| **own == task))
                .is_none_or(|at| own[at].wrong.is_none())
        });
        ensure!(!lines.is_empty(), "no task of it is right");
        let mut random = Random::new(seed);
        let mut sheet = Sheet::default();
        if let Ok(folder) = self.tree.build(&self.sandbox, &probed(&sources, &lines))? {
            self.ask_about_runs(&folder, &sources, &lines, &mut random, &mut sheet)?;
        }
        let mut changes = changes(self.kit, self.lab, &lines)?;
        // Known mistakes come first, because their keys explain them.
        changes.sort_by_cached_key(|change| (change.story.is_none(), random.bits()));
        let mut changed = Vec::new();
        for change in changes {
            if sheet.len() == QUESTIONS || sheet.tried == TRIES {
                break;
            }
            if change.line.task.is_some() && changed.contains(&change.line.task) {
                continue;
            }
            sheet.tried += 1;
            let Ok(said) = self.asked(&change.applied(&sources), seed)? else { continue };
            let results = tasks.iter().copied().zip(own.iter().zip(&said));
            if sheet.ask_about_change(&sources, &change, results) {
                changed.push(change.line.task);
            }
        }
        Ok(sheet)
    }

    /// Asks a program all questions. Returns the result of each task, or the compiler's errors.
    fn asked(&self, sources: &Sources, seed: u64) -> Result<Result<Vec<Said>, String>> {
        let folder = match self.tree.build(&self.sandbox, sources)? {
            Ok(folder) => folder,
            Err(why) => return Ok(Err(why)),
        };
        let tasks = self.facts.tasks.keys().map(String::as_str);
        self.questions.ask(&self.sandbox, folder.path(), tasks, seed).map(Ok)
    }

    /// Adds a question about the number of executions of a line, and one about lines that run at the
    /// same time.
    fn ask_about_runs(
        &self,
        folder: &TempDir,
        sources: &Sources,
        lines: &[Line],
        random: &mut Random,
        sheet: &mut Sheet,
    ) -> Result<()> {
        let run =
            |variant: &str, workers| Trace::of_run(&self.sandbox, folder.path(), variant, workers);
        let variants = self.facts.variants.iter().filter(|variant| variant.task.is_some());
        let variants: Vec<&str> = variants.map(|variant| &*variant.name).collect();
        let word = match self.facts.workers {
            Workers::Ranks => "rank",
            _ => "thread",
        };
        let mut counted = false;
        if !variants.is_empty() && self.facts.workers != Workers::Device {
            let variant = variants[random.below(variants.len())];
            let (two, again, three) = (run(variant, 2)?, run(variant, 2)?, run(variant, 3)?);
            // A count that differs from run to run, such as of repeated attempts, has no key.
            let more =
                two.counts.iter().filter(|(line, count)| again.counts.get(line) == Some(count));
            let more =
                more.filter_map(|(line, count)| Some((*line, *count, *three.counts.get(line)?)));
            let more: Vec<_> = more.filter(|(_, count, after)| count != after).collect();
            if !more.is_empty() {
                let (at, before, after) = more[random.below(more.len())];
                let question = format!(
                    "`{variant}` takes {STEPS} steps with {PARTICLES} particles. With 2 {word}s it executes this line \
                     {before} times. How often with one {word} more, and why?"
                );
                sheet.ask_about_line(sources, &lines[at], &question, &format!("{after} times."));
                counted = true;
            }
            let together: Vec<_> = three.together.iter().collect();
            if !together.is_empty() {
                let (at, others) = together[random.below(together.len())];
                let question = format!(
                    "One {word} is at this line, in a run of `{variant}`. Name a line of yours that a different {word} \
                     can execute at the same time. What keeps the two from disturbing each other?"
                );
                let others: Vec<String> =
                    others.iter().map(|other| lines[*other].quoted()).collect();
                let key = format!("Seen at the same time in a run: {}.", others.join("; "));
                sheet.ask_about_line(sources, &lines[*at], &question, &key);
            }
        }
        let mut tasks: Vec<_> = lines.iter().filter_map(|line| line.task).collect();
        tasks.sort_by_cached_key(|_| random.bits());
        for task in tasks {
            if counted {
                break;
            }
            let example =
                self.questions.example(&self.sandbox, folder.path(), &task.to_string(), 1)?;
            let Some((text, output)) = example else { continue };
            let trace = Trace::read(&output);
            let counts: Vec<_> = trace.counts.iter().collect();
            if !counts.is_empty() {
                let (at, count) = counts[random.below(counts.len())];
                let question = format!(
                    "The worked example of task {task} is run. *{text}* How often does it execute this line, and on \
                     how many {word}s?"
                );
                let key = format!("{count} times, on {} {word}s.", trace.workers[at]);
                sheet.ask_about_line(sources, &lines[*at], &question, &key);
                counted = true;
            }
        }
        Ok(())
    }
}
