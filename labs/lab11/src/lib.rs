//! Lab 11, what to skip: an engine that leaves out what a scene does not need.
//!
//! In the official scene nine of ten particles touch no other. All labs before this one move them
//! all the same, one step at a time, and look at the neighbourhood of each. Here a window of
//! several steps is opened: which paths could come near each other within it? All other particles
//! fly freely and are visited once. Particles that could meet form small groups, which are computed on
//! their own from the beginning of the window to its end, while they are in the processor's
//! registers. A force bends a path, so at the end each particle's deviation from its free flight is
//! looked at, and where that could have mattered the groups are joined and computed again.
//!
//! Nothing of it may show in the results. Groups sum their pairs by ascending id, and free flight
//! makes the same additions as step by step: windows have the bits of the naive program.
//!
//! | task | file | what |
//! |------|------|------|
//! | 11.1 | `flight.rs` | free flight, once per window and yet bit by bit |
//! | 11.2 | `flight.rs` | how close two free flights come |
//! | 11.3 | `union_find.rs` | which particles form a group |
//! | 11.4 | `flight.rs` | whether the margin held |
//! | 11.5 | `flight.rs` | which particles meet a wall within a window |
//! | 11.6 | `window_length.rs` | how long a window should be |
//!
//! The rest is the engine of package `windows`, labs/engines/windows: it searches, groups, runs and repairs, and asks the
//! tasks what to do ([`windows::Rules`]); `tasks.rs` hands them over. Its [`windows::Span`] says how long a window
//! is. Particles, cells, kernels and neighbour lists are those of lab 10.

mod flight;
mod tasks;
mod union_find;
mod window_length;

pub use flight::{closest_squared, fly, meets_wall, too_far_off};
pub use tasks::Tasks;
pub use union_find::{join, root};
pub use window_length::{LONGEST, window_length};

use common::soft::{NoStatistics, Simulation};
use common::{BuildError, Config, Parameter, Reproducibility, Variant};
use neighbour_list::{SHARE, workers};
use solution1::Tally;
use windows::Planned;

const WINDOW: Parameter = Parameter {
    name: "window",
    about: "steps in a window; 0: the planner's choice",
    default: 0.0,
    range: (0.0, 64.0),
};

fn planned(config: &Config, divide: u32) -> Result<Box<dyn Simulation>, BuildError> {
    let steps = config.parameter("window") as u32;
    Ok(if config.statistics {
        Box::new(Planned::<Tasks, Tally>::new(workers(config), steps, divide))
    } else {
        Box::new(Planned::<Tasks, NoStatistics>::new(workers(config), steps, divide))
    })
}

/// The programs of this lab.
pub static VARIANTS: &[Variant<dyn Simulation>] = &[
    Variant {
        name: "planned",
        about: "reads the scene, decides what to skip, and computes free flight once per window",
        reproducibility: Reproducibility::Deterministic,
        parameters: &[WINDOW, SHARE],
        build: |config| planned(config, 1),
    },
    Variant {
        name: "substep",
        about: "as planned, and particles in contact take several small steps for each official one",
        reproducibility: Reproducibility::Deterministic,
        parameters: &[
            WINDOW,
            Parameter {
                name: "substeps",
                about: "small steps in an official one",
                default: 10.0,
                range: (1.0, 1000.0),
            },
            SHARE,
        ],
        build: |config| planned(config, config.parameter("substeps") as u32),
    },
];
