#![doc = include_str!("../README.md")]

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

use common::soft::Simulation;
use common::{Config, Parameter, Reproducibility, Variant, bitwise, observed};
use owner_lists::OwnerLists;
use solution1::Tally;
use solution2::{BIN_SIZE, bin_size};

/// The number of locks for each thread. Each lock guards one region of bins.
const LOCKS: Parameter = Parameter {
    name: "locks",
    about: "locks for each thread (the CS267 report used 20)",
    default: 20.0,
    range: (1.0, 10_000.0),
};

/// The programs of this lab.
pub static VARIANTS: &[Variant<dyn Simulation>] = &[
    Variant {
        name: "owner-two-way",
        about: "every thread takes what lies in its rows; every pair is looked at once",
        reproducibility: Reproducibility::Tolerance,
        parameters: &[bin_size(2.0)],
        build: |config| Ok(owners(config, Forces::TwoWay)),
    },
    bitwise(
        "owner-computes",
        "every thread takes what lies in its rows; nothing is handed over",
        &[bin_size(1.0)],
        |config| Ok(owners(config, Forces::OneWay)),
    ),
    // The particles are divided among the threads, and the bins are shared.
    bitwise(
        "serial-rebuild",
        "one thread empties the bins and fills them again",
        FRESH,
        |config| {
            let fresh = config.parameter("fresh") > 0.0;
            Ok(with(config, Way::Rebuild { fresh }))
        },
    ),
    bitwise("global-lock", "a particle changes its bin under one lock", PLAIN, |config| {
        Ok(with(config, Way::Locks(1)))
    }),
    bitwise("region-locks", "under the locks of the regions of both bins", LOCKED, |config| {
        let locks = config.parameter(LOCKS.name) as usize * config.threads;
        Ok(with(config, Way::Locks(locks)))
    }),
    bitwise("bin-locks", "under the locks of both bins", PLAIN, |config| {
        Ok(with(config, Way::Locks(usize::MAX)))
    }),
    bitwise("buffers-by-one", "change buffers, emptied by one thread", PLAIN, |config| {
        Ok(with(config, Way::BuffersByOne))
    }),
    bitwise("buffers-by-all", "change buffers, emptied by all threads", PLAIN, |config| {
        Ok(with(config, Way::BuffersByAll))
    }),
    bitwise("queues", "changes are handed over in lock-free queues", PLAIN, |config| {
        Ok(with(config, Way::Queues))
    }),
    bitwise("channels", "changes are handed over in channels", PLAIN, |config| {
        Ok(with(config, Way::Channels))
    }),
    bitwise("owners", "every thread empties its bins and claims its particles", PLAIN, |config| {
        Ok(with(config, Way::Owners))
    }),
    Variant {
        name: "owner-lists",
        about: "owners, two ways, in linked lists; particles are moved by their numbers",
        reproducibility: Reproducibility::Tolerance,
        parameters: &[bin_size(1.0), FRESH_NODES],
        build: |config| {
            let (threads, bin_size) = (config.threads, config.parameter(BIN_SIZE));
            let fresh = config.parameter(FRESH_NODES.name) > 0.0;
            Ok(observed!(config, Tally, |O| OwnerLists::<O>::new(threads, bin_size, fresh)))
        },
    },
];

const PLAIN: &[Parameter] = &[bin_size(2.0)];
const LOCKED: &[Parameter] = &[bin_size(2.0), LOCKS];
const FRESH: &[Parameter] = &[
    bin_size(2.0),
    Parameter::switch(
        "fresh",
        "1: bins ask for their memory anew in each step; 0: they keep it",
        false,
    ),
];

const FRESH_NODES: Parameter = Parameter::switch(
    "fresh",
    "1: a node for each particle is made anew in each step; 0: nodes are made once",
    false,
);

fn with(config: &Config, way: Way) -> Box<dyn Simulation> {
    let (threads, bin_size) = (config.threads, config.parameter(BIN_SIZE));
    observed!(config, Tally, |O| SharedBins::<O>::new(threads, bin_size, way))
}

fn owners(config: &Config, forces: Forces) -> Box<dyn Simulation> {
    let (threads, bin_size) = (config.threads, config.parameter(BIN_SIZE));
    observed!(config, Tally, |O| Owners::<O>::new(threads, bin_size, forces))
}
