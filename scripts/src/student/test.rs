//! `cargo lab test`: how far is my lab?

use std::io::IsTerminal;
use std::process::ExitCode;
use std::time::Duration;

use anyhow::{Result, bail};
use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use serde_json::json;

use super::results::{self, Results, Step};
use super::tasks::{self, Progress, State, passes};
use crate::harness::{self, BuildError, CompileError, Outcome, Verdict};
use crate::kit::{Kit, Lab};
use crate::marks::Task;
use crate::system;

/// Of a test's message, so many lines are shown.
const LINES: usize = 40;

/// Test your work on a lab, and show what to do next
///
/// Shows the first task that is not done, and why. Exit code 0 means that every test passes.
#[derive(Args)]
pub(crate) struct Options {
    /// The lab, such as 1
    lab: Lab,
    /// Show every test that fails, not only the first
    #[arg(long)]
    all: bool,
    /// Print everything as JSON
    #[arg(long)]
    json: bool,
}

/// Runs the tests and says how far the lab is.
pub(crate) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    harness::kill_all_on_interrupt();
    let lab = options.lab;
    let results = match run_visibly(kit, lab)? {
        Ok(results) => results,
        Err(errors) => {
            if options.json {
                let rendered: Vec<_> = errors.iter().map(|error| &error.rendered).collect();
                println!(
                    "{}",
                    serde_json::to_string_pretty(
                        &json!({ "lab": lab, "compile_errors": rendered })
                    )?
                );
            } else {
                print_compile_errors(lab, &errors);
            }
            return Ok(ExitCode::FAILURE);
        }
    };
    let progress = tasks::progress(kit, lab, &results.outcomes)?;
    let others: Vec<&Outcome> = results
        .outcomes
        .iter()
        .filter(|o| Task::of_test(&o.test).is_none() && !passes(o))
        .collect();
    if options.json {
        let done = progress.iter().filter(|p| p.state == State::Done).count();
        let value = json!({ "lab": lab, "title": kit.title(lab), "done": done,
                            "tasks": progress, "other_failures": others });
        println!("{}", serde_json::to_string_pretty(&value)?);
    } else {
        report(kit, lab, &progress, &others, options.all)?;
    }
    let all_pass = results.outcomes.iter().all(passes);
    let skipped: Vec<_> = results.outcomes.iter().filter_map(Outcome::skipped).collect();
    if let (Some(why), false) = (skipped.first(), options.json) {
        println!("\n{} tests did not run here: {why}.", skipped.len());
    }
    Ok(if all_pass { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Builds and runs the tests of a lab, with a bar on a terminal. The inner error is the student's.
pub(crate) fn run_visibly(kit: &Kit, lab: Lab) -> Result<Result<Results, Vec<CompileError>>> {
    kit.expect_starter(lab)?;
    if let Some(what) = system::missing(kit, lab)? {
        bail!("lab {lab} needs {what}");
    }
    let terminal = std::io::stderr().is_terminal();
    let bar = if terminal { ProgressBar::new_spinner() } else { ProgressBar::hidden() };
    bar.set_style(ProgressStyle::with_template("{spinner} {msg} ({elapsed})")?);
    bar.set_message(format!("building the tests of lab {lab}"));
    bar.enable_steady_tick(Duration::from_millis(100));
    let testing = ProgressStyle::with_template("{bar:40} test {pos} of {len}")?;
    let colour = std::io::stdout().is_terminal();
    let results = results::run(kit, lab, colour, |step| match step {
        Step::Tests(count) => {
            bar.set_style(testing.clone());
            bar.set_length(count as u64);
        }
        Step::Tested => bar.inc(1),
    });
    bar.finish_and_clear();
    match results {
        Ok(results) => Ok(Ok(results)),
        Err(BuildError::Compile(errors)) => Ok(Err(errors)),
        Err(BuildError::Cargo(trouble)) => {
            bail!(build_trouble(lab, &trouble))
        }
    }
}

/// What to say when cargo could not even try.
pub(super) fn build_trouble(lab: Lab, trouble: &str) -> String {
    format!("the tests of lab {lab} cannot be built: {trouble}")
}

/// Says what the compiler says, the first error only: the others often follow from it.
pub(crate) fn print_compile_errors(lab: Lab, errors: &[CompileError]) {
    let count = match errors.len() {
        1 => "The error:".to_owned(),
        n => format!("The first of {n} errors:"),
    };
    println!("Your lab {lab} does not compile yet. {count}\n");
    println!("{}", errors.first().map_or("", |error| error.rendered.trim_end()));
}

/// Says how far the lab is, what comes next, and where.
pub(super) fn report(
    kit: &Kit,
    lab: Lab,
    progress: &[Progress],
    others: &[&Outcome],
    all: bool,
) -> Result<()> {
    let done = progress.iter().filter(|p| p.state == State::Done).count();
    let (title, total) = (kit.title(lab), progress.len());
    let next = progress.iter().find(|p| matches!(p.state, State::Todo | State::Failing));
    let unrun = progress.iter().any(|p| p.state == State::Untested);
    println!(
        "Lab {lab}, {title}: {done} of {total} tasks done{}",
        match next {
            Some(next) if done == 0 && next.state == State::Todo =>
                format!(", start with task {}: {}.", next.task, next.title),
            Some(next) if next.state == State::Todo =>
                format!(", go on with task {}: {}.", next.task, next.title),
            Some(next) => format!(", task {} fails: {}.", next.task, next.title),
            None if others.is_empty() => ".".into(),
            None => ", but something else fails.".into(),
        }
    );
    if done > 0 || next.is_some_and(|next| next.state == State::Failing) {
        println!();
        super::list::print_tasks(progress);
    }
    if let Some(next) = next {
        println!();
        explain(next, all);
        if let Some(place) = tasks::place_of_todo(kit, next.task)? {
            println!("  its place    {place}");
        }
        if let Some(chapter) = kit.chapter(lab) {
            println!("  its chapter  {chapter}, or 'cargo lab book --serve'");
        }
        println!("  stuck?       cargo lab hint {}", next.task);
    }
    if all {
        let later = progress
            .iter()
            .filter(|p| p.state == State::Failing)
            .filter(|p| Some(p.task) != next.map(|n| n.task));
        for failing in later {
            println!("\nTask {}: {}", failing.task, failing.title);
            explain(failing, true);
        }
    }
    if next.is_none() || all {
        others.iter().for_each(|outcome| print_failure(outcome));
    }
    if next.is_none() && others.is_empty() && !unrun {
        println!(
            "Every test passes. What comes now: 'cargo lab check {lab}', and the measurements of its chapter."
        );
    }
    Ok(())
}

/// Prints why a task is not done: its first failure, or all of them. A `todo!` explains itself.
fn explain(progress: &Progress, all: bool) {
    let own_todo = |outcome: &Outcome| {
        outcome.todo().is_some_and(|id| {
            id.trim_end_matches(|c: char| c.is_ascii_lowercase()) == progress.task.to_string()
        })
    };
    let failures: Vec<_> = progress.tests.iter().filter(|o| !passes(o) && !own_todo(o)).collect();
    let shown = if all { failures.len() } else { 1 };
    for outcome in failures.iter().take(shown) {
        print_failure(outcome);
    }
    match failures.len().saturating_sub(shown) {
        0 => {}
        1 => println!("  One more test of this task fails: --all shows it.\n"),
        more => println!("  {more} more tests of this task fail: --all shows them.\n"),
    }
}

fn print_failure(outcome: &Outcome) {
    let how = match &outcome.verdict {
        Verdict::Crashed(how) => format!("did not finish: {how}"),
        Verdict::TimedOut => {
            "did not end: a loop goes on for ever, or two threads wait for each other".into()
        }
        _ => match outcome.todo() {
            Some(id) => format!("needs task {id} first"),
            None => "fails:".into(),
        },
    };
    println!("  {} {how}", outcome.test);
    let lines: Vec<&str> = outcome.message.lines().collect();
    if outcome.todo().is_none() {
        lines.iter().take(LINES).for_each(|line| println!("    {line}"));
        if lines.len() > LINES {
            println!("    … {} more lines", lines.len() - LINES);
        }
    }
    println!();
}
