//! `cargo lab watch`: runs the tests again whenever a file is saved.

use std::io::Write;
use std::process::ExitCode;
use std::thread;
use std::time::Duration;

use anyhow::Result;
use clap::Args;

use crate::report::report;
use crate::results::{self, Run};
use crate::tasks::{State, What};
use crate::test::run_tests;
use lab_kit::answers::Task;
use lab_kit::progress::can_draw;
use lab_kit::{Kit, Lab, process};

/// Interval between two checks of the source. If an editor writes a file in several steps within
/// this time, they count as one change.
const TOGETHER: Duration = Duration::from_millis(300);

/// Test a lab again whenever you save a file
///
/// Runs the tests of the first task that is not done, then all tests, because a change may break a
/// finished task. Ends when every test passes, or with Ctrl-C.
#[derive(Args)]
pub(crate) struct Options {
    /// The lab, such as 2
    lab: Lab,
}

/// Watches the lab's source until every test passes.
pub(crate) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    process::kill_all_on_interrupt();
    let lab = options.lab;
    kit.expect_starter(lab)?;
    let mut open = None;
    loop {
        clear();
        let before = results::source(kit, lab)?;
        if let Some(run) = look(kit, lab, open)? {
            if run.passes() {
                return Ok(ExitCode::SUCCESS);
            }
            let first = run.tasks.iter().find(|progress| progress.state != State::Done);
            open = first.map(|progress| progress.task);
        }
        println!("\nWaiting for a change in labs/lab{lab}/src (Ctrl-C ends).");
        wait(kit, lab, &before)?;
    }
}

/// Runs the tests of the task that was unfinished in the last run, and then all tests. The tests of
/// one task are quick, so they come first.
///
/// All tests run, because the change may have broken any task. `None` if the lab does not compile.
fn look(kit: &Kit, lab: Lab, open: Option<Task>) -> Result<Option<Run>> {
    if open.is_some() && tested(kit, What { lab, task: open })?.is_none() {
        return Ok(None);
    }
    tested(kit, What { lab, task: None })
}

/// Runs the tests of a lab or a task, and prints its state on an empty screen.
fn tested(kit: &Kit, what: What) -> Result<Option<Run>> {
    let run = run_tests(kit, what.lab, what.task)?;
    if let Some(run) = &run {
        clear();
        report(kit, what, run, false)?;
    }
    Ok(run)
}

/// Waits until the source has changed and then stayed the same for a moment.
fn wait(kit: &Kit, lab: Lab, before: &str) -> Result<()> {
    let mut last = before.to_owned();
    loop {
        thread::sleep(TOGETHER);
        let now = results::source(kit, lab)?;
        if now != before && now == last {
            return Ok(());
        }
        last = now;
    }
}

/// Clears the screen, if the output is a terminal.
fn clear() {
    let mut out = std::io::stdout();
    if can_draw(&out) {
        // A terminal that refuses the codes keeps its contents.
        let _ = write!(out, "\x1b[2J\x1b[3J\x1b[H").and_then(|()| out.flush());
    }
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::thread;

    use super::{TOGETHER, wait};
    use crate::results;
    use lab_kit::Kit;

    #[test]
    fn only_another_text_is_a_change() {
        let folder = tempfile::tempdir().unwrap();
        let kit = Kit::of_files(folder.path(), &[("labs/lab1/src/lib.rs", "old")]);
        let lab = "1".parse().unwrap();
        let source = kit.starter(lab).join("src/lib.rs");
        let before = results::source(&kit, lab).unwrap();
        let kit = &kit;
        let before = &before;
        thread::scope(|scope| {
            let waiting = scope.spawn(move || wait(kit, lab, before));
            for _ in 0..2 {
                let file = fs::File::options().append(true).open(&source).unwrap();
                file.set_modified(std::time::SystemTime::now()).unwrap();
                thread::sleep(TOGETHER);
            }
            assert!(!waiting.is_finished(), "the text is what it was");
            fs::write(&source, "new").unwrap();
            waiting.join().unwrap().unwrap();
        });
        assert_ne!(results::source(kit, lab).unwrap(), *before);
    }

    #[test]
    fn what_was_saved_meanwhile_is_not_missed() {
        let folder = tempfile::tempdir().unwrap();
        let kit = Kit::at(folder.path());
        wait(&kit, "1".parse().unwrap(), "the hash of something else").unwrap();
    }
}
