//! The engine as programs that a driver lists and builds.

use common::soft::Simulation;
use common::{BuildError, Config, Parameter, Variant, deterministic, observed};
use neighbour_list::{SHARE, workers};
use solution1::Tally;

use crate::planned::Planned;
use crate::rules::Rules;

/// The programs for a type that decides.
pub trait Programs: Rules + Sized + 'static {
    /// All of them.
    const VARIANTS: &'static [Variant<dyn Simulation>] = &[
        deterministic(
            "planned",
            "reads the scene, decides what to skip, and computes free flight once per window",
            &[WINDOW, SHARE],
            |config| planned::<Self>(config, 1),
        ),
        deterministic(
            "substep",
            "as planned, and particles in contact take several small steps for each official one",
            &[
                WINDOW,
                Parameter {
                    name: "substeps",
                    about: "small steps in an official one",
                    default: 10.0,
                    range: (1.0, 1000.0),
                },
                SHARE,
            ],
            |config| planned::<Self>(config, config.parameter("substeps") as u32),
        ),
    ];
}

impl<R: Rules + 'static> Programs for R {}

const WINDOW: Parameter = Parameter {
    name: "window",
    about: "steps in a window; 0: the planner's choice",
    default: 0.0,
    range: (0.0, 64.0),
};

fn planned<R: Rules + 'static>(
    config: &Config,
    divide: u32,
) -> Result<Box<dyn Simulation>, BuildError> {
    let steps = config.parameter("window") as u32;
    Ok(observed!(config, Tally, |O| Planned::<R, O>::new(workers(config), steps, divide)))
}
