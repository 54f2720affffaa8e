//! Lab 4, locks and owners: what if two threads must write into the same bin?
//!
//! Lab 3 cut the bins among the threads. Here the *particles* are cut, as in the CS267 report, and
//! the bins are shared: a particle of any thread can be in any bin, and may change it for any other.
//! The ways in which bins are kept up to date, from the report's first to those that came after:
//!
//! - *One thread* empties all bins and fills them again, while the others wait.
//! - *Locks.* A thread takes its particle out of the one bin and puts it into the other at the moment
//!   in which it leaves, under the locks of both: one lock for all bins, one for each of many
//!   regions, one for each bin.
//! - *Change buffers.* Changes are noted down, and made when all have moved: by one thread or by all.
//! - *Queues and channels.* A change is handed to the thread that owns the bin.
//! - *Owners.* Every thread looks at all particles and takes what lies in its own bins (CSC367). No
//!   change is handed over; the price is that every thread reads everything. And since a pair of
//!   bins has an owner, every pair can be looked at once.
//!
//! | task | file | what |
//! |------|------|------|
//! | 4.1 | `regions.rs` | make regions and their locks; which region a bin lies in |
//! | 4.2 | `meter.rs` | take a lock, and measure the wait |
//! | 4.3 | `change.rs` | from one bin into another, under two locks |
//! | 4.4 | `change.rs` | move, and change bins at that moment |
//! | 4.5 | `buffers.rs` | one thread empties the bins and fills them again |
//! | 4.6 | `buffers.rs` | change buffers, emptied by one thread and by all |
//! | 4.7 | `queues.rs` | changes in the owners' queues |
//! | 4.8 | `queues.rs` | changes in the owners' channels |
//! | 4.9 | `owners.rs` | an owner takes what is its own |
//! | 4.10 | `two_way.rs` | every pair of a thread's rows once |
//! | 4.11 | `two_way.rs` | the pair across a cut |
//!
//! All variants but `owner-two-way` give the bits of lab 2's `sorted`: particles arrive in their
//! bins in any order, and [`Gather`](solution2::Gather) sums in the order of ids. `owner-two-way`
//! sums pairs where it finds them, so its last digits depend on where the rows are cut.

mod buffers;
mod change;
mod meter;
mod owners;
mod queues;
mod regions;
mod shared_bins;
mod two_way;

pub use buffers::{apply_all, apply_own, rebuild};
pub use change::{Change, change_bin, move_own, remove};
pub use meter::Meter;
pub use owners::{Forces, Owners, claim, take_own};
pub use queues::{post, receive, send, take};
pub use regions::{Bin, Cut, Regions, View};
pub use shared_bins::{SharedBins, Way};
pub use two_way::{add_across, pairs_across, pairs_within};

use common::soft::{NoStatistics, Simulation};
use common::{BuildError, Config, Parameter, Reproducibility, Variant};
use solution1::Tally;
use solution2::{BIN_SIZE, bin_size};

/// How many regions of bins have a lock of their own.
const LOCKS: Parameter = Parameter {
    name: "locks",
    about: "locks for each thread (the CS267 report used 20)",
    default: 20.0,
    range: (1.0, 10_000.0),
};

/// A program of this lab with shared bins.
const fn shared(
    name: &'static str,
    about: &'static str,
    parameters: &'static [Parameter],
    build: fn(&Config) -> Result<Box<dyn Simulation>, BuildError>,
) -> Variant<dyn Simulation> {
    Variant { name, about, reproducibility: Reproducibility::Bitwise, parameters, build }
}

/// The programs of this lab.
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
    // Particles are cut among the threads, bins are shared.
    shared("serial-rebuild", "one thread empties the bins and fills them again", PLAIN, |config| {
        Ok(with(config, Way::Rebuild))
    }),
    shared("global-lock", "a particle changes its bin under one lock", PLAIN, |config| {
        Ok(with(config, Way::Locks(1)))
    }),
    shared("region-locks", "under the locks of the regions of both bins", LOCKED, |config| {
        let locks = config.parameter(LOCKS.name) as usize * config.threads;
        Ok(with(config, Way::Locks(locks)))
    }),
    shared("bin-locks", "under the locks of both bins", PLAIN, |config| {
        Ok(with(config, Way::Locks(usize::MAX)))
    }),
    shared("buffers-by-one", "change buffers, emptied by one thread", PLAIN, |config| {
        Ok(with(config, Way::BuffersByOne))
    }),
    shared("buffers-by-all", "change buffers, emptied by all threads", PLAIN, |config| {
        Ok(with(config, Way::BuffersByAll))
    }),
    shared("queues", "changes are handed over in lock-free queues", PLAIN, |config| {
        Ok(with(config, Way::Queues))
    }),
    shared("channels", "changes are handed over in channels", PLAIN, |config| {
        Ok(with(config, Way::Channels))
    }),
    shared("owners", "every thread empties its bins and claims its particles", PLAIN, |config| {
        Ok(with(config, Way::Owners))
    }),
];

const PLAIN: &[Parameter] = &[bin_size(2.0)];
const LOCKED: &[Parameter] = &[bin_size(2.0), LOCKS];

fn with(config: &Config, way: Way) -> Box<dyn Simulation> {
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
