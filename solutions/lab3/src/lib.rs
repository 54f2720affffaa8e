//! Lab 3, change buffers: several threads, and none writes where another one looks.
//!
//! A step has three parts, and threads are in each other's way differently in each:
//!
//! - *Forces.* Each thread reads all particles and writes the accelerations of its own. Nothing
//!   can go wrong as long as nothing moves.
//! - *Moves.* Each thread moves the particles of its own bins. A particle that leaves its bin would
//!   have to be put into a bin that another thread may be writing. It is not: the thread notes it
//!   down in a list of its own, its *change buffer*.
//! - *Rebinning.* The change buffers are emptied into the bins: first by one thread while the
//!   others wait, then by all, each for the bins of its own rows.
//!
//! Between two parts all threads wait for each other. With OpenMP the ends of parallel loops do
//! that unseen, with rayon the ends of parallel iterators; in the last variant you do it yourself.
//!
//! | task | file | what |
//! |------|------|------|
//! | 3.1 | `vanilla.rs` | all pairs by several threads, the quick win |
//! | 3.2 | `reduction.rs` | one sum by several threads: a lock, atomics, a fixed order |
//! | 3.3 | `rows.rs` | which rows of bins belong to which thread |
//! | 3.4 | `worker.rs` | the forces on a thread's own particles |
//! | 3.5 | `worker.rs` | move them, and note down which left their bins |
//! | 3.6 | `fork_join.rs` | parallel loops over workers |
//! | 3.7 | `fork_join.rs` | rebinning by one thread |
//! | 3.8 | `fork_join.rs` | rebinning by all |
//! | 3.9 | `team.rs` | a team's threads live for the whole run: the mail of a member |
//! | 3.10 | `team.rs` | what a member's thread does, and its barriers |
//! | 3.11 | `team.rs` | start the threads, and wait for their end |
//! | 3.12 | `notice.rs` | a flag that publishes numbers: release and acquire |
//!
//! All variants give the bits of lab 2's `sorted`, with any number of threads: which thread computes
//! a sum does not matter as long as it is summed in the order of ids, and
//! [`Gather`](solution2::Gather) sees to that.

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
