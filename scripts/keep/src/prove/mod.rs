//! `cargo lab prove`: proves that the graders grade.
//!
//! Each lab has three proofs. Its solution passes. Its starter fails, each test at the `todo!` of
//! its own task and in no other place. Every known-wrong solution fails the tests that it names.

mod copy;
mod mutate;
mod proofs;
mod starter_faults;
mod wrongs;

use std::process::{Command, ExitCode};
use std::time::Duration;

use anyhow::Result;
use clap::Args;
use indicatif::ProgressBar;

use self::copy::Copy;
use self::proofs::{Proof, Row};
use lab_kit::harness::{self, Build, BuildError, Outcome, TestProgram, Verdict};
use lab_kit::machine::on_all_cores;
use lab_kit::progress::progress;
use lab_kit::{Kit, Lab, answers, process, system};

/// Prove that the graders grade (for those who maintain the kit)
///
/// Solutions pass, starters fail at their todos, and every known-wrong solution in tests/wrong
/// fails the tests that it names.
#[derive(Args)]
pub struct Options {
    /// Only this lab [default: all]
    #[arg(long, value_name = "N")]
    lab: Option<Lab>,
    /// Only wrong solutions whose name contains this; leaves solution and starter out
    #[arg(long, value_name = "NAME")]
    wrong: Option<String>,
    /// The limit of a single test: longer than the watchdogs within it
    #[arg(long, default_value_t = 300, value_name = "SECONDS")]
    limit: u64,
}

/// Proves the chosen labs.
pub fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    process::kill_all_on_interrupt();
    let mut rows = Vec::new();
    let mut labs = Vec::new();
    for lab in kit.chosen_solutions(options.lab)? {
        match system::missing(kit, lab)? {
            None => labs.push(lab),
            Some(missing) => rows.push(Row {
                lab,
                what: "all".into(),
                tests: 0,
                result: Proof::Skipped,
                faults: vec![format!("it needs {missing}")],
            }),
        }
    }
    for &lab in &labs {
        let copy = Copy::make(kit, lab)?;
        let limit = Duration::from_secs(options.limit);
        let bench = Bench { kit, lab, limit, bar: progress(0) };
        if options.wrong.is_none() {
            let solution = bench.solution()?;
            let skipped = solution.result == Proof::Skipped;
            rows.push(solution);
            if skipped {
                bench.bar.finish_and_clear();
                continue;
            }
            rows.push(bench.starter()?);
        }
        rows.extend(bench.wrongs(&copy, options.wrong.as_deref())?);
        bench.bar.finish_and_clear();
    }
    rows.sort_by_key(|row| row.lab);
    proofs::print(&rows);
    let faulty = rows.iter().any(|row| row.result == Proof::Faulty);
    Ok(if faulty { ExitCode::FAILURE } else { ExitCode::SUCCESS })
}

/// Settings for the proofs of a lab.
struct Bench<'a> {
    kit: &'a Kit,
    lab: Lab,
    limit: Duration,
    bar: ProgressBar,
}

impl Bench<'_> {
    /// Announces the next proof, on a terminal in the progress bar, and otherwise in a line.
    fn begin(&self, what: &str) {
        self.bar.set_position(0);
        self.bar.set_length(0);
        let what = format!("lab {}: {what}", self.lab);
        if self.bar.is_hidden() {
            eprintln!("{what}");
        }
        self.bar.set_message(what);
    }

    /// Makes a row of the table about `what`. If there are no faults, its result is `how`.
    fn row(&self, what: &str, how: &'static str, tests: usize, faults: Vec<String>) -> Row {
        let result = if faults.is_empty() { Proof::Proven(how) } else { Proof::Faulty };
        Row { lab: self.lab, what: what.into(), tests, result, faults }
    }

    /// Builds the tests of the lab's `solution` or `lab`.
    fn build(&self, cargo: Command, package: &str) -> Result<TestProgram, BuildError> {
        let lab = self.lab;
        let package = format!("{package}{lab}");
        harness::build(Build { cargo, package, lab, shown: false, colour: false })
    }

    /// Runs all tests of a program.
    fn outcomes(&self, program: &TestProgram) -> Result<Vec<Outcome>> {
        let tests = program.tests()?;
        self.bar.set_length(tests.len() as u64);
        let outcomes = on_all_cores(&tests, |test| {
            let outcome = program.run(test, &[], self.limit);
            self.bar.inc(1);
            outcome
        });
        outcomes.into_iter().collect()
    }

    /// Builds a package of the kit and runs its tests. The inner error is a failed build.
    fn tested(&self, package: &str) -> Result<Result<Vec<Outcome>, String>> {
        match self.build(self.kit.cargo(), package) {
            Ok(program) => self.outcomes(&program).map(Ok),
            Err(error) => Ok(Err(error.to_string())),
        }
    }

    fn solution(&self) -> Result<Row> {
        self.begin("the solution must pass");
        let outcomes = match self.tested("solution")? {
            Ok(outcomes) => outcomes,
            Err(why) => return Ok(self.row("solution", "passes", 0, vec![why])),
        };
        let skipped: Vec<_> = outcomes.iter().filter_map(Outcome::skipped).collect();
        let failed: Vec<_> = outcomes.iter().filter(|outcome| !outcome.passes()).collect();
        let faults = failed.iter().map(|o| format!("{}: {}", o.test, first_lines(o))).collect();
        let row = self.row("solution", "passes", outcomes.len(), faults);
        if let (Some(why), true) = (skipped.first(), failed.is_empty()) {
            let faults = vec![format!("{} tests did not run: {why}", skipped.len())];
            return Ok(Row { result: Proof::Skipped, faults, ..row });
        }
        Ok(row)
    }

    fn starter(&self) -> Result<Row> {
        self.begin("the starter must fail at its todos");
        let tasks = answers::tasks(self.kit, self.lab)?;
        let (count, faults) = match self.tested("lab")? {
            Ok(outcomes) => (outcomes.len(), starter_faults::faults(&outcomes, &tasks)),
            Err(why) => (0, vec![why]),
        };
        Ok(self.row("starter", "fails at its todos", count, faults))
    }
}

fn first_lines(outcome: &Outcome) -> String {
    let text = match &outcome.verdict {
        Verdict::TimedOut => "it did not end in time",
        Verdict::Crashed(how) => how,
        _ => &outcome.message,
    };
    text.lines().take(6).collect::<Vec<_>>().join("\n")
}
