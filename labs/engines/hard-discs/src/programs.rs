//! The engines as programs that a driver lists and builds.

use common::hard::Simulation;
use common::{BuildError, Config, Parameter, Variant, bitwise};

use crate::broad_phase::BroadPhase;
use crate::cells::Planned;
use crate::choice::Choice;
use crate::engine::{Engine, Step};
use crate::find::Find;
use crate::grid::{Deal, Grid};
use crate::loops::{AllPairs, Collect, Loops};
use crate::parallel_loops::{ParallelLoops, Which};
use crate::threads::{Schedule, Workers};

/// The programs for a type that answers all that the library asks.
pub trait Programs: Step + BroadPhase + ParallelLoops {
    /// All of them. They give the same bits on any scene.
    const VARIANTS: &'static [Variant<dyn Simulation>] = &[
        bitwise("sequential", "all pairs, one thread", &[], all_pairs::<Self>),
        bitwise("outer-static", "outer loop in fixed parts (the report's p1)", &[], |config| {
            all_loops::<Self>(Which::Outer, Schedule::Static, config)
        }),
        bitwise("outer-dynamic", "outer loop from a queue (the report's p1d)", CHUNK, |config| {
            all_loops::<Self>(Which::Outer, dynamic(config), config)
        }),
        bitwise("inner-static", "inner loop in fixed parts (the report's p2)", &[], |config| {
            all_loops::<Self>(Which::Inner, Schedule::Static, config)
        }),
        bitwise("inner-dynamic", "inner loop from a queue (the report's p2d)", CHUNK, |config| {
            all_loops::<Self>(Which::Inner, dynamic(config), config)
        }),
        bitwise(
            "nested-mixed",
            "outer loop from a queue, inner ones in fixed parts by fresh teams (the report's p3)",
            CHUNK,
            |config| all_loops::<Self>(Which::Nested, dynamic(config), config),
        ),
        bitwise(
            "shared-locked",
            "as outer-dynamic; candidates in one array, counted under a lock (as the report has it)",
            CHUNK,
            |config| collected::<Self>(Collect::Locked, Choice::Sort, config),
        ),
        bitwise("shared-atomic", "the same, counted by fetch_add", CHUNK, |config| {
            collected::<Self>(Collect::Atomic, Choice::Sort, config)
        }),
        bitwise(
            "merge-sort",
            "as outer-dynamic; lists are sorted in parallel and merged",
            CHUNK,
            |config| collected::<Self>(Collect::Own, Choice::Merge, config),
        ),
        bitwise(
            "grid",
            "the report's grid of 4 x 4, 2 x 2 and 1 blocks, one thread",
            &[],
            grid::<Self>,
        ),
        bitwise(
            "grid-parallel",
            "the same, discs or blocks from a queue",
            GRID,
            grid_parallel::<Self>,
        ),
        bitwise("cells", "sorted occupied cells, the step in one window", &[], cells::<Self>),
        bitwise(
            "planned",
            "the same, windows of time as the scene needs",
            WINDOWS,
            planned::<Self>,
        ),
    ];
}

impl<C: Step + BroadPhase + ParallelLoops> Programs for C {}

/// The parameter of [`dynamic`].
const CHUNK: &[Parameter] =
    &[Parameter { name: "chunk", about: "iterations in a chunk", default: 1.0, range: (1.0, 1e9) }];

/// The parameters of [`grid_parallel`].
const GRID: &[Parameter] = &[
    Parameter { name: "chunk", about: "discs in a chunk", default: 16.0, range: (1.0, 1e9) },
    Parameter::switch(
        "blocks",
        "1: whole blocks from the queue (as the report has it); 0: discs",
        false,
    ),
];

/// The parameter of [`planned`].
const WINDOWS: &[Parameter] = &[Parameter {
    name: "windows",
    about: "windows in a step; 0 chooses",
    default: 0.0,
    range: (0.0, 65536.0),
}];

type Built = Result<Box<dyn Simulation>, BuildError>;

fn engine<C: Step>(finder: impl Find + 'static, choice: Choice, workers: Workers) -> Built {
    Ok(Box::new(Engine::<C, _>::new(finder, choice, workers)))
}

/// All pairs, by one thread.
fn all_pairs<C: Step>(_: &Config) -> Built {
    engine::<C>(AllPairs::<C>::default(), Choice::Sort, Workers::One)
}

/// A queue of iterations, in chunks of the parameter `chunk`.
fn dynamic(config: &Config) -> Schedule {
    Schedule::Dynamic { chunk: config.parameter("chunk") as usize }
}

/// All pairs, with `which` loop shared out; of two loops the outer one by `schedule`.
fn all_loops<C: Step + ParallelLoops>(which: Which, schedule: Schedule, config: &Config) -> Built {
    loops::<C>(which, schedule, Collect::Own, Choice::Sort, config)
}

/// All pairs, with discs from a queue, whose candidates are collected and sorted in these ways.
fn collected<C: Step + ParallelLoops>(collect: Collect, choice: Choice, config: &Config) -> Built {
    loops::<C>(Which::Outer, dynamic(config), collect, choice, config)
}

fn loops<C: Step + ParallelLoops>(
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
fn grid<C: Step + BroadPhase + ParallelLoops>(_: &Config) -> Built {
    let grid = Grid::<C>::new(Workers::One, Deal::Blocks);
    engine::<C>(grid, Choice::Sort, Workers::One)
}

/// The same from a queue: discs in chunks of the parameter `chunk`, or whole blocks.
fn grid_parallel<C: Step + BroadPhase + ParallelLoops>(config: &Config) -> Built {
    let workers = Workers::new(config.threads)?;
    let deal = match config.parameter("blocks") > 0.0 {
        true => Deal::Blocks,
        false => Deal::Discs(config.parameter("chunk") as usize),
    };
    let grid = Grid::<C>::new(workers.clone(), deal);
    engine::<C>(grid, Choice::Sort, workers)
}

/// Sorted occupied cells, the step in one window.
fn cells<C: Step + BroadPhase>(config: &Config) -> Built {
    in_windows::<C>(Some(1), config)
}

/// Sorted occupied cells, in the number of windows that the parameter `windows` says; 0 chooses.
fn planned<C: Step + BroadPhase>(config: &Config) -> Built {
    let windows = config.parameter("windows") as usize;
    in_windows::<C>((windows > 0).then_some(windows), config)
}

fn in_windows<C: Step + BroadPhase>(windows: Option<usize>, config: &Config) -> Built {
    let workers = Workers::new(config.threads)?;
    let finder = Planned::<C>::new(workers.clone(), windows);
    engine::<C>(finder, Choice::SortTogether, workers)
}
