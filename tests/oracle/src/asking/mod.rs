//! Asking a lab: one source of questions for a student's tests and for grading.
//!
//! A question function draws inputs, has the lab answer them, and knows what is right. It does the
//! last two in closures, and who asks decides which of the closures are called:
//!
//! | who asks       | the lab answers         | the answer is compared           |
//! |----------------|-------------------------|----------------------------------|
//! | [`InTest`]     | in the test             | at once: a wrong answer panics   |
//! | [`Recorder`]   | in a submission's program, into a file | never             |
//! | [`Judge`]      | not at all              | as the file has it, by the grader |
//!
//! A [`Recorder`] never calls a comparison, so the compiler leaves it out: the program that runs a
//! submission contains no right answer and no model.

mod in_test;
mod judge;
#[cfg(unix)]
mod ranks;
mod recorder;
mod wire;

use std::fs;

pub use self::in_test::{InTest, in_test};
pub use self::judge::Judge;
#[cfg(unix)]
pub use self::ranks::itself_on;
pub use self::recorder::Recorder;
use crate::right::compare;

/// Who asks.
pub trait Ask {
    /// Has the lab answer, and has the answer judged. `question` names the inputs and labels every
    /// number of the answer; it says nothing that depends on the answer. `verdict` returns what is
    /// wrong, in words.
    fn judge(
        &mut self,
        question: &str,
        found: impl FnOnce() -> Vec<f64>,
        verdict: impl FnOnce(&[f64]) -> Result<(), String>,
    );

    /// Shows a worked example: a table of inputs and of what the lab makes of them, which must be
    /// the solution's.
    fn example(&mut self, table: impl FnOnce() -> String);

    /// Does a part in a process of its own: what it holds, or a stack that overflows, concerns no
    /// other question.
    fn apart(&mut self, part: impl FnOnce(&mut Self));

    /// Does what only a test can do, such as starting the lab's own program. Grading leaves it out.
    fn in_tests_only(&mut self, part: impl FnOnce());

    /// Has the ranks of a job answer, for each number of ranks in turn; at most once in a question.
    /// A rank of a job calls `on_this_rank`. Who compares without a job calls `of_rank` for each rank
    /// and number of ranks; both ask the same questions.
    #[cfg(unix)]
    fn on_ranks(
        &mut self,
        task: &str,
        counts: &[usize],
        on_this_rank: impl FnOnce(&mut Self),
        of_rank: impl FnMut(usize, usize, &mut Self),
    );

    /// Asks for exactly the right numbers.
    fn exact(
        &mut self,
        question: &str,
        found: impl FnOnce() -> Vec<f64>,
        right: impl FnOnce() -> Vec<f64>,
    ) {
        self.judge(question, found, |found| compare(found, &right()));
    }

    /// Asks for the right numbers up to rounding.
    fn near(
        &mut self,
        question: &str,
        found: impl FnOnce() -> Vec<f64>,
        right: impl FnOnce() -> Vec<Near>,
    ) {
        self.judge(question, found, |found| {
            let right = right();
            // A number that is near enough counts as the right one, so that only wrong ones are shown.
            let found: Vec<f64> = (0..found.len())
                .map(|k| right.get(k).map_or(found[k], |near| near.rounded(found[k])))
                .collect();
            let right: Vec<f64> = right.iter().map(|near| near.right).collect();
            compare(&found, &right)
        });
    }
}

/// A right number, and the sum of the magnitudes that add up to it: rounding may be off by 10⁻¹² of that.
#[derive(Clone, Copy, Debug)]
pub struct Near {
    /// The number.
    pub right: f64,
    /// The sum of the magnitudes of what was added.
    pub scale: f64,
}

impl Near {
    fn rounded(self, found: f64) -> f64 {
        rounded(found, self.right, self.scale)
    }
}

/// Whole numbers as an answer.
pub fn whole(numbers: impl IntoIterator<Item = usize>) -> Vec<f64> {
    numbers.into_iter().map(|number| number as f64).collect()
}

/// 1 for true, 0 for false.
pub fn truth(is: bool) -> f64 {
    f64::from(u8::from(is))
}

/// 1 for each true, 0 for each false.
pub fn flags<'a>(all: impl IntoIterator<Item = &'a bool>) -> Vec<f64> {
    all.into_iter().map(|&is| truth(is)).collect()
}

/// The other ranks that are at most `furthest` from `rank`, beginning with the next one.
pub fn others_within(furthest: usize, rank: usize, ranks: usize) -> Vec<usize> {
    let others = (1..ranks).map(|k| (rank + k) % ranks);
    others.filter(|other| other.abs_diff(rank) <= furthest).collect()
}

/// Whether a call of MPI begins to send a message that is waited for later.
pub fn begins_send(call: &str) -> bool {
    ["MPI_Isend", "MPI_Issend"].contains(&call)
}

/// Asks how many of the calls that a rank has `made` are none of `calls`: there must be none, where
/// these do the work.
pub fn no_other_calls(made: &[&str], calls: &[&str], name: &str, ask: &mut impl Ask) {
    let others = made.iter().filter(|call| !calls.contains(call)).count();
    let question = format!("{name}: calls of MPI beside {}", calls.join(" and "));
    ask.exact(&question, || vec![others as f64], || vec![0.0]);
}

/// A number and its two neighbours in floating point.
pub fn beside(number: f64) -> [f64; 3] {
    [number, number.next_down(), number.next_up()]
}

/// `right` if `found` differs from it by no more than rounding, where magnitudes of `scale` are
/// added up; else `found`.
pub fn rounded(found: f64, right: f64, scale: f64) -> f64 {
    if (found - right).abs() <= 1e-12 * scale { right } else { found }
}

/// A long list as three numbers: its length, the sum of its numbers times their places, and the sum
/// of its ids.
pub fn digest(items: impl IntoIterator<Item = (f64, u64)>) -> Vec<f64> {
    let mut sums = vec![0.0; 3];
    for (number, id) in items {
        sums[0] += 1.0;
        sums[1] += sums[0] * number;
        sums[2] += id as f64;
    }
    sums
}

/// Asks whether the memory that this process holds grows with its steps. `run` takes a number of
/// steps, first `steps` and then four times as many; each step handles so many `bytes`. To be asked
/// [apart](Ask::apart).
pub fn memory(
    name: &str,
    (steps, bytes): (u64, usize),
    mut run: impl FnMut(u64),
    ask: &mut impl Ask,
) {
    let handled = 4 * steps * bytes as u64;
    let question = format!(
        "{name}: bytes that are still held after {} steps, which handled {handled}; 0 for less than a quarter",
        4 * steps
    );
    let found = || {
        run(steps);
        let before = resident();
        run(4 * steps);
        let grown = resident().saturating_sub(before);
        vec![if 4 * grown < handled { 0.0 } else { grown as f64 }]
    };
    ask.exact(&question, found, || vec![0.0]);
}

/// The bytes of memory that this process has now; 0 where the system does not say.
pub fn resident() -> u64 {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"));
    let kibibytes =
        line.and_then(|line| line.trim().strip_suffix("kB")?.trim().parse::<u64>().ok());
    1024 * kibibytes.unwrap_or(0)
}
