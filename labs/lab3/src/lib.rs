#![doc = include_str!("../README.md")]

mod barrier;
mod fork_join;
mod notice;
mod pool;
mod reduction;
mod rows;
mod team;
mod vanilla;
mod worker;

pub use barrier::{Barrier, Membership};
pub use common_threads::{Atomic, Memory, Word};
pub use fork_join::{ForkJoin, Rebinning, own_bins, rebin_by_one, sum_and_move, take_arrivals};
pub use notice::Notice;
pub use pool::pool;
pub use reduction::{AtomicStatistics, BLOCK, in_order, under_a_lock, with_atomics};
pub use rows::{own_rows, rows_of_each};
pub use team::{Part, Team, on_threads, take_posted, take_steps};
pub use vanilla::Vanilla;
pub use worker::Worker;

use common::soft::Simulation;
use common::{BuildError, Config, Parameter, Variant, bitwise, observed};
use crossbeam_utils::CachePadded;
use solution1::Tally;
use solution2::{BIN_SIZE, bin_size};

/// Whether each thread's data has its own cache lines.
const PADDING: Parameter = Parameter::switch(
    "padding",
    "1: each thread's data on cache lines of its own; 0: packed side by side",
    true,
);

/// The thread that must finish last in every part of a step. It exposes threads that do not wait
/// for it.
const LATE: Parameter = Parameter {
    name: "late",
    about: "this thread (1, 2, ...) does each part when all others have done theirs; 0: none",
    default: 0.0,
    range: (0.0, 1024.0),
};

/// Checks that the late thread exists.
fn check_late(config: &Config) -> Result<(), BuildError> {
    let (late, threads) = (config.parameter("late"), config.threads);
    if late > threads as f64 || late.fract() != 0.0 {
        return Err(BuildError(format!("late={late}: there is no such thread among {threads}")));
    }
    Ok(())
}

/// The programs of this lab.
pub static VARIANTS: &[Variant<dyn Simulation>] = &[
    bitwise(
        "team",
        "threads that live for the whole run, sorted bins, barriers in plain sight",
        &[bin_size(1.0), LATE],
        |config| {
            check_late(config)?;
            Ok(observed!(config, Tally, |O| Team::<O>::new(config)))
        },
    ),
    bitwise(
        "parallel-rebin",
        "a change buffer per thread; every thread takes the arrivals of its own rows",
        &[bin_size(2.0), PADDING],
        |config| Ok(fork_join(config, Rebinning::ByAll)),
    ),
    bitwise(
        "fork-join",
        "a change buffer per thread, emptied by one thread",
        &[bin_size(2.0), PADDING],
        |config| Ok(fork_join(config, Rebinning::ByOne)),
    ),
    bitwise("vanilla", "all pairs by several threads", &[], |config| {
        Ok(observed!(config, Tally, |O| Vanilla::<O>::new(config.threads)))
    }),
];

fn fork_join(config: &Config, rebinning: Rebinning) -> Box<dyn Simulation> {
    type Padded<O> = ForkJoin<O, CachePadded<Worker<O>>>;
    type Packed<O> = ForkJoin<O, Box<Worker<O>>>;
    let (threads, bins) = (config.threads, config.parameter(BIN_SIZE));
    if config.parameter(PADDING.name) > 0.0 {
        observed!(config, Tally, |O| Padded::<O>::new(threads, bins, rebinning))
    } else {
        observed!(config, Tally, |O| Packed::<O>::new(threads, bins, rebinning))
    }
}
