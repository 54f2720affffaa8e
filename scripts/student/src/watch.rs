//! `cargo lab watch`: the tests again, whenever a file is saved.

use std::io::{IsTerminal, Write};
use std::process::ExitCode;
use std::thread;
use std::time::Duration;

use anyhow::{Result, bail};
use clap::Args;

use crate::report::report;
use crate::results::{self, Results};
use crate::tasks::{self, State, passes};
use crate::test::{build_trouble, print_compile_errors, run_visibly};
use lab_kit::answers::Task;
use lab_kit::harness::BuildError;
use lab_kit::process;
use lab_kit::{Kit, Lab};

/// How often the source is looked at. An editor writes a file in several steps: within this time they
/// are one change.
const TOGETHER: Duration = Duration::from_millis(300);

/// Test a lab again whenever you save a file
///
/// Runs the tests of the first task that is not done; all tests when it is. Ends when every test
/// passes, or with Ctrl-C.
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
    let mut last: Option<Results> = None;
    loop {
        clear();
        let before = results::source(kit, lab)?;
        match look(kit, lab, last.take())? {
            Seen::AllPass => return Ok(ExitCode::SUCCESS),
            Seen::Open(results) => last = Some(results),
            Seen::Broken => {}
        }
        println!("\nWaiting for a change in labs/lab{lab}/src (Ctrl-C ends).");
        wait(kit, lab, &before)?;
    }
}

/// What the tests say.
enum Seen {
    AllPass,
    Open(Results),
    Broken,
}

/// Runs the tests of the task that was open the last time, then all if it is done now.
fn look(kit: &Kit, lab: Lab, last: Option<Results>) -> Result<Seen> {
    let open = match &last {
        Some(results) => first_open(kit, lab, results)?,
        None => None,
    };
    if let (Some(task), Some(last)) = (open, last) {
        match results::rerun(kit, lab, task, last, std::io::stdout().is_terminal()) {
            Ok(results) if first_open(kit, lab, &results)? == Some(task) => {
                show(kit, lab, &results)?;
                return Ok(Seen::Open(results));
            }
            Ok(_) => {}
            Err(BuildError::Compile(errors)) => {
                print_compile_errors(lab, &errors);
                return Ok(Seen::Broken);
            }
            Err(BuildError::Cargo(trouble)) => bail!(build_trouble(lab, &trouble)),
        }
    }
    match run_visibly(kit, lab, None)? {
        Err(errors) => {
            print_compile_errors(lab, &errors);
            Ok(Seen::Broken)
        }
        Ok(results) => {
            show(kit, lab, &results)?;
            let all_pass = results.outcomes.iter().all(passes);
            Ok(if all_pass { Seen::AllPass } else { Seen::Open(results) })
        }
    }
}

fn show(kit: &Kit, lab: Lab, results: &Results) -> Result<()> {
    let progress = tasks::progress(kit, lab, &results.outcomes)?;
    report(kit, lab, &progress, &[], false)
}

fn first_open(kit: &Kit, lab: Lab, results: &Results) -> Result<Option<Task>> {
    let progress = tasks::progress(kit, lab, &results.outcomes)?;
    Ok(progress.iter().find(|progress| progress.state != State::Done).map(|open| open.task))
}

/// Returns when the source is not what it was, and stays so for a moment.
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

/// An empty screen, if it is one.
fn clear() {
    let mut out = std::io::stdout();
    if out.is_terminal() {
        // A terminal that does not take it keeps what it shows.
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
        let kit = Kit::at(folder.path());
        let lab = "1".parse().unwrap();
        let source = kit.starter(lab).join("src/lib.rs");
        fs::create_dir_all(source.parent().unwrap()).unwrap();
        fs::write(&source, "old").unwrap();
        let before = results::source(&kit, lab).unwrap();
        let (kit, before) = (&kit, &before);
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
