//! Builds the engine as a program from its parameters.

use common::soft::Simulation;
use common::{BuildError, Config, Parameter, observed};
use neighbour_list::crew;
use solution1::Tally;

use crate::planned::Planned;
use crate::rules::Rules;

pub use neighbour_list::SHARE;

/// The number of steps in a window.
pub const WINDOW: Parameter = Parameter {
    name: "window",
    about: "steps in a window; 0: the planner's choice",
    default: 0.0,
    range: (0.0, 64.0),
};

/// Builds the engine for the parameters [`WINDOW`] and [`SHARE`].
///
/// Each official step is divided into `divide` small steps.
pub fn planned<R: Rules>(config: &Config, divide: u32) -> Result<Box<dyn Simulation>, BuildError> {
    let steps = config.parameter(WINDOW.name) as u32;
    Ok(observed!(config, Tally, |O| Planned::<R, O>::new(crew(config), steps, divide)))
}
