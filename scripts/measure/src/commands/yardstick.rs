//! `cargo lab yardstick`: how fast this machine streams particles.

use std::process::ExitCode;

use anyhow::Result;
use clap::Args;
use oracle::yardstick::nanoseconds;

use lab_kit::machine::cores;
use lab_kit::table::{Table, three_digits};

/// Measure how fast this machine can stream particles
///
/// Times a loop that reads and writes x, y, vx and vy of every particle in place and does nothing
/// else. No program that touches every particle in every step can be faster.
#[derive(Args)]
pub struct Options {
    /// Numbers of particles, separated by commas
    #[arg(short, default_value = "1000,10000,100000,1000000", value_name = "N", value_delimiter = ',', value_parser = clap::value_parser!(u32).range(1..))]
    n: Vec<u32>,
    /// How often each is repeated; the shortest counts
    #[arg(long, default_value_t = 5, value_name = "ROUNDS", value_parser = clap::value_parser!(u16).range(1..))]
    rounds: u16,
}

/// Measures and prints.
pub fn run(options: &Options) -> Result<ExitCode> {
    let mut table = Table::new(["n", "ns per particle: one thread", "all cores", "ratio"]);
    for &n in &options.n {
        let best = |threads| {
            let takes = (0..options.rounds).map(|_| nanoseconds(n as usize, threads));
            takes.fold(f64::INFINITY, f64::min)
        };
        let (one, all) = (best(1), best(cores()));
        table.row([
            n.to_string(),
            three_digits(one),
            three_digits(all),
            format!("{:.2}", one / all),
        ]);
    }
    print!("{table}");
    Ok(ExitCode::SUCCESS)
}
