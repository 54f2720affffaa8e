#![doc = include_str!("../README.md")]

mod alone;
mod collect;
mod drift;
mod engine;
mod filter;
mod skin;
mod tasks;

pub use alone::{ALONE, drift_alone, filter_alone};
pub use collect::collect;
pub use drift::drift;
pub use engine::{Engine, List};
pub use filter::filter;
pub use skin::{best_skin, expired};
pub use tasks::Tasks;

use common::soft::{NoStatistics, Simulation};
use common::{BuildError, Config, Parameter, Reproducibility, Variant};
use neighbour_list_core::{Programs, SKIN};
use solution1::Tally;

const INNER: Parameter = Parameter {
    name: "inner",
    about: "1: with an inner list, 0: without",
    default: 1.0,
    range: (0.0, 1.0),
};

fn serial_list(config: &Config) -> Result<Box<dyn Simulation>, BuildError> {
    let (skin, inner) = (config.parameter("skin"), config.parameter("inner") > 0.0);
    Ok(if config.statistics {
        Box::new(Engine::<Tally>::new(skin, inner))
    } else {
        Box::new(Engine::<NoStatistics>::new(skin, inner))
    })
}

/// The programs of this lab.
pub static VARIANTS: &[Variant<dyn Simulation>] = &[
    Variant {
        name: "serial-list",
        about: "the loop of this lab: sorted cells, a neighbour list and an inner one, one thread",
        reproducibility: Reproducibility::Deterministic,
        parameters: &[SKIN, INNER],
        build: serial_list,
    },
    Tasks::NEIGHBOUR_LIST,
];
