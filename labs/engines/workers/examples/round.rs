//! Measures the cost of a round: `cargo run --release -p workers --example round`.
//!
//! In a round without work all threads begin and end. Before each round the caller works alone for
//! some time, and the other threads wait.

use std::thread::available_parallelism;
use std::time::{Duration, Instant};

use common::BuildError;
use workers::Workers;

/// Lengths of the caller's own work before a round, in microseconds.
const ALONE: [u64; 5] = [0, 20, 40, 100, 1000];
/// Number of rounds for each number of threads and each of these times.
const ROUNDS: usize = 2000;

fn main() -> Result<(), BuildError> {
    let cores = available_parallelism().map_or(1, usize::from);
    println!("median time of a round in us, on {cores} cores");
    println!("threads  {}", ALONE.map(|us| format!("{:>10}", format!("wait {us}"))).concat());
    for threads in [2, 4, 8, 16].into_iter().filter(|&threads| threads <= 2 * cores) {
        let workers = Workers::new(threads)?;
        let medians = ALONE.map(|us| median_round(&workers, Duration::from_micros(us)));
        println!("{threads:>7}  {}", medians.map(|us| format!("{us:>10.1}")).concat());
    }
    Ok(())
}

/// Returns the median time of a round in microseconds, if the caller works alone for the time
/// `alone` before each round.
fn median_round(workers: &Workers, alone: Duration) -> f64 {
    let mut times = Vec::with_capacity(ROUNDS);
    for _ in 0..ROUNDS {
        let start = Instant::now();
        while start.elapsed() < alone {}
        let begun = Instant::now();
        workers.on_each(|_| ());
        times.push(begun.elapsed());
    }
    times.sort_unstable();
    times[ROUNDS / 2].as_secs_f64() * 1e6
}
