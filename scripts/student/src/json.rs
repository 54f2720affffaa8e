//! `cargo lab test --json`: the state of a lab for other programs.

use std::process::ExitCode;

use anyhow::{Result, bail};
use serde::Serialize;

use crate::results::{self, Run};
use crate::tasks::What;
use lab_kit::harness::{Build, BuildError};
use lab_kit::{Kit, Lab};

/// State of a lab or of one task, as it is printed.
#[derive(Serialize)]
struct Report {
    lab: Lab,
    /// Whether every test has run and passes.
    passes: bool,
    /// Errors of the compiler, in the compiler's words. If there are any errors, no test has run.
    compile_errors: Vec<String>,
    #[serde(flatten)]
    run: Run,
}

/// Runs the tests and prints their outcomes as JSON, and nothing else, to standard output.
///
/// # Errors
/// If Cargo cannot build the tests, or if a test cannot be started.
pub(crate) fn run(kit: &Kit, What { lab, task }: What, build: Build) -> Result<ExitCode> {
    let build = Build { shown: false, ..build };
    let report = match results::run(kit, lab, task, build, |_| {}) {
        Ok(run) => Report { lab, passes: run.passes(), compile_errors: Vec::new(), run },
        Err(BuildError::Compile(errors)) => {
            let compile_errors = errors.into_iter().map(|error| error.rendered).collect();
            Report { lab, passes: false, compile_errors, run: Run::default() }
        }
        Err(error) => bail!("the tests of lab {lab} cannot be built: {error}"),
    };
    println!("{}", serde_json::to_string_pretty(&report)?);
    Ok(if report.passes { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

#[cfg(test)]
mod tests {
    use super::Report;
    use crate::results::Run;
    use crate::tasks::Progress;
    use crate::tasks::State;
    use lab_kit::harness::{Outcome, Verdict};

    #[test]
    fn tasks_have_names_states_and_outcomes() {
        let mut tasks = Progress::samples(1, &[State::Failing]);
        tasks[0].tests = vec![Outcome::new("task_1_1::pairs", Verdict::Failed, "the distance")];
        let run = Run { tasks, ..Run::default() };
        let lab = "1".parse().unwrap();
        let report = Report { lab, passes: run.passes(), compile_errors: Vec::new(), run };
        let json = serde_json::to_value(&report).unwrap();
        assert_eq!(json["passes"], false);
        assert_eq!(json["tasks"][0]["task"], "1.1");
        assert_eq!(json["tasks"][0]["state"], "fails");
        assert_eq!(json["tasks"][0]["tests"][0]["verdict"], "failed");
    }
}
