//! Questions as tests: a wrong answer fails immediately.

use super::Ask;
use crate::apart::apart;
#[cfg(unix)]
use crate::mpiexec::on_each;
use crate::panics::name_the_lab;
use crate::watchdog::{is_rank, watched};
use crate::{Question, Random};

/// An asker for tests.
pub struct InTest {
    /// Name of a worked example's snapshot.
    name: String,
    /// Function that compares a table with the snapshot of this name.
    snapshot: fn(&str, &str),
}

/// Beginning of the line with the question, the first line that a test prints.
const ASKS: &str = "asks: ";

/// Beginning of each line of a worked example that a rank prints.
const EXAMPLE: &str = "|example|";

/// Runs the body of a test: one question, under a time limit.
///
/// # Panics
/// If an answer is wrong, the lab's code panics, or the answer takes too long.
pub fn in_test(
    question: &'static Question,
    snapshot: fn(&str, &str),
    ask: fn(&mut Random, &mut InTest),
) {
    name_the_lab();
    println!("{ASKS}{}", question.text);
    let test = question.test();
    watched(&test.clone(), move || {
        let mut random = Random::new(question.seed(0));
        ask(&mut random, &mut InTest { name: test.replace("::", "_"), snapshot });
    });
}

impl Ask for InTest {
    fn judge(
        &mut self,
        question: &str,
        found: impl FnOnce() -> Vec<f64>,
        verdict: impl FnOnce(&[f64]) -> Result<(), String>,
    ) {
        if let Err(words) = verdict(&found()) {
            panic!("{question}\n{words}");
        }
    }

    fn example(&mut self, table: impl FnOnce() -> String) {
        let table = table();
        if is_rank() {
            // A rank only prints the table. The test that started the rank compares the table with
            // the snapshot.
            print!(
                "{}",
                table.lines().map(|line| format!("{EXAMPLE}{line}\n")).collect::<String>()
            );
        } else {
            (self.snapshot)(&self.name, &table);
        }
    }

    fn apart(&mut self, part: impl FnOnce(&mut Self)) {
        apart(|| part(self));
    }

    fn in_tests_only(&mut self, part: impl FnOnce()) {
        part();
    }

    #[cfg(unix)]
    fn on_ranks(
        &mut self,
        task: &str,
        counts: &[usize],
        on_this_rank: impl FnOnce(&mut Self),
        _of_rank: impl FnMut(usize, usize, &mut Self),
    ) {
        let job = on_each(task, counts, || on_this_rank(self));
        let lines = job.stdout.lines().filter_map(|line| line.strip_prefix(EXAMPLE));
        let table: String = lines.map(|line| format!("{line}\n")).collect();
        if !table.is_empty() {
            (self.snapshot)(&self.name, &table);
        }
    }
}
