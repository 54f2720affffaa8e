#![doc = include_str!("../README.md")]

mod alone;
mod collect;
mod drift;
mod engine;
mod filter;
mod skin;

pub use alone::{ALONE, drift_alone, filter_alone};
pub use collect::collect;
pub use drift::drift;
pub use engine::{Engine, List};
pub use filter::filter;
pub use skin::{best_skin, expired};

use std::ops::Range;

use common::soft::Simulation;
use common::{BuildError, Config, Parameter, Variant, deterministic, observed};
use neighbour_list_core::kernels::{Pair, Positions, ROOM, Signs};
use neighbour_list_core::{DIVIDE, NeighbourList, Primitives, SHARE, SKIN, TIMING, crew};
use solution1::Tally;

const INNER: Parameter = Parameter::switch("inner", "1: with an inner list, 0: without", true);

fn serial_list(config: &Config) -> Result<Box<dyn Simulation>, BuildError> {
    let skin = config.parameter(SKIN.name);
    let inner = config.parameter(INNER.name) > 0.0;
    Ok(observed!(config, Tally, |O| Engine::<O>::new(skin, inner)))
}

fn neighbour_list(config: &Config) -> Result<Box<dyn Simulation>, BuildError> {
    let skin = config.parameter(SKIN.name);
    let divide = config.parameter(DIVIDE.name) as u32;
    let timing = config.parameter(TIMING.name) > 0.0;
    Ok(observed!(config, Tally, |O| {
        NeighbourList::<O, Tasks>::new(crew(config), skin, divide).timed(timing)
    }))
}

/// The programs of this lab.
pub static VARIANTS: &[Variant<dyn Simulation>] = &[
    deterministic(
        "serial-list",
        "the loop of this lab: sorted cells, a neighbour list and an inner one, one thread",
        &[SKIN, INNER],
        serial_list,
    ),
    deterministic(
        "neighbour-list",
        "the library's engine: that loop with threads, and with particles too fast for a list",
        &[SKIN, DIVIDE, SHARE, TIMING],
        neighbour_list,
    ),
];

/// The functions of tasks 10.1 to 10.4, in the form that the library's engine takes.
#[derive(Clone, Copy, Debug, Default)]
pub struct Tasks;

impl Primitives for Tasks {
    #[inline(always)]
    fn drift(x: &mut [f64], v: &mut [f64], a: &[f64], dt: f64, size: f64) -> bool {
        drift(x, v, a, dt, size)
    }

    #[inline(always)]
    fn collect(
        list: &mut [Pair],
        len: usize,
        positions: Positions<'_>,
        i: usize,
        range: Range<usize>,
        reach: f64,
        signs: impl Signs,
    ) -> usize {
        collect(list, len, positions, i, range, reach, signs)
    }

    #[inline(always)]
    fn filter(
        pairs: &[Pair],
        positions: Positions<'_>,
        squared: f64,
        near: &mut [Pair; ROOM],
    ) -> usize {
        filter(pairs, positions, squared, near)
    }

    fn expired(displacement: f64, skin: f64) -> bool {
        expired(displacement, skin)
    }

    fn best_skin(density: f64, displacement: f64) -> f64 {
        best_skin(density, displacement)
    }
}
