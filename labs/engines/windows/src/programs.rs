//! The engine as programs that a driver lists and builds.

use common::soft::{NoStatistics, Simulation};
use common::{BuildError, Config, Parameter, Reproducibility, Variant};
use neighbour_list::{SHARE, workers};
use solution1::Tally;

use crate::planned::Planned;
use crate::rules::Rules;

/// The programs for a type that decides.
pub trait Programs: Rules + Sized + 'static {
    /// All of them.
    const VARIANTS: &'static [Variant<dyn Simulation>] = &[
        Variant {
            name: "planned",
            about: "reads the scene, decides what to skip, and computes free flight once per window",
            reproducibility: Reproducibility::Deterministic,
            parameters: &[WINDOW, SHARE],
            build: |config| planned::<Self>(config, 1),
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
            build: |config| planned::<Self>(config, config.parameter("substeps") as u32),
        },
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
    Ok(if config.statistics {
        Box::new(Planned::<R, Tally>::new(workers(config), steps, divide))
    } else {
        Box::new(Planned::<R, NoStatistics>::new(workers(config), steps, divide))
    })
}
