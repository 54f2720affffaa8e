//! Engines as a driver builds them: each function returns one for the threads and parameters of a configuration.
//!
//! # Errors
//! The system refuses to start the threads.

use common::hard::Simulation;
use common::{BuildError, Config, Parameter, Reproducibility, Variant};

use crate::broad_phase::BroadPhase;
use crate::cells::Planned;
use crate::choice::Choice;
use crate::engine::{Engine, Step};
use crate::find::Find;
use crate::grid::Grid;
use crate::loops::{AllPairs, Collect, Loops};
use crate::parallel_loops::{ParallelLoops, Which};
use crate::threads::{Schedule, Workers};

/// The parameter of [`dynamic`].
pub const CHUNK: &[Parameter] =
    &[Parameter { name: "chunk", about: "iterations in a chunk", default: 1.0, range: (1.0, 1e9) }];

/// The parameter of [`grid_parallel`].
pub const GRID_CHUNK: &[Parameter] =
    &[Parameter { name: "chunk", about: "discs in a chunk", default: 16.0, range: (1.0, 1e9) }];

/// The parameter of [`planned`].
pub const WINDOWS: &[Parameter] = &[Parameter {
    name: "windows",
    about: "windows in a step; 0 chooses",
    default: 0.0,
    range: (0.0, 65536.0),
}];

/// What a driver is given to run, or why it is not.
pub type Built = Result<Box<dyn Simulation>, BuildError>;

/// A program that gives the same bits with any number of threads.
pub const fn variant(
    name: &'static str,
    about: &'static str,
    parameters: &'static [Parameter],
    build: fn(&Config) -> Built,
) -> Variant<dyn Simulation> {
    Variant { name, about, reproducibility: Reproducibility::Bitwise, parameters, build }
}

fn engine<C: Step>(finder: impl Find + 'static, choice: Choice, workers: Workers) -> Built {
    Ok(Box::new(Engine::<C, _>::new(finder, choice, workers)))
}

/// All pairs, by one thread.
pub fn all_pairs<C: Step>(_: &Config) -> Built {
    engine::<C>(AllPairs::<C>::default(), Choice::Sort, Workers::One)
}

/// A queue of iterations, in chunks of the parameter `chunk`.
pub fn dynamic(config: &Config) -> Schedule {
    Schedule::Dynamic { chunk: config.parameter("chunk") as usize }
}

/// All pairs, with `which` loop shared out; of two loops the outer one by `schedule`.
pub fn loops<C: Step + ParallelLoops>(
    which: Which,
    schedule: Schedule,
    collect: Collect,
    choice: Choice,
    config: &Config,
) -> Built {
    let workers = Workers::new(config.threads)?;
    let loops = Loops::<C>::new(which, schedule, collect, workers.clone());
    engine::<C>(loops, choice, workers)
}

/// A grid of three levels, by one thread.
pub fn grid<C: Step + BroadPhase + ParallelLoops>(_: &Config) -> Built {
    let grid = Grid::<C>::new(Workers::One, usize::MAX / 2);
    engine::<C>(grid, Choice::Sort, Workers::One)
}

/// The same, with discs from a queue in chunks of the parameter `chunk`.
pub fn grid_parallel<C: Step + BroadPhase + ParallelLoops>(config: &Config) -> Built {
    let workers = Workers::new(config.threads)?;
    let grid = Grid::<C>::new(workers.clone(), config.parameter("chunk") as usize);
    engine::<C>(grid, Choice::Sort, workers)
}

/// Sorted occupied cells, the step in one window.
pub fn cells<C: Step + BroadPhase>(config: &Config) -> Built {
    in_windows::<C>(Some(1), config)
}

/// Sorted occupied cells, in the number of windows that the parameter `windows` says; 0 chooses.
pub fn planned<C: Step + BroadPhase>(config: &Config) -> Built {
    let windows = config.parameter("windows") as usize;
    in_windows::<C>((windows > 0).then_some(windows), config)
}

fn in_windows<C: Step + BroadPhase>(windows: Option<usize>, config: &Config) -> Built {
    let workers = Workers::new(config.threads)?;
    let finder = Planned::<C>::new(workers.clone(), windows);
    engine::<C>(finder, Choice::SortTogether, workers)
}
