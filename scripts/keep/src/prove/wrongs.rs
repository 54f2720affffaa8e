//! The known-wrong solutions: does every one fail where it must?

use std::path::PathBuf;

use anyhow::Result;

use super::Bench;
use super::copy::Copy;
use super::mutate::{environment, mutate};
use super::report::Row;
use lab_kit::answers;
use lab_kit::harness::{Outcome, Verdict};
use lab_kit::machine::on_all_cores;
use lab_kit::wrong;

impl Bench<'_> {
    /// Proves the wrong solutions whose name contains `name`.
    pub(super) fn wrongs(&self, copy: &Copy, name: Option<&str>) -> Result<Vec<Row>> {
        self.begin("wrong solutions must be caught");
        let mut wrongs = wrong::read(self.kit, self.lab)?;
        wrongs.retain(|wrong| name.is_none_or(|name| wrong.name.contains(name)));
        let files = answers::read_solution(self.kit, self.lab)?;
        let folder = PathBuf::from(format!("solutions/lab{}", self.lab));
        for (path, text) in mutate(self.lab, &files, &wrongs)? {
            copy.put(&folder.join(path), text.as_bytes())?;
        }
        let row =
            |name, tests, faults| self.row(&format!("wrong: {name}"), "caught", tests, faults);
        let program = match self.build(copy.cargo(), &format!("solution{}", self.lab)) {
            Ok(program) => program,
            Err(why) => return Ok(vec![row("all", 0, vec![why.to_string()])]),
        };
        let tests = program.tests()?;
        let (mut runs, mut faults) = (Vec::new(), vec![Vec::new(); wrongs.len()]);
        for (index, wrong) in wrongs.iter().enumerate() {
            let unknown = wrong.fails.iter().filter(|test| !tests.contains(test));
            let unknown: Vec<_> = unknown.map(|test| format!("there is no test {test}")).collect();
            faults[index].extend(unknown);
            if faults[index].is_empty() {
                runs.extend(wrong.fails.iter().map(|test| (index, test)));
            }
        }
        self.bar.set_length(runs.len() as u64);
        let outcomes = on_all_cores(&runs, |(index, test)| {
            let outcome = program.run(test, &[environment(self.lab, *index)], self.limit);
            self.bar.inc(1);
            outcome
        });
        for ((index, _), outcome) in runs.iter().zip(outcomes) {
            faults[*index].extend(uncaught(&outcome?));
        }
        let rows = wrongs.iter().zip(faults);
        Ok(rows.map(|(wrong, faults)| row(&wrong.name, wrong.fails.len(), faults)).collect())
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
