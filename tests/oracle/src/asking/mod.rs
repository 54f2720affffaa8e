//! Questions to a lab. A student's tests and the grading use the same questions.
//!
//! A question function draws inputs and passes two closures to its asker: the first computes the
//! lab's answer, and the second judges it. The asker decides which closures are called:
//!
//! | who asks       | the lab answers         | the answer is compared           |
//! |----------------|-------------------------|----------------------------------|
//! | [`InTest`]     | in the test             | at once: a wrong answer panics   |
//! | [`Recorder`]   | in its own program      | never; the grader receives it    |
//! | [`Judge`]      | not at all              | in the grader, which received it |
//!
//! A [`Recorder`] never calls a comparison, so the compiler leaves it out: the program that runs a
//! submission contains no right answer and no model.

mod in_test;
mod judge;
#[cfg(unix)]
mod ranks;
#[cfg(unix)]
mod recorder;
mod wire;

use std::fs;

pub use self::in_test::{InTest, in_test};
pub use self::judge::Judge;
#[cfg(unix)]
pub use self::ranks::itself_on;
#[cfg(unix)]
pub use self::recorder::Recorder;
use crate::right::compare;

/// An asker of questions.
pub trait Ask {
    /// Asks the lab for an answer and has the answer judged. `question` names the inputs and labels
    /// every number of the answer; it must not depend on the answer. `verdict` returns the error in
    /// words.
    fn judge(
        &mut self,
        question: &str,
        found: impl FnOnce() -> Vec<f64>,
        verdict: impl FnOnce(&[f64]) -> Result<(), String>,
    );

    /// Shows a worked example: a table of inputs and of the lab's results, which must equal the
    /// solution's table.
    fn example(&mut self, table: impl FnOnce() -> String);

    /// Executes a part in a separate process, so that its memory or a stack overflow does not
    /// affect other questions.
    fn apart(&mut self, part: impl FnOnce(&mut Self));

    /// Executes a part that only a test can execute, such as starting the lab's own program.
    /// Grading omits it.
    fn in_tests_only(&mut self, part: impl FnOnce());

    /// Puts questions to the ranks of a job, for each number of ranks in turn. Call it at most once
    /// in a question. A rank of a job calls `on_this_rank`. A judge, which has no job, calls
    /// `of_rank` for every rank of every number of ranks. Both functions ask the same questions.
    #[cfg(unix)]
    fn on_ranks(
        &mut self,
        task: &str,
        counts: &[usize],
        on_this_rank: impl FnOnce(&mut Self),
        of_rank: impl FnMut(usize, usize, &mut Self),
    );

    /// Asks for numbers that must be exact.
    fn exact(
        &mut self,
        question: &str,
        found: impl FnOnce() -> Vec<f64>,
        right: impl FnOnce() -> Vec<f64>,
    ) {
        self.judge(question, found, |found| compare(found, &right()));
    }

    /// Asks for numbers that must be correct up to rounding.
    fn near(
        &mut self,
        question: &str,
        found: impl FnOnce() -> Vec<f64>,
        right: impl FnOnce() -> Vec<Near>,
    ) {
        self.judge(question, found, |found| {
            let right = right();
            // A number that is near enough is replaced by the correct number, so that only wrong
            // numbers are shown.
            let found: Vec<f64> = (0..found.len())
                .map(|k| right.get(k).map_or(found[k], |near| near.rounded(found[k])))
                .collect();
            let right: Vec<f64> = right.iter().map(|near| near.right).collect();
            compare(&found, &right)
        });
    }
}

/// A correct number, and the sum of the magnitudes of its terms. The allowed error is 10⁻¹² of this
/// sum.
#[derive(Clone, Copy, Debug)]
pub struct Near {
    /// The correct number.
    pub right: f64,
    /// Sum of the magnitudes of the terms.
    pub scale: f64,
}

impl Near {
    fn rounded(self, found: f64) -> f64 {
        rounded(found, self.right, self.scale)
    }
}

/// Returns integers as an answer.
pub fn integers(numbers: impl IntoIterator<Item = usize>) -> Vec<f64> {
    numbers.into_iter().map(|number| number as f64).collect()
}

/// Returns 1 for true, 0 for false.
pub fn truth(is: bool) -> f64 {
    f64::from(u8::from(is))
}

/// Returns 1 for each true, 0 for each false.
pub fn flags<'a>(all: impl IntoIterator<Item = &'a bool>) -> Vec<f64> {
    all.into_iter().map(|&is| truth(is)).collect()
}

/// Returns the other ranks at a distance of at most `furthest` from `rank`, starting with the next
/// rank.
pub fn others_within(furthest: usize, rank: usize, ranks: usize) -> Vec<usize> {
    let others = (1..ranks).map(|k| (rank + k) % ranks);
    others.filter(|other| other.abs_diff(rank) <= furthest).collect()
}

/// Returns whether an MPI call begins a send that is waited for later.
pub fn begins_send(call: &str) -> bool {
    ["MPI_Isend", "MPI_Issend"].contains(&call)
}

/// Asks how many of the calls that a rank has `made` are not in `calls`. The number must be 0.
pub fn no_other_calls(made: &[&str], calls: &[&str], name: &str, ask: &mut impl Ask) {
    let others = made.iter().filter(|call| !calls.contains(call)).count();
    let question = format!("{name}: number of MPI calls other than {}", calls.join(" and "));
    ask.exact(&question, || vec![others as f64], || vec![0.0]);
}

/// Returns a number and its two floating-point neighbours.
pub fn beside(number: f64) -> [f64; 3] {
    [number, number.next_down(), number.next_up()]
}

/// Returns `right` if `found` differs from it only by rounding of terms with the total magnitude
/// `scale`; otherwise `found`.
pub fn rounded(found: f64, right: f64, scale: f64) -> f64 {
    if (found - right).abs() <= 1e-12 * scale { right } else { found }
}

/// Summarises a long list in three numbers: its length, the sum of its numbers times their
/// positions, and the sum of its ids.
pub fn digest(items: impl IntoIterator<Item = (f64, u64)>) -> Vec<f64> {
    let mut sums = vec![0.0; 3];
    for (number, id) in items {
        sums[0] += 1.0;
        sums[1] += sums[0] * number;
        sums[2] += id as f64;
    }
    sums
}

/// Asks whether the memory of this process grows with its steps. The function calls `run` with
/// `steps` steps and then with four times as many steps; each step handles `bytes` bytes. Ask this
/// question [apart](Ask::apart).
pub fn memory(
    name: &str,
    (steps, bytes): (u64, usize),
    mut run: impl FnMut(u64),
    ask: &mut impl Ask,
) {
    let handled = 4 * steps * bytes as u64;
    let question = format!(
        "{name}: number of bytes by which the memory in use has grown after {} steps, in which the program handled \
         {handled} bytes. 0 if the memory has grown by less than a quarter of the bytes handled",
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

/// Returns this process's current memory in bytes; 0 if the system does not report it.
pub fn resident() -> u64 {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"));
    let kibibytes =
        line.and_then(|line| line.trim().strip_suffix("kB")?.trim().parse::<u64>().ok());
    1024 * kibibytes.unwrap_or(0)
}
