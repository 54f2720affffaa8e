#![doc = include_str!("../README.md")]

mod gather;
mod grid;
mod incremental;
mod linked_list;
mod rebuild;
mod sorted;
mod sorted_bins;
mod vec_bins;

pub use gather::Gather;
pub use grid::Grid;
pub use incremental::{Incremental, take_leavers};
pub use linked_list::{BinLists, LinkedList, forward};
pub use rebuild::Rebuild;
pub use sorted::Sorted;
pub use sorted_bins::SortedBins;
pub use vec_bins::VecBins;

use common::soft::Simulation;
use common::{Parameter, Variant, bitwise, deterministic, observed};
use solution1::Tally;

/// Returns the parameter of every variant of this lab: the least side of a bin.
///
/// `default` is the value in the program that the variant reproduces.
pub const fn bin_size(default: f64) -> Parameter {
    Parameter {
        name: BIN_SIZE,
        about: "least side of a bin, in cutoffs",
        default,
        range: (1.0, 3.0),
    }
}

/// The name of the parameter [`bin_size`].
pub const BIN_SIZE: &str = "bin-size";

/// The programs of this lab.
pub static VARIANTS: &[Variant<dyn Simulation>] = &[
    bitwise(
        "sorted",
        "bins in one array, by counting sort; the bits of all-pairs",
        &[bin_size(1.0)],
        |config| {
            let bin_size = config.parameter(BIN_SIZE);
            Ok(observed!(config, Tally, |O| Sorted::<O>::new(bin_size)))
        },
    ),
    deterministic(
        "rebuild",
        "a list per bin, cleared and filled again in every step",
        &[bin_size(2.0)],
        |config| {
            let bin_size = config.parameter(BIN_SIZE);
            Ok(observed!(config, Tally, |O| Rebuild::<O>::new(bin_size)))
        },
    ),
    deterministic(
        "incremental",
        "a list per bin; only particles that changed their bin are moved",
        &[bin_size(2.0)],
        |config| {
            let bin_size = config.parameter(BIN_SIZE);
            Ok(observed!(config, Tally, |O| Incremental::<O>::new(bin_size)))
        },
    ),
    deterministic(
        "linked-list",
        "a linked list per bin, reused nodes, every pair looked at once",
        &[bin_size(1.0)],
        |config| {
            let bin_size = config.parameter(BIN_SIZE);
            Ok(observed!(config, Tally, |O| LinkedList::<O>::new(bin_size)))
        },
    ),
];
