//! Lab 1, all pairs: the simulation as simple as it can be.
//!
//! A step has two halves. First the forces of all particles on each are summed; then every
//! particle moves. With n particles that is n² pairs a step, nearly all of them too far apart to
//! feel each other. The labs after this one are about not looking at these; this one is about
//! getting the physics right, because every later lab is compared with it bit by bit.
//!
//! | task | file | what |
//! |------|------|------|
//! | 1.1 | `force.rs` | the acceleration that one neighbour causes |
//! | 1.2 | `motion.rs` | a particle moves and bounces off the walls |
//! | 1.3 | `all_pairs.rs` | one step of the whole box |
//! | 1.4 | `statistics.rs` | how close the particles come |
//! | 1.5 | `energy.rs` | energy and momentum, the two things that tell if a run can be right |

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
