//! Lab 2, bins: look only where a neighbour can be.
//!
//! A particle feels nothing beyond the cutoff c. Cut the box into square bins with sides of at
//! least c, and all its neighbours are in its own bin or in one of the eight around it. The density
//! of the box is fixed, so a bin of side c holds 0.2 particles however many there are in all: the
//! work of a step grows with n and no longer with n².
//!
//! The rest of the lab is about keeping the bins up to date, four times over. The four programs
//! look at much the same pairs; they differ in where the particles lie in memory.
//!
//! | task | file | what |
//! |------|------|------|
//! | 2.1 | `grid.rs` | how many bins, and which one a point lies in |
//! | 2.2 | `grid.rs` | which rows and columns adjoin |
//! | 2.3 | `vec_bins.rs` | clear the bins and fill them again |
//! | 2.4 | `vec_bins.rs` | the force on a particle from nine bins |
//! | 2.5 | `incremental.rs` | move only what changed its bin, by swap-remove |
//! | 2.6 | `linked_list.rs` | bins without memory of their own |
//! | 2.7 | `linked_list.rs` | every pair once: five bins instead of nine |
//! | 2.8 | `sorted_bins.rs` | counting sort: all bins in one array |
//! | 2.9 | `gather.rs` | neighbours summed in the order of their ids |
//!
//! How far the variants are reproducible. All of them find the same pairs and compute the same forces up to
//! rounding. A sum of floating-point numbers depends on its order, though, and bins hold their
//! particles in an order that has to do with where they have been. Only [`Sorted`] puts the
//! neighbours back in order before it adds them up: it gives the bits of lab 1's all-pairs on any
//! scene ([`Reproducibility::Bitwise`]). The rest give the same bits in every run, but bits of their
//! own ([`Reproducibility::Deterministic`]).

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
