//! `cargo lab prove`: do the graders grade?
//!
//! Three proofs a lab: its solution passes; its starter fails, every test at the `todo!` of its own
//! task and nowhere else; every known-wrong solution fails where it must.

mod copy;
mod mutants;
mod mutate;
mod report;
mod starter;

use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

use anyhow::Result;
use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};

use self::copy::Copy;
use self::report::{Kind, Proof, Row};
use lab_kit::answers::{self, MarkedFile, Task};
use lab_kit::harness::{self, Build, BuildError, Outcome, TestProgram, Verdict};
use lab_kit::machine::on_all_cores;
use lab_kit::process;
use lab_kit::system;
use lab_kit::wrong::{self, Wrong};
use lab_kit::{Kit, Lab};

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
    /// Only these mutants of the lab's answers: what `cargo mutants --list --json` wrote; fails if one survives
    #[arg(long, value_name = "FILE", requires = "lab", conflicts_with = "wrong")]
    mutants: Option<PathBuf>,
    /// A single test may take so long: longer than the watchdogs within it
    #[arg(long, default_value_t = 300, value_name = "SECONDS")]
    limit: u64,
    /// Print the table as JSON
    #[arg(long)]
    json: bool,
}

/// Proves the chosen labs.
pub fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    process::kill_all_on_interrupt();
    let mut rows = Vec::new();
    let mut labs = Vec::new();
    for lab in kit.chosen_solutions(options.lab)? {
        match system::missing(kit, lab)? {
            None => labs.push(lab),
            Some(what) => rows.extend([Kind::Solution, Kind::Starter, Kind::Wrong].map(|kind| {
                let faults = if kind == Kind::Solution {
                    vec![format!("it needs {what}")]
                } else {
                    Vec::new()
                };
                Row { lab, kind, name: "all".into(), tests: 0, result: Proof::Skipped, faults }
            })),
        }
    }
    let copy = Copy::make(kit, &labs)?;
    for &lab in &labs {
        let bench = Bench { kit, lab, limit: Duration::from_secs(options.limit), bar: bar(lab) };
        if let Some(list) = &options.mutants {
            rows.extend(bench.mutants(&copy, list)?);
            bench.bar.finish_and_clear();
            continue;
        }
        if options.wrong.is_none() {
            let solution = bench.solution()?;
            let skipped = solution.result == Proof::Skipped;
            rows.push(solution);
            if skipped {
                let unproven =
                    |kind| Row { result: Proof::Skipped, ..bench.row(kind, "all", 0, Vec::new()) };
                rows.extend([Kind::Starter, Kind::Wrong].map(unproven));
                bench.bar.finish_and_clear();
                continue;
            }
            rows.push(bench.starter()?);
        }
        rows.extend(bench.wrongs(&copy, options.wrong.as_deref())?);
        bench.bar.finish_and_clear();
    }
    rows.sort_by_key(|row| row.lab);
    if options.json {
        println!("{}", serde_json::to_string_pretty(&rows)?);
    } else {
        report::print(&rows);
    }
    let faulty = rows.iter().any(|row| row.result == Proof::Faulty);
    Ok(if faulty { ExitCode::FAILURE } else { ExitCode::SUCCESS })
}

/// What is needed to prove something about a lab.
struct Bench<'a> {
    kit: &'a Kit,
    lab: Lab,
    limit: Duration,
    bar: ProgressBar,
}

fn bar(lab: Lab) -> ProgressBar {
    if !std::io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("lab {prefix}  {bar:30} {pos}/{len}  {msg}");
    let bar = ProgressBar::new(0).with_prefix(lab.to_string());
    bar.with_style(style.expect("the template is valid"))
}

