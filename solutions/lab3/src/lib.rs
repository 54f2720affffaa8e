//! Lab 3, change buffers: the solution. What the lab is about stands in `labs/lab3/README.md`.

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

use common::soft::{NoStatistics, Observer, Simulation};
use common::{Config, Parameter, Reproducibility, Variant};
use crossbeam_utils::CachePadded;
use solution1::Tally;
use solution2::{BIN_SIZE, bin_size};

/// Whether the threads' own data lie on cache lines of their own.
const PADDING: Parameter = Parameter {
    name: "padding",
    about: "1: each thread's data on cache lines of its own; 0: packed side by side",
    default: 1.0,
    range: (0.0, 1.0),
};

/// A thread that comes last in every part of a step: a thread that does not wait for it is found out.
const LATE: Parameter = Parameter {
    name: "late",
    about: "this thread (1, 2, ...) does each part when all others have done theirs; 0: none",
    default: 0.0,
    range: (0.0, 1024.0),
};

/// The programs of this lab.
pub static VARIANTS: &[Variant<dyn Simulation>] = &[
    Variant {
        name: "team",
        about: "threads that live for the whole run, sorted bins, barriers in plain sight",
        reproducibility: Reproducibility::Bitwise,
        parameters: &[bin_size(1.0), LATE],
        build: |config| {
            Ok(if config.statistics {
                Box::new(Team::<Tally>::new(config))
            } else {
                Box::new(Team::<NoStatistics>::new(config))
            })
        },
    },
    Variant {
        name: "parallel-rebin",
        about: "a change buffer per thread; every thread takes the arrivals of its own rows",
        reproducibility: Reproducibility::Bitwise,
        parameters: &[bin_size(2.0), PADDING],
        build: |config| Ok(fork_join(config, Rebinning::ByAll)),
    },
    Variant {
        name: "fork-join",
        about: "a change buffer per thread, emptied by one thread",
        reproducibility: Reproducibility::Bitwise,
        parameters: &[bin_size(2.0), PADDING],
        build: |config| Ok(fork_join(config, Rebinning::ByOne)),
    },
    Variant {
        name: "vanilla",
        about: "all pairs by several threads",
        reproducibility: Reproducibility::Bitwise,
        parameters: &[],
        build: |config| {
            Ok(if config.statistics {
                Box::new(Vanilla::<Tally>::new(config.threads))
            } else {
                Box::new(Vanilla::<NoStatistics>::new(config.threads))
            })
        },
    },
];

fn fork_join(config: &Config, rebinning: Rebinning) -> Box<dyn Simulation> {
    fn with<O: Observer>(config: &Config, rebinning: Rebinning) -> Box<dyn Simulation> {
        let (threads, bins) = (config.threads, config.parameter(BIN_SIZE));
        if config.parameter(PADDING.name) > 0.0 {
            Box::new(ForkJoin::<O, CachePadded<Worker<O>>>::new(threads, bins, rebinning))
        } else {
            Box::new(ForkJoin::<O, Box<Worker<O>>>::new(threads, bins, rebinning))
        }
    }
    if config.statistics {
        with::<Tally>(config, rebinning)
    } else {
        with::<NoStatistics>(config, rebinning)
    }
}
