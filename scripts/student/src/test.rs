//! `cargo lab test`: shows the state of a lab.

use std::process::{Command, ExitCode};
use std::sync::Mutex;

use anyhow::{Result, bail, ensure};
use clap::Args;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::json;
use crate::memory::{recall, remember};
use crate::report::report;
use crate::results::{self, Run, Step};
use crate::tasks::{What, expect_task};
use lab_kit::answers::Task;
use lab_kit::harness::{Build, BuildError, CompileError, Outcome};
use lab_kit::progress::can_draw;
use lab_kit::terminal::folded;
use lab_kit::{Kit, Lab, process, sources, system};

/// Test your work on a lab, and show what to do next
///
/// Shows the first task that is not done, and why. If you name a task, shows whether that task is
/// done. Exit code 0 means that every test passes.
#[derive(Args)]
pub(crate) struct Options {
    /// The lab, such as 1, or one of its tasks, such as 1.3
    #[arg(value_name = "LAB|TASK")]
    what: What,
    /// Show every failing test, not only the first
    #[arg(long)]
    all: bool,
    /// Print the state of all tests as JSON, for editors and other programs
    #[arg(long, conflicts_with = "all")]
    json: bool,
}

/// Runs the tests and prints the state of the lab or the task.
pub(crate) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    process::kill_all_on_interrupt();
    let What { lab, task } = options.what;
    kit.expect_starter(lab)?;
    if let Some(task) = task {
        expect_task(kit, task)?;
    }
    if options.json {
        expect_lab(kit, lab)?;
        return json::run(kit, options.what, own_build(kit, lab)?);
    }
    let Some(run) = run_tests(kit, lab, task)? else { return Ok(ExitCode::FAILURE) };
    report(kit, options.what, &run, options.all)?;
    if let left_out @ 1.. = run.left_out {
        println!("\n{left_out} tests were not run, because one did not end.");
    }
    let skipped: Vec<_> = run.outcomes().filter_map(Outcome::skipped).collect();
    if let Some(why) = skipped.first() {
        println!("\n{} tests did not run here: {why}.", skipped.len());
    }
    Ok(if run.passes() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Returns an error if the kit lacks this lab, or if this machine lacks what its tests need.
fn expect_lab(kit: &Kit, lab: Lab) -> Result<()> {
    kit.expect_starter(lab)?;
    system::expect(kit, lab)
}

/// Builds and runs the tests of a lab, or of one task. `None` if the lab does not compile; the
/// error is printed.
pub(crate) fn run_tests(kit: &Kit, lab: Lab, only: Option<Task>) -> Result<Option<Run>> {
    run_build(kit, lab, only, own_build(kit, lab)?)
}

/// Returns the order for building the tests in a lab's folder with visible output.
fn own_build(kit: &Kit, lab: Lab) -> Result<Build> {
    let tests = format!("labs/lab{lab}/tests/lab{lab}.rs");
    ensure!(kit.path(&tests).is_file(), "{tests} is missing: copy it from the kit that you got");
    Ok(visible_build(kit.cargo(), lab, format!("lab{lab}")))
}

/// Returns the order for building the tests of a package with visible output.
pub(crate) fn visible_build(cargo: Command, lab: Lab, package: String) -> Build {
    let colour = can_draw(&std::io::stdout()) && std::env::var_os("NO_COLOR").is_none();
    Build { cargo, package, lab, shown: true, colour }
}

/// Builds and runs tests by `build`. A bar on a terminal names the test that has run longest.
pub(crate) fn run_build(
    kit: &Kit,
    lab: Lab,
    only: Option<Task>,
    build: Build,
) -> Result<Option<Run>> {
    expect_lab(kit, lab)?;
    name_unread(kit, lab)?;
    let bar = ProgressBar::hidden();
    bar.set_style(ProgressStyle::with_template("{bar:30} test {pos} of {len}  {wide_msg}")?);
    let running = Mutex::new(Vec::new());
    let run = results::run(kit, lab, only, build, |step| {
        let mut running = running.lock().expect("drawing does not panic");
        match step {
            Step::Tests(count) => {
                bar.set_length(count as u64);
                if can_draw(&std::io::stderr()) {
                    bar.set_draw_target(ProgressDrawTarget::stderr());
                }
            }
            Step::Begun(test) => running.push(test.to_owned()),
            Step::Ended(test) => {
                running.retain(|other| other != test);
                bar.inc(1);
            }
        }
        bar.set_message(running.first().cloned().unwrap_or_default());
    });
    bar.finish_and_clear();
    match run {
        Ok(run) => Ok(Some(run)),
        Err(BuildError::Compile(errors)) => {
            print_compile_errors(lab, &errors);
            Ok(None)
        }
        Err(error) => bail!("the tests of lab {lab} cannot be built: {error}"),
    }
}

/// Prints the files in src that are not read, unless the last run printed them.
fn name_unread(kit: &Kit, lab: Lab) -> Result<()> {
    let file = format!("unread/lab{lab}.json");
    let mut unread = Vec::new();
    for (path, why) in sources::collect(&kit.starter(lab))?.left_out {
        unread.push(format!("labs/lab{lab}/{}: {why}", path.display()));
    }
    let named: Option<Vec<String>> = recall(kit, &file);
    if named.unwrap_or_default() != unread {
        unread.iter().for_each(|line| print!("{}", folded("not read: ", line)));
        remember(kit, &file, &unread)?;
    }
    Ok(())
}

/// Prints the first compiler error and its location. Further errors often follow from it.
fn print_compile_errors(lab: Lab, errors: &[CompileError]) {
    let Some(first) = errors.first() else { return };
    let location = first.location.as_ref();
    let location = location.map(|(file, line)| format!(": {}, line {line}", file.display()));
    let count = match errors.len() {
        1 => String::new(),
        n => format!(" (the first of {n} errors)"),
    };
    println!("Lab {lab} does not compile yet{}{count}.\n", location.unwrap_or_default());
    println!("{}", first.rendered.trim_end());
}
