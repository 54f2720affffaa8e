//! The programs of this lab.

use common::hard::Simulation;
use common::{BuildError, Config, Parameter, Reproducibility, Variant};

use crate::{
    AllPairs, Choice, Collect, Engine, Find, Grid, Loops, Planned, Schedule, Which, Workers,
};

/// The programs of this lab.
pub static VARIANTS: &[Variant<dyn Simulation>] = &[
    variant("sequential", "all pairs, one thread", &[], |_| {
        engine(AllPairs, Choice::Sort, Workers::One)
    }),
    variant("outer-static", "outer loop in fixed parts (the report's p1)", &[], |config| {
        loops(Which::Outer, Schedule::Static, config)
    }),
    variant("outer-dynamic", "outer loop from a queue (the report's p1d)", CHUNK, |config| {
        loops(Which::Outer, dynamic(config), config)
    }),
    variant("inner-static", "inner loop in fixed parts (the report's p2)", &[], |config| {
        loops(Which::Inner, Schedule::Static, config)
    }),
    variant("inner-dynamic", "inner loop from a queue (the report's p2d)", CHUNK, |config| {
        loops(Which::Inner, dynamic(config), config)
    }),
    variant(
        "nested-mixed",
        "outer loop from a queue, inner ones in fixed parts by fresh teams (the report's p3)",
        CHUNK,
        |config| loops(Which::Nested, dynamic(config), config),
    ),
    variant(
        "shared-locked",
        "as outer-dynamic; candidates in one array, counted under a lock (as the report has it)",
        CHUNK,
        |config| collected(Collect::Locked, Choice::Sort, config),
    ),
    variant("shared-atomic", "the same, counted by fetch_add", CHUNK, |config| {
        collected(Collect::Atomic, Choice::Sort, config)
    }),
    variant(
        "merge-sort",
        "as outer-dynamic; lists are sorted in parallel and merged",
        CHUNK,
        |config| collected(Collect::Own, Choice::Merge, config),
    ),
    variant("grid", "the report's grid of 4 x 4, 2 x 2 and 1 blocks, one thread", &[], |_| {
        engine(Grid::new(Workers::One, usize::MAX / 2), Choice::Sort, Workers::One)
    }),
    variant("grid-parallel", "the same, discs from a queue", GRID_CHUNK, |config| {
        let workers = Workers::new(config.threads)?;
        let chunk = config.parameter("chunk") as usize;
        engine(Grid::new(workers.clone(), chunk), Choice::Sort, workers)
    }),
    variant("cells", "sorted occupied cells, the step in one window", &[], |config| {
        planned(Some(1), config)
    }),
    variant("planned", "the same, windows of time as the scene needs", WINDOWS, |config| {
        let windows = config.parameter("windows") as usize;
        planned((windows > 0).then_some(windows), config)
    }),
];

const CHUNK: &[Parameter] =
    &[Parameter { name: "chunk", about: "iterations in a chunk", default: 1.0, range: (1.0, 1e9) }];

const GRID_CHUNK: &[Parameter] =
    &[Parameter { name: "chunk", about: "discs in a chunk", default: 16.0, range: (1.0, 1e9) }];

const WINDOWS: &[Parameter] = &[Parameter {
    name: "windows",
    about: "windows in a step; 0 chooses",
    default: 0.0,
    range: (0.0, 65536.0),
}];

type Build = fn(&Config) -> Result<Box<dyn Simulation>, BuildError>;

const fn variant(
    name: &'static str,
    about: &'static str,
    parameters: &'static [Parameter],
    build: Build,
) -> Variant<dyn Simulation> {
    Variant { name, about, reproducibility: Reproducibility::Bitwise, parameters, build }
}

fn engine(
    finder: impl Find + 'static,
    choice: Choice,
    workers: Workers,
) -> Result<Box<dyn Simulation>, BuildError> {
    Ok(Box::new(Engine::new(finder, choice, workers)))
}

fn loops(
    which: Which,
    schedule: Schedule,
    config: &Config,
) -> Result<Box<dyn Simulation>, BuildError> {
    let workers = Workers::new(config.threads)?;
    let loops = Loops::new(which, schedule, Collect::Own, workers.clone());
    engine(loops, Choice::Sort, workers)
}

fn collected(
    collect: Collect,
    choice: Choice,
    config: &Config,
) -> Result<Box<dyn Simulation>, BuildError> {
    let workers = Workers::new(config.threads)?;
    let loops = Loops::new(Which::Outer, dynamic(config), collect, workers.clone());
    engine(loops, choice, workers)
}

fn planned(windows: Option<usize>, config: &Config) -> Result<Box<dyn Simulation>, BuildError> {
    let workers = Workers::new(config.threads)?;
    engine(Planned::new(workers.clone(), windows), Choice::SortTogether, workers)
}

fn dynamic(config: &Config) -> Schedule {
    Schedule::Dynamic { chunk: config.parameter("chunk") as usize }
}