impl Bench<'_> {
    /// Says what comes next, on a terminal in the bar, else as a line.
    fn begin(&self, what: &str) {
        self.bar.set_position(0);
        self.bar.set_length(0);
        self.bar.set_message(what.to_owned());
        if self.bar.is_hidden() {
            eprintln!("lab {}: {what}", self.lab);
        }
    }

    fn row(&self, kind: Kind, name: &str, tests: usize, faults: Vec<String>) -> Row {
        let result = if faults.is_empty() { Proof::Proven } else { Proof::Faulty };
        Row { lab: self.lab, kind, name: name.into(), tests, result, faults }
    }

    fn build(
        &self,
        cargo: std::process::Command,
        package: &str,
    ) -> Result<TestProgram, BuildError> {
        harness::build(Build { cargo, package, lab: self.lab, shown: None, colour: false })
    }

    /// Runs all tests of a program.
    fn outcomes(&self, program: &TestProgram) -> Result<Vec<Outcome>> {
        let tests = program.tests()?;
        self.bar.set_length(tests.len() as u64);
        let run = |test: &String| {
            let outcome = program.run(test, &[], self.limit);
            self.bar.inc(1);
            outcome
        };
        on_all_cores(&tests, run).into_iter().collect()
    }

    fn solution(&self) -> Result<Row> {
        self.begin("the solution must pass");
        let program = match self.build(self.kit.cargo(), &format!("solution{}", self.lab)) {
            Ok(program) => program,
            Err(error) => return Ok(self.row(Kind::Solution, "", 0, vec![error.to_string()])),
        };
        let outcomes = self.outcomes(&program)?;
        let skipped: Vec<_> = outcomes.iter().filter_map(Outcome::skipped).collect();
        let bad = |o: &&Outcome| {
            !matches!(o.verdict, Verdict::Passed | Verdict::Ignored | Verdict::Skipped)
        };
        let failed: Vec<_> = outcomes.iter().filter(bad).collect();
        if let (Some(why), true) = (skipped.first(), failed.is_empty()) {
            let fault = format!("{} tests did not run: {why}", skipped.len());
            let row = self.row(Kind::Solution, "", outcomes.len(), vec![fault]);
            return Ok(Row { result: Proof::Skipped, ..row });
        }
        let faults = failed.iter().map(|o| format!("{}: {}", o.test, first_lines(o))).collect();
        Ok(self.row(Kind::Solution, "", outcomes.len(), faults))
    }

    fn starter(&self) -> Result<Row> {
        self.begin("the starter must fail at its todos");
        let program = match self.build(self.kit.cargo(), &format!("lab{}", self.lab)) {
            Ok(program) => program,
            Err(error) => return Ok(self.row(Kind::Starter, "", 0, vec![error.to_string()])),
        };
        let outcomes = self.outcomes(&program)?;
        let solution = answers::read_solution(self.kit, self.lab)?;
        let regions = solution.iter().flat_map(|file| file.marked.regions());
        let tasks: Vec<_> = regions.map(|region| region.id.task).collect();
        let faults = starter::faults(&outcomes, &tasks);
        Ok(self.row(Kind::Starter, "", outcomes.len(), faults))
    }

    /// Proves the wrong solutions whose name contains `name`.
    fn wrongs(&self, copy: &Copy, name: Option<&str>) -> Result<Vec<Row>> {
        self.begin("wrong solutions must be caught");
        let mut wrongs = wrong::read(self.kit, self.lab)?;
        wrongs.retain(|wrong| name.is_none_or(|name| wrong.name.contains(name)));
        let files = answers::read_solution(self.kit, self.lab)?;
        let (program, mut refused) = match self.mutated(copy, &files, &wrongs) {
            Ok(built) => built,
            Err(why) => return Ok(vec![self.row(Kind::Wrong, "all", 0, vec![format!("{why:#}")])]),
        };
        let tests = program.tests()?;
        let mut runs = Vec::new();
        for (index, wrong) in wrongs.iter().enumerate() {
            let unknown = wrong.fails.iter().filter(|test| !tests.contains(test));
            let unknown: Vec<_> = unknown.map(|test| format!("there is no test {test}")).collect();
            refused[index].extend(unknown);
            if refused[index].is_empty() {
                runs.extend(wrong.fails.iter().map(|test| (index, test)));
            }
        }
        self.bar.set_length(runs.len() as u64);
        let outcomes = on_all_cores(&runs, |(index, test)| {
            let outcome = program.run(test, &[mutate::choice(self.lab, *index)], self.limit);
            self.bar.inc(1);
            outcome
        });
        for ((index, _), outcome) in runs.iter().zip(outcomes) {
            refused[*index].extend(uncaught(&outcome?));
        }
        let rows = wrongs.iter().zip(refused);
        Ok(rows
            .map(|(wrong, faults)| self.row(Kind::Wrong, &wrong.name, wrong.fails.len(), faults))
            .collect())
    }

    /// Compiles the solution with all its wrong answers in it; beside it, why some of them had to be left
    /// out. An error if the fault is in none of them.
    fn mutated(
        &self,
        copy: &Copy,
        files: &[MarkedFile],
        wrongs: &[Wrong],
    ) -> Result<(TestProgram, Vec<Vec<String>>)> {
        let mut refused: Vec<Vec<String>> = vec![Vec::new(); wrongs.len()];
        loop {
            let without: Vec<usize> =
                (0..wrongs.len()).filter(|&i| !refused[i].is_empty()).collect();
            let mutants = mutate::mutate(self.lab, files, wrongs, &without)?;
            let folder = format!("solutions/lab{}", self.lab);
            for mutant in &mutants {
                copy.put(
                    &std::path::Path::new(&folder).join(&mutant.path),
                    mutant.text.as_bytes(),
                )?;
            }
            match self.build(copy.cargo(), &format!("solution{}", self.lab)) {
                Ok(program) => return Ok((program, refused)),
                Err(BuildError::Compile(errors)) => {
                    // Whose code does not compile is left out, and the others go on.
                    let before = without.len();
                    for error in &errors {
                        for mutant in &mutants {
                            let file = std::path::Path::new(&folder).join(&mutant.path);
                            for place in &mutant.places {
                                if error
                                    .places
                                    .iter()
                                    .any(|(f, line)| *f == file && place.holds(*line))
                                {
                                    refused[place.wrong].push(format!(
                                        "it does not compile in its place: {}",
                                        error.rendered
                                    ));
                                }
                            }
                        }
                    }
                    if refused.iter().filter(|why| !why.is_empty()).count() == before {
                        return Err(BuildError::Compile(errors).into());
                    }
                }
                Err(error) => return Err(error.into()),
            }
        }
    }

    /// Which mutants survive all tests? Those of the mutant's own task are asked first.
    fn mutants(&self, copy: &Copy, list: &Path) -> Result<Vec<Row>> {
        self.begin("mutants must be caught");
        let files = answers::read_solution(self.kit, self.lab)?;
        let mutants = mutants::read(self.kit, self.lab, list, &files)?;
        let (program, refused) = match self.mutated(copy, &files, &mutants) {
            Ok(built) => built,
            Err(why) => {
                return Ok(vec![self.row(Kind::Mutant, "all", 0, vec![format!("{why:#}")])]);
            }
        };
        let all = program.tests()?;
        self.bar.set_length(mutants.len() as u64);
        let indices: Vec<usize> = (0..mutants.len()).collect();
        let rows = on_all_cores(&indices, |&index| -> Result<Row> {
            let mutant = &mutants[index];
            let row = |tests, result, faults| {
                let (lab, name) = (self.lab, mutant.name.clone());
                Row { lab, kind: Kind::Mutant, name, tests, result, faults }
            };
            if let Some(why) = refused[index].first() {
                let why = why.lines().next().unwrap_or_default().to_owned();
                return Ok(row(0, Proof::Skipped, vec![why]));
            }
            let mut tests: Vec<_> = all.iter().collect();
            tests.sort_by_key(|test| Task::of_test(test) != Some(mutant.region.task));
            let mut asked = 0;
            for test in tests {
                asked += 1;
                let choice = mutate::choice(self.lab, index);
                let how = match program.run(test, &[choice], self.limit)?.verdict {
                    Verdict::Passed | Verdict::Ignored | Verdict::Skipped => continue,
                    Verdict::Failed => Vec::new(),
                    Verdict::Crashed(how) => vec![format!("{test}: {how}")],
                    Verdict::TimedOut => vec![format!("{test} did not end")],
                };
                self.bar.inc(1);
                return Ok(row(asked, Proof::Proven, how));
            }
            self.bar.inc(1);
            Ok(row(asked, Proof::Faulty, vec!["no test fails".into()]))
        });
        rows.into_iter().collect()
    }
}

/// Why a wrong solution does not count as caught. A process that dies or hangs says nothing
/// against the solution, unless the oracle's watchdog has spoken.
fn uncaught(outcome: &Outcome) -> Option<String> {
    let watchdog = outcome.message.contains(": no answer within ");
    match &outcome.verdict {
        Verdict::Failed => None,
        Verdict::Crashed(_) | Verdict::TimedOut if watchdog => None,
        Verdict::Passed => Some(format!("{} passes", outcome.test)),
        Verdict::Ignored => Some(format!("{} is ignored", outcome.test)),
        Verdict::Skipped => Some(format!("{}: {}", outcome.test, outcome.message)),
        Verdict::Crashed(how) => Some(format!("{}: {how}", outcome.test)),
        Verdict::TimedOut => Some(format!("{} did not end, and no watchdog spoke", outcome.test)),
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
