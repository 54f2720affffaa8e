//! Lab 11, adaptive windows: the solution. The lab is described in `labs/lab11/README.md`.

mod flight;
mod tasks;
mod union_find;
mod window_length;

pub use flight::{closest_squared, fly, meets_wall, too_far_off};
pub use tasks::Tasks;
pub use union_find::{join, root};
pub use window_length::{LONGEST, window_length};

use common::soft::Simulation;
use common::{Parameter, Variant, deterministic};
use windows::programs::{SHARE, WINDOW, planned};

const SUBSTEPS: Parameter = Parameter {
    name: "substeps",
    about: "small steps in an official one",
    default: 10.0,
    range: (1.0, 1000.0),
};

/// The programs of this lab.
pub static VARIANTS: &[Variant<dyn Simulation>] = &[
    deterministic(
        "planned",
        "reads the scene, decides what to skip, and computes free flight once per window",
        &[WINDOW, SHARE],
        |config| planned::<Tasks>(config, 1),
    ),
    deterministic(
        "substep",
        "as planned, and particles in contact take several small steps for each official one",
        &[WINDOW, SUBSTEPS, SHARE],
        |config| planned::<Tasks>(config, config.parameter(SUBSTEPS.name) as u32),
    ),
];
