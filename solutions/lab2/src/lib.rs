//! Lab 2, bins: the solution. What the lab is about stands in `labs/lab2/README.md`.

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

use common::soft::{NoStatistics, Simulation};
use common::{Parameter, Reproducibility, Variant};
use solution1::Tally;

/// The parameter that every variant of this lab has. Its default is what the variant's source used.
pub const fn bin_size(default: f64) -> Parameter {
    Parameter {
        name: BIN_SIZE,
        about: "least side of a bin, in cutoffs",
        default,
        range: (1.0, 3.0),
    }
}

/// Name of the parameter [`bin_size`].
pub const BIN_SIZE: &str = "bin-size";

/// The programs of this lab.
// ANCHOR: variants
pub static VARIANTS: &[Variant<dyn Simulation>] = &[
    Variant {
        name: "sorted",
        about: "bins in one array, by counting sort; the bits of all-pairs",
        reproducibility: Reproducibility::Bitwise,
        parameters: &[bin_size(1.0)],
        build: |config| {
            let bin_size = config.parameter(BIN_SIZE);
            Ok(if config.statistics {
                Box::new(Sorted::<Tally>::new(bin_size))
            } else {
                Box::new(Sorted::<NoStatistics>::new(bin_size))
            })
        },
    },
    // ANCHOR_END: variants
    Variant {
        name: "rebuild",
        about: "a list per bin, cleared and filled again in every step",
        reproducibility: Reproducibility::Deterministic,
        parameters: &[bin_size(2.0)],
        build: |config| {
            let bin_size = config.parameter(BIN_SIZE);
            Ok(if config.statistics {
                Box::new(Rebuild::<Tally>::new(bin_size))
            } else {
                Box::new(Rebuild::<NoStatistics>::new(bin_size))
            })
        },
    },
    Variant {
        name: "incremental",
        about: "a list per bin; only particles that changed their bin are moved",
        reproducibility: Reproducibility::Deterministic,
        parameters: &[bin_size(2.0)],
        build: |config| {
            let bin_size = config.parameter(BIN_SIZE);
            Ok(if config.statistics {
                Box::new(Incremental::<Tally>::new(bin_size))
            } else {
                Box::new(Incremental::<NoStatistics>::new(bin_size))
            })
        },
    },
    Variant {
        name: "linked-list",
        about: "a linked list per bin, reused nodes, every pair looked at once",
        reproducibility: Reproducibility::Deterministic,
        parameters: &[bin_size(1.0)],
        build: |config| {
            let bin_size = config.parameter(BIN_SIZE);
            Ok(if config.statistics {
                Box::new(LinkedList::<Tally>::new(bin_size))
            } else {
                Box::new(LinkedList::<NoStatistics>::new(bin_size))
            })
        },
    },
];
