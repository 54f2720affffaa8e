//! `cargo lab check`: checks whether a lab is ready to be handed in.

use std::process::ExitCode;

use anyhow::{Context, Result};
use clap::Args;
use serde::{Deserialize, Serialize};

use crate::door;
use crate::graded::Graded;
use crate::memory::{recall, remember};
use crate::results::{self, Run};
use crate::tasks::{self, State};
use crate::test::{run_build, run_tests};
use lab_kit::cargo::run_visibly;
use lab_kit::starter::Record;
use lab_kit::terminal::folded;
use lab_kit::{Kit, Lab, fresh, process, sources, system};

/// Check a lab before you hand it in: format, lints, tests, and the labs before it
///
/// Checks all four and prints a result for each. Exit code 0 means that all are right. The lab's
/// tests run on the files that 'cargo lab submit' would pack, built as the grader builds them: with
/// the kit's own given files. If the lab is about fast loops, the command also tests whether your
/// loops are fast ('cargo lab speed').
#[derive(Args)]
pub(crate) struct Options {
    /// The lab, such as 2
    lab: Lab,
    /// Skip the tests of earlier labs
    #[arg(long)]
    only: bool,
}

/// Checks the lab, and earlier labs that the student has begun.
pub(crate) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    process::kill_all_on_interrupt();
    let lab = options.lab;
    kit.expect_starter(lab)?;
    let source = results::source(kit, lab)?;
    let mut troubles = Troubles::default();
    troubles.say("format", format(kit, lab)?);
    // As long as a `todo!` remains, clippy complains about the provided code, for instance about a
    // `&mut` parameter that is not modified yet.
    if !tasks::open_todos(kit, lab)?.is_empty() {
        println!("lints    not looked at while a todo! is left");
    } else {
        troubles.say("lints", lints(kit, lab)?);
    }
    let own = graded(kit, lab)?;
    let is_whole = own.is_ok();
    troubles.say(&format!("lab {lab}"), own);
    if is_whole && !kit.facts(lab)?.races.is_empty() {
        println!("loops    right, and as for speed:");
        door::pass(kit, &["speed", &lab.to_string()])?;
    }
    let seen = Seen { source, troubles: troubles.0.clone() };
    remember(kit, &name(lab), &seen)?;
    for earlier in kit.starters().into_iter().filter(|earlier| !options.only && *earlier < lab) {
        if !is_begun(kit, earlier)? {
            continue;
        }
        let name = format!("lab {earlier}");
        match system::missing(kit, earlier)? {
            Some(what) => {
                let head = format!("{name:8} not tested: ");
                print!("{}", folded(&head, &format!("it needs {what}")));
            }
            None => troubles.say(&name, tests(kit, earlier)?),
        }
    }
    Ok(if troubles.0.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Result of a lab's last check, kept under `target/` for `cargo lab submit`.
#[derive(Serialize, Deserialize)]
pub(crate) struct Seen {
    source: String,
    /// Problems that the check found.
    pub(crate) troubles: Vec<String>,
}

impl Seen {
    /// Reads the last check; `None` if the lab's source has changed since.
    pub(crate) fn read(kit: &Kit, lab: Lab) -> Result<Option<Self>> {
        let seen: Option<Self> = recall(kit, &name(lab));
        let now = results::source(kit, lab)?;
        Ok(seen.filter(|seen| seen.source == now))
    }
}

fn name(lab: Lab) -> String {
    format!("checks/lab{lab}.json")
}

/// Problems found so far.
#[derive(Default)]
struct Troubles(Vec<String>);

impl Troubles {
    /// Prints a line about a check, and records the problem if there is one.
    fn say(&mut self, name: &str, verdict: Result<String, String>) {
        match verdict {
            Ok(well) => print!("{}", folded(&format!("{name:8} well: "), &well)),
            Err(trouble) => {
                print!("{}", folded(&format!("{name:8} NOT WELL: "), &trouble));
                self.0.push(format!("{name}: {trouble}"));
            }
        }
    }
}

fn format(kit: &Kit, lab: Lab) -> Result<Result<String, String>> {
    let mut cargo = kit.cargo();
    cargo.args(["fmt", "--check", "--package", &format!("lab{lab}"), "--", "-l"]);
    let output = cargo.output().context("cargo fmt did not start")?;
    Ok(if output.status.success() {
        Ok("as rustfmt writes it".into())
    } else {
        Err(format!("'cargo fmt -p lab{lab}' formats it, or names what it cannot read"))
    })
}

/// Runs clippy on the lab.
///
/// Unused code counts, although the starters' manifests allow it. Printing counts too: a grader's
/// questions have many particles, so printing would exceed the time limit.
fn lints(kit: &Kit, lab: Lab) -> Result<Result<String, String>> {
    let mut cargo = kit.cargo();
    cargo.args(["clippy", "--no-deps", "--package", &format!("lab{lab}")]);
    cargo.args(["--message-format=json-render-diagnostics", "--lib", "--bins"]);
    cargo.args(["--", "-D", "warnings", "-D", "unused"]);
    cargo.args(["-Dclippy::print_stdout", "-Dclippy::print_stderr", "-Dclippy::dbg_macro"]);
    let output = fresh::build(&mut cargo, run_visibly).context("cargo clippy did not start")?;
    Ok(if output.status.success() {
        Ok("clippy has nothing to say, and nothing is unused".into())
    } else {
        Err("clippy's messages above name the changes".into())
    })
}

/// Whether any file of the lab has changed since it was given.
fn is_begun(kit: &Kit, lab: Lab) -> Result<bool> {
    let folder = kit.starter(lab);
    let record = Record::read(&folder)?;
    Ok(record.paths().any(|path| !record.is_own(&folder, path)))
}

/// Tests an earlier lab.
fn tests(kit: &Kit, lab: Lab) -> Result<Result<String, String>> {
    let run = run_tests(kit, lab, None)?;
    Ok(run.map_or_else(|| Err("it does not compile".into()), |run| unbroken(lab, &run)))
}

/// Tests the files that would be handed in, built as the grader builds them.
fn graded(kit: &Kit, lab: Lab) -> Result<Result<String, String>> {
    let collected = sources::collect(&kit.starter(lab))?;
    let graded = Graded::lay(kit, lab, &collected)?;
    let run = run_build(kit, lab, None, graded.tests())?;
    Ok(run.map_or_else(|| Err(graded.unbuilt()), |run| complete(lab, &run)))
}

/// Judges the lab that is handed in: every core task must be done.
fn complete(lab: Lab, run: &Run) -> Result<String, String> {
    let well = unbroken(lab, run)?;
    let mut core = run.tasks.iter().filter(|progress| !progress.optional);
    match core.find(|progress| progress.state != State::Done) {
        Some(open) => Err(format!("{well}, the next is {}, {}", open.task, open.title)),
        None => Ok(well),
    }
}

/// Judges an earlier lab: no answer may fail. Tasks that were left out are ignored.
fn unbroken(lab: Lab, run: &Run) -> Result<String, String> {
    let see = format!("'cargo lab test {lab}' shows why");
    if let Some(broken) = run.tasks.iter().find(|progress| progress.state == State::Failing) {
        return Err(format!("task {} fails, {}: {see}", broken.task, broken.title));
    }
    if let Some(other) = run.other_failures().first() {
        return Err(format!("{} fails: {see}", other.test));
    }
    Ok(format!("{} of {} tasks done", tasks::done(&run.tasks), run.tasks.len()))
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::{complete, is_begun, unbroken};
    use crate::results::Run;
    use crate::tasks::Progress;
    use crate::tasks::State;
    use lab_kit::Kit;
    use lab_kit::harness::{Outcome, Verdict};
    use lab_kit::starter::Record;

    fn run(states: &[State]) -> Run {
        Run { tasks: Progress::samples(2, states), ..Run::default() }
    }

    #[test]
    fn a_task_left_out_counts_only_in_the_lab_that_is_handed_in() {
        let lab = "2".parse().unwrap();
        let open = run(&[State::Done, State::Todo]);
        assert_eq!(unbroken(lab, &open).unwrap(), "1 of 2 tasks done");
        let why = complete(lab, &open).unwrap_err();
        assert_eq!(why, "1 of 2 tasks done, the next is 2.2, a task");
        let done = run(&[State::Done, State::Done]);
        assert_eq!(complete(lab, &done).unwrap(), "2 of 2 tasks done");
    }

    #[test]
    fn a_failure_counts_everywhere() {
        let lab = "2".parse().unwrap();
        let broken = run(&[State::Failing, State::Done]);
        for judge in [unbroken, complete] {
            let why = judge(lab, &broken).unwrap_err();
            assert_eq!(why, "task 2.1 fails, a task: 'cargo lab test 2' shows why");
        }
        let other = Outcome::new("the_list", Verdict::Failed, "");
        let done = Run { others: vec![other], ..run(&[State::Done]) };
        for judge in [unbroken, complete] {
            let why = judge(lab, &done).unwrap_err();
            assert_eq!(why, "the_list fails: 'cargo lab test 2' shows why");
        }
    }

    #[test]
    fn a_lab_is_begun_when_a_given_file_has_changed() {
        let folder = tempfile::tempdir().unwrap();
        let kit = Kit::of_files(folder.path(), &[("labs/lab1/src/lib.rs", "given")]);
        let lab = "1".parse().unwrap();
        let given = [("src/lib.rs".into(), b"given".to_vec())].into();
        Record::of(&given).write(&kit.starter(lab)).unwrap();
        assert!(!is_begun(&kit, lab).unwrap());
        fs::write(kit.starter(lab).join("src/lib.rs"), "mine").unwrap();
        assert!(is_begun(&kit, lab).unwrap());
    }
}
