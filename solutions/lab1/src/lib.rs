//! Lab 1, all pairs: the solution. The lab is described in `labs/lab1/README.md`.

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

use common::soft::Simulation;
use common::{Variant, bitwise, observed};

/// The programs of this lab.
pub static VARIANTS: &[Variant<dyn Simulation>] = &[
    bitwise("all-pairs", "every particle looks at every other", &[], |config| {
        Ok(observed!(config, Tally, |O| AllPairs::<O>::default()))
    }),
    bitwise("statistics", "the same, and always counts how close particles come", &[], |_| {
        Ok(Box::new(AllPairs::<Tally>::default()))
    }),
    bitwise("energy", "the same, and adds up energy and momentum after every step", &[], |_| {
        Ok(Box::new(WithEnergy::default()))
    }),
];
