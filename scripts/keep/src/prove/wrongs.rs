//! Checks that known-wrong solutions fail the tests that they name, and unusual right ones pass.

use std::path::PathBuf;

use anyhow::Result;

use super::copy::Copy;
use super::mutate::{environment, mutate};
use super::proofs::Row;
use super::{Bench, first_lines};
use lab_kit::answers;
use lab_kit::harness::{Outcome, Verdict};
use lab_kit::machine::on_all_cores;
use lab_kit::wrong::{self, Wrong};

impl Bench<'_> {
    /// Proves the wrong solutions and the unusual right ones whose name contains `name`.
    pub(super) fn wrongs(&self, copy: &Copy, name: Option<&str>) -> Result<Vec<Row>> {
        self.begin("wrong solutions must be caught");
        let mut wrongs = wrong::read(self.kit, self.lab)?;
        wrongs.extend(wrong::read_right(self.kit, self.lab)?);
        wrongs.retain(|wrong| name.is_none_or(|name| wrong.name.contains(name)));
        let files = answers::read_solution(self.kit, self.lab)?;
        let folder = PathBuf::from(format!("solutions/lab{}", self.lab));
        for (path, text) in mutate(self.lab, &files, &wrongs)? {
            copy.put(&folder.join(path), text.as_bytes())?;
        }
        let program = match self.build(copy.cargo(), "solution") {
            Ok(program) => program,
            Err(why) => {
                return Ok(vec![self.row("wrong: all", "caught", 0, vec![why.to_string()])]);
            }
        };
        let tests = program.tests()?;
        let mut runs = Vec::new();
        let mut faults = vec![Vec::new(); wrongs.len()];
        for (index, wrong) in wrongs.iter().enumerate() {
            for test in wrong.fails.iter().chain(&wrong.passes) {
                if tests.contains(test) {
                    runs.push((index, test));
                } else {
                    faults[index].push(format!("there is no test {test}"));
                }
            }
        }
        self.bar.set_length(runs.len() as u64);
        let outcomes = on_all_cores(&runs, |(index, test)| {
            let outcome = program.run(test, &[environment(self.lab, *index)], self.limit);
            self.bar.inc(1);
            outcome
        });
        for ((index, _), outcome) in runs.iter().zip(outcomes) {
            let outcome = outcome?;
            let is_right = wrongs[*index].fails.is_empty();
            faults[*index].extend(if is_right { rejected(&outcome) } else { uncaught(&outcome) });
        }
        let mut rows = Vec::new();
        for (Wrong { name, fails, passes, .. }, faults) in wrongs.iter().zip(faults) {
            rows.push(match passes.len() {
                0 => self.row(&format!("wrong: {name}"), "caught", fails.len(), faults),
                tests => self.row(&format!("right: {name}"), "passes", tests, faults),
            });
        }
        Ok(rows)
    }
}

/// Returns the reason why an unusual right solution was not accepted; `None` if it was.
fn rejected(outcome: &Outcome) -> Option<String> {
    let passed = outcome.verdict == Verdict::Passed;
    (!passed).then(|| format!("{}: {}", outcome.test, first_lines(outcome)))
}

/// Returns the reason why a wrong solution was not caught; `None` if it was.
///
/// A crash or an endless loop proves nothing against the solution, unless the oracle's watchdog
/// reported it.
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
