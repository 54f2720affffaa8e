//! What questions have in common, in tests and in probes.

use std::fs;

/// Gets a question, what the lab answers and what is right.
///
/// A question names nothing that the lab answers: another right answer would make it another question.
pub type Ask<'a> = &'a mut dyn FnMut(&str, Vec<f64>, Vec<f64>);

/// Whole numbers as an answer.
pub fn whole(numbers: impl IntoIterator<Item = usize>) -> Vec<f64> {
    numbers.into_iter().map(|number| number as f64).collect()
}

/// 1 where it is so, 0 where not.
pub fn truth(is: bool) -> f64 {
    f64::from(u8::from(is))
}

/// That for each.
pub fn flags<'a>(all: impl IntoIterator<Item = &'a bool>) -> Vec<f64> {
    all.into_iter().map(|&is| truth(is)).collect()
}

/// The other ranks no further than that from a rank, in an order of its own.
pub fn others_within(furthest: usize, rank: usize, ranks: usize) -> Vec<usize> {
    let others = (1..ranks).map(|k| (rank + k) % ranks);
    others.filter(|other| other.abs_diff(rank) <= furthest).collect()
}

/// How many of the calls that a rank has `made` are none of `calls`: not one, where these do the work.
pub fn no_other_calls(made: &[&str], calls: &[&str], name: &str, ask: Ask<'_>) {
    let others = made.iter().filter(|call| !calls.contains(call)).count();
    let question = format!("{name}: calls of MPI beside {}", calls.join(" and "));
    ask(&question, vec![others as f64], vec![0.0]);
}

/// A number and its two neighbours in floating point.
pub fn beside(number: f64) -> [f64; 3] {
    [number, number.next_down(), number.next_up()]
}

/// What was found; what is right, if they differ by no more than sums of numbers that add up to `scale` may.
pub fn rounded(found: f64, right: f64, scale: f64) -> f64 {
    if (found - right).abs() <= 1e-12 * scale { right } else { found }
}

/// A list as its length and two sums, of its items' numbers by their index and of their ids: lists may be long.
pub fn digest(items: impl IntoIterator<Item = (f64, u64)>) -> Vec<f64> {
    let mut told = vec![0.0; 3];
    for (number, id) in items {
        told[0] += 1.0;
        told[1] += told[0] * number;
        told[2] += id as f64;
    }
    told
}

/// Does what this process holds grow? `run` takes a number of steps, first a few and then four times as many, and each
/// step handles so many `bytes`. In a test: in a process of its own.
pub fn memory(name: &str, (steps, bytes): (u64, usize), mut run: impl FnMut(u64), ask: Ask<'_>) {
    run(steps);
    let before = resident();
    run(4 * steps);
    let (grown, handled) = (resident().saturating_sub(before), 4 * steps * bytes as u64);
    let question = format!(
        "{name}: bytes that are still held after {} steps, which handled {handled}; 0 for less than a quarter",
        4 * steps
    );
    ask(&question, vec![if 4 * grown < handled { 0.0 } else { grown as f64 }], vec![0.0]);
}

/// The bytes of memory that this process has now; 0 where the system does not tell.
fn resident() -> u64 {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"));
    let kibibytes =
        line.and_then(|line| line.trim().strip_suffix("kB")?.trim().parse::<u64>().ok());
    1024 * kibibytes.unwrap_or(0)
}
