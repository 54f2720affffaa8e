//! Builds the engines as programs from their parameters.

use common::hard::Simulation;
use common::{BuildError, Config, Parameter};
use workers::Workers;

use crate::broad_phase::BroadPhase;
use crate::cells::Planned;
use crate::choice::Choice;
use crate::engine::{Engine, Step};
use crate::find::Find;
use crate::grid::{Deal, Grid};
use crate::loops::{AllPairs, Collect, Loops};
use crate::parallel_loops::{ParallelLoops, Which};
use crate::threads::Schedule;

/// The number of iterations that a worker takes from a queue together.
pub const CHUNK: Parameter =
    Parameter { name: "chunk", about: "iterations in a chunk", default: 1.0, range: (1.0, 1e9) };

/// The number of discs that a worker takes from the queue of a grid together.
pub const DISC_CHUNK: Parameter =
    Parameter { name: "chunk", about: "discs in a chunk", default: 16.0, range: (1.0, 1e9) };

/// Whether workers take whole blocks of a grid.
pub const WHOLE_BLOCKS: Parameter = Parameter::switch(
    "blocks",
    "1: whole blocks from the queue (as the report has it); 0: discs",
    false,
);

/// The number of windows in a step.
pub const WINDOWS: Parameter = Parameter {
    name: "windows",
    about: "windows in a step; 0 chooses",
    default: 0.0,
    range: (0.0, 65536.0),
};

type Built = Result<Box<dyn Simulation>, BuildError>;

fn engine<C: Step>(finder: impl Find + 'static, choice: Choice, workers: Workers) -> Built {
    Ok(Box::new(Engine::<C, _>::new(finder, choice, workers)))
}

/// Builds an engine that tests all pairs with one thread.
pub fn all_pairs<C: Step>(_: &Config) -> Built {
    engine::<C>(AllPairs::<C>::default(), Choice::Sort, Workers::One)
}

/// Returns the schedule with a queue of iterations. The parameter [`CHUNK`] is the chunk size.
pub fn dynamic(config: &Config) -> Schedule {
    Schedule::Dynamic { chunk: config.parameter(CHUNK.name) as usize }
}

/// Builds an engine that tests all pairs. The threads share the loops that `which` selects.
///
/// If the threads share both loops, `schedule` applies to the outer loop.
///
/// # Errors
/// If the system refuses to start the threads.
pub fn loops<C: Step + ParallelLoops>(config: &Config, which: Which, schedule: Schedule) -> Built {
    built::<C>(config, which, schedule, Collect::Own, Choice::Sort)
}

/// Builds an engine that tests all pairs. The threads take discs from a queue ([`dynamic`]).
///
/// The threads store candidates in the place that `collect` names. `choice` is the way to put the
/// candidates in order.
///
/// # Errors
/// If the system refuses to start the threads.
pub fn collected<C: Step + ParallelLoops>(
    config: &Config,
    collect: Collect,
    choice: Choice,
) -> Built {
    built::<C>(config, Which::Outer, dynamic(config), collect, choice)
}

fn built<C: Step + ParallelLoops>(
    config: &Config,
    which: Which,
    schedule: Schedule,
    collect: Collect,
    choice: Choice,
) -> Built {
    let workers = Workers::new(config.threads)?;
    let loops = Loops::<C>::new(which, schedule, collect, workers.clone());
    engine::<C>(loops, choice, workers)
}

/// Builds an engine with a grid of three levels and one thread.
pub fn grid<C: Step + BroadPhase + ParallelLoops>(_: &Config) -> Built {
    let grid = Grid::<C>::new(Workers::One, Deal::Blocks);
    engine::<C>(grid, Choice::Sort, Workers::One)
}

/// Builds an engine with a grid of three levels. Several threads take work from a queue.
///
/// A thread takes either a chunk of discs, whose size is the parameter [`DISC_CHUNK`], or a whole
/// block, if the parameter [`WHOLE_BLOCKS`] is on.
///
/// # Errors
/// If the system refuses to start the threads.
pub fn grid_parallel<C: Step + BroadPhase + ParallelLoops>(config: &Config) -> Built {
    let workers = Workers::new(config.threads)?;
    let deal = match config.parameter(WHOLE_BLOCKS.name) > 0.0 {
        true => Deal::Blocks,
        false => Deal::Discs(config.parameter(DISC_CHUNK.name) as usize),
    };
    let grid = Grid::<C>::new(workers.clone(), deal);
    engine::<C>(grid, Choice::Sort, workers)
}

/// Builds an engine with sorted occupied cells that searches each step in one window.
///
/// # Errors
/// If the system refuses to start the threads.
pub fn cells<C: Step + BroadPhase>(config: &Config) -> Built {
    in_windows::<C>(config, Some(1))
}

/// Builds an engine with sorted occupied cells. The parameter [`WINDOWS`] is the number of windows.
///
/// # Errors
/// If the system refuses to start the threads.
pub fn planned<C: Step + BroadPhase>(config: &Config) -> Built {
    let windows = config.parameter(WINDOWS.name) as usize;
    in_windows::<C>(config, (windows > 0).then_some(windows))
}

fn in_windows<C: Step + BroadPhase>(config: &Config, windows: Option<usize>) -> Built {
    let workers = Workers::new(config.threads)?;
    let finder = Planned::<C>::new(workers.clone(), windows);
    engine::<C>(finder, Choice::SortTogether, workers)
}
