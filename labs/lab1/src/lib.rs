#![doc = include_str!("../README.md")]

mod all_pairs;
mod energy;
mod force;
mod motion;
mod statistics;

pub use all_pairs::AllPairs;
pub use energy::{WithEnergy, kinetic_energy, momentum, pair_potential, potential_energy};
pub use force::{add_pair, pair_acceleration};
pub use motion::{advance, bounce};
pub use statistics::Tally;

use common::soft::{NoStatistics, Simulation};
use common::{Reproducibility, Variant};

/// The programs of this lab.
pub static VARIANTS: &[Variant<dyn Simulation>] = &[
    Variant {
        name: "all-pairs",
        about: "every particle looks at every other",
        reproducibility: Reproducibility::Bitwise,
        parameters: &[],
        build: |config| {
            Ok(if config.statistics {
                Box::new(AllPairs::<Tally>::default())
            } else {
                Box::new(AllPairs::<NoStatistics>::default())
            })
        },
    },
    Variant {
        name: "statistics",
        about: "the same, and always counts how close particles come",
        reproducibility: Reproducibility::Bitwise,
        parameters: &[],
        build: |_| Ok(Box::new(AllPairs::<Tally>::default())),
    },
    Variant {
        name: "energy",
        about: "the same, and adds up energy and momentum after every step",
        reproducibility: Reproducibility::Bitwise,
        parameters: &[],
        build: |_| Ok(Box::new(WithEnergy::default())),
    },
];
