//! Lab 4, locks and owners: what if two threads must write into the same bin?
//!
//! Lab 3 avoided the question with change buffers. Here are the other answers, in the order in
//! which the CS267 report tried them, and two that came after:
//!
//! - *One thread.* It clears all bins and fills them again, while the others wait.
//! - *One lock.* Whoever puts a particle into a bin must hold it.
//! - *Many locks.* Each guards a region of bins; two threads seldom want the same one.
//! - *Queues.* Nobody waits: a particle goes into the lock-free queue of the thread that owns its
//!   bin.
//! - *Owners.* Every thread looks at all particles and takes those that lie in its own rows
//!   (CSC367). Nothing is handed over at all; the price is that everybody reads everything. And
//!   since the owner of a pair of bins is known, every pair can be looked at once.
//!
//! | task | file | what |
//! |------|------|------|
//! | 4.1 | `rebin.rs` | one thread clears and fills again |
//! | 4.2 | `regions.rs` | which region a bin lies in |
//! | 4.3 | `meter.rs` | take a lock, and measure the wait |
//! | 4.4 | `rebin.rs` | put the leavers into their bins, under locks |
//! | 4.5 | `rebin.rs` | hand them over in queues |
//! | 4.6 | `owners.rs` | an owner takes what lies in its rows |
//! | 4.7 | `two_way.rs` | every pair of a thread's rows once |
//! | 4.8 | `two_way.rs` | the pair across a cut |
//!
//! All variants but `owner-two-way` give the bits of lab 2's `sorted`: particles arrive in their
//! bins in any order, and [`Gather`](solution2::Gather) sums in the order of ids. `owner-two-way`
//! sums pairs where it finds them, so its last digits depend on where the rows are cut.

mod meter;
mod owners;
mod rebin;
mod regions;
mod shared_bins;
mod two_way;

pub use meter::Meter;
pub use owners::{Forces, Owners, take_own};
pub use rebin::{post, put_all, rebuild, take};
pub use regions::Regions;
pub use shared_bins::{SharedBins, Way};
pub use two_way::{add_across, pairs_across, pairs_within};

use common::soft::{NoStatistics, Simulation};
use common::{Config, Parameter, Reproducibility, Variant};
use solution1::Tally;
use solution2::{BIN_SIZE, bin_size};

/// How many regions of bins have a lock of their own.
const LOCKS: Parameter = Parameter {
    name: "locks",
    about: "locks for each thread (the CS267 report used 20)",
    default: 20.0,
    range: (1.0, 10_000.0),
};

/// The programs of this lab.
// ANCHOR: variants
pub static VARIANTS: &[Variant<dyn Simulation>] = &[
    Variant {
        name: "owner-two-way",
        about: "every thread takes what lies in its rows; every pair is looked at once",
        reproducibility: Reproducibility::Tolerance,
        parameters: &[bin_size(2.0)],
        build: |config| Ok(owners(config, Forces::TwoWay)),
    },
    Variant {
        name: "owner-computes",
        about: "every thread takes what lies in its rows; nothing is handed over",
        reproducibility: Reproducibility::Bitwise,
        parameters: &[bin_size(1.0)],
        build: |config| Ok(owners(config, Forces::OneWay)),
    },
    Variant {
        name: "serial-rebuild",
        about: "one thread clears the bins and fills them again",
        reproducibility: Reproducibility::Bitwise,
        parameters: &[bin_size(2.0)],
        build: |config| Ok(shared(config, Way::Rebuild)),
    },
    Variant {
        name: "global-lock",
        about: "all threads put particles into bins, under one lock",
        reproducibility: Reproducibility::Bitwise,
        parameters: &[bin_size(2.0)],
        build: |config| Ok(shared(config, Way::Locks(1))),
    },
    Variant {
        name: "region-locks",
        about: "the same under many locks, each for a region of bins",
        reproducibility: Reproducibility::Bitwise,
        parameters: &[bin_size(2.0), LOCKS],
        build: |config| {
            let locks = config.parameter(LOCKS.name) as usize * config.threads;
            Ok(shared(config, Way::Locks(locks)))
        },
    },
    Variant {
        name: "queues",
        about: "particles are handed to the owner of their bin in lock-free queues",
        reproducibility: Reproducibility::Bitwise,
        parameters: &[bin_size(2.0)],
        build: |config| Ok(shared(config, Way::Queues)),
    },
];
// ANCHOR_END: variants

fn shared(config: &Config, way: Way) -> Box<dyn Simulation> {
    let (threads, bin_size) = (config.threads, config.parameter(BIN_SIZE));
    if config.statistics {
        Box::new(SharedBins::<Tally>::new(threads, bin_size, way))
    } else {
        Box::new(SharedBins::<NoStatistics>::new(threads, bin_size, way))
    }
}

fn owners(config: &Config, forces: Forces) -> Box<dyn Simulation> {
    let (threads, bin_size) = (config.threads, config.parameter(BIN_SIZE));
    if config.statistics {
        Box::new(Owners::<Tally>::new(threads, bin_size, forces))
    } else {
        Box::new(Owners::<NoStatistics>::new(threads, bin_size, forces))
    }
}
