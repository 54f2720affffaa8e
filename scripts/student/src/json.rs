//! `cargo lab test --json`: the state of a lab for other programs.

use std::process::ExitCode;

use anyhow::{Result, bail};
use serde::Serialize;

use crate::results::{self, Run};
use crate::tasks::Progress;
use crate::test::{What, expect_lab, own_build};
use lab_kit::harness::{Build, BuildError, Outcome};
use lab_kit::{Kit, Lab};

/// State of a lab or of one task, as it is printed.
#[derive(Serialize)]
struct Report {
    lab: Lab,
    /// Whether every test has run and passes.
    passes: bool,
    /// Errors of the compiler, in the compiler's words. If there are any errors, no test has run.
    compile_errors: Vec<String>,
    /// Tasks with the outcomes of their tests.
    tasks: Vec<Progress>,
    /// Outcomes of tests that belong to no task.
    others: Vec<Outcome>,
    /// Number of tests that did not run, because an earlier test did not end.
    left_out: usize,
}

/// Runs the tests and prints their outcomes as JSON, and nothing else, to standard output.
///
/// # Errors
/// If this machine lacks what the tests need, if Cargo cannot build the tests, or if a test cannot be started.
pub(crate) fn run(kit: &Kit, What { lab, task }: What) -> Result<ExitCode> {
    expect_lab(kit, lab)?;
    let package = format!("lab{lab}");
    let build = Build { shown: false, ..own_build(kit.cargo(), lab, &package) };
    let report = match results::run(kit, lab, task, build, |_| {}) {
        Ok(run) => Report::of(lab, run),
        Err(BuildError::Compile(errors)) => Report {
            lab,
            passes: false,
            compile_errors: errors.into_iter().map(|error| error.rendered).collect(),
            tasks: Vec::new(),
            others: Vec::new(),
            left_out: 0,
        },
        Err(BuildError::Cargo(trouble)) => {
            bail!("the tests of lab {lab} cannot be built: {trouble}")
        }
    };
    println!("{}", serde_json::to_string_pretty(&report)?);
    Ok(if report.passes { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

impl Report {
    fn of(lab: Lab, run: Run) -> Self {
        let passes = run.passes();
        let Run { tasks, others, left_out } = run;
        Self { lab, passes, compile_errors: Vec::new(), tasks, others, left_out }
    }
}

#[cfg(test)]
mod tests {
    use super::Report;
    use crate::results::Run;
    use crate::tasks::{Progress, State};
    use lab_kit::harness::{Outcome, Verdict};

    #[test]
    fn tasks_have_names_states_and_outcomes() {
        let message = "the distance of particles 1 and 2".to_owned();
        let outcome = Outcome { test: "task_1_2::pairs".into(), verdict: Verdict::Failed, message };
        let progress = Progress {
            task: "1.2".parse().unwrap(),
            title: "All pairs".into(),
            optional: false,
            state: State::Failing,
            tests: vec![outcome],
        };
        let run = Run { tasks: vec![progress], others: Vec::new(), left_out: 0 };
        let report = Report::of("1".parse().unwrap(), run);
        let json = serde_json::to_value(&report).unwrap();
        assert_eq!(json["passes"], false);
        assert_eq!(json["tasks"][0]["task"], "1.2");
        assert_eq!(json["tasks"][0]["state"], "fails");
        assert_eq!(json["tasks"][0]["tests"][0]["verdict"], "failed");
    }
}
