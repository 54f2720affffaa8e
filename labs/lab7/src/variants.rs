//! The programs of this lab.

use common::hard::Simulation;
use common::{BuildError, Knob, Promise, Settings, Variant};

use crate::{AllPairs, Choice, Engine, Find, Grid, Loops, Planned, Schedule, Which, Workers};

/// The programs of this lab.
pub static VARIANTS: &[Variant<dyn Simulation>] = &[
    variant("sequential", "all pairs, one thread", &[], |_| {
        engine(AllPairs, Choice::Sort, Workers::One)
    }),
    variant("outer-static", "outer loop in fixed parts (the report's p1)", &[], |settings| {
        loops(Which::Outer, Schedule::Static, settings)
    }),
    variant("outer-dynamic", "outer loop from a queue (the report's p1d)", CHUNK, |settings| {
        loops(Which::Outer, dynamic(settings), settings)
    }),
    variant("outer-rayon", "outer loop halved and stolen", SPLIT, |settings| {
        loops(Which::Outer, rayon(settings), settings)
    }),
    variant("inner-static", "inner loop in fixed parts (the report's p2)", &[], |settings| {
        loops(Which::Inner, Schedule::Static, settings)
    }),
    variant("inner-dynamic", "inner loop from a queue (the report's p2d)", CHUNK, |settings| {
        loops(Which::Inner, dynamic(settings), settings)
    }),
    variant("inner-rayon", "inner loop halved and stolen", SPLIT_SHORT, |settings| {
        loops(Which::Inner, rayon(settings), settings)
    }),
    variant(
        "nested-static",
        "both loops in fixed parts, a fresh team for each inner loop",
        &[],
        |settings| loops(Which::Nested, Schedule::Static, settings),
    ),
    variant(
        "nested-dynamic",
        "both from queues, a fresh team for each inner loop (p3)",
        CHUNK,
        |settings| loops(Which::Nested, dynamic(settings), settings),
    ),
    variant(
        "nested-rayon",
        "both loops halved and stolen by the same threads",
        SPLIT_SHORT,
        |settings| loops(Which::Nested, rayon(settings), settings),
    ),
    variant(
        "merge-sort",
        "as outer-dynamic; lists are sorted in parallel and merged",
        CHUNK,
        |settings| chosen(Choice::Merge, settings),
    ),
    variant(
        "select",
        "as outer-dynamic; the earliest are selected without a sort",
        CHUNK,
        |settings| chosen(Choice::Select, settings),
    ),
    variant("grid", "the report's grid of 4 x 4, 2 x 2 and 1 blocks, one thread", &[], |_| {
        engine(Grid::new(Workers::One, usize::MAX / 2), Choice::Sort, Workers::One)
    }),
    variant("grid-parallel", "the same, discs from a queue", GRID_CHUNK, |settings| {
        let workers = Workers::new(settings.threads)?;
        let chunk = settings.knob("chunk") as usize;
        engine(Grid::new(workers.clone(), chunk), Choice::Sort, workers)
    }),
    variant("cells", "sorted occupied cells, the step in one window", &[], |settings| {
        planned(Some(1), settings)
    }),
    variant("planned", "the same, windows of time as the scene needs", WINDOWS, |settings| {
        let windows = settings.knob("windows") as usize;
        planned((windows > 0).then_some(windows), settings)
    }),
];

const CHUNK: &[Knob] =
    &[Knob { name: "chunk", about: "iterations in a chunk", default: 1.0, range: (1.0, 1e9) }];

const GRID_CHUNK: &[Knob] =
    &[Knob { name: "chunk", about: "discs in a chunk", default: 16.0, range: (1.0, 1e9) }];

const SPLIT: &[Knob] = &[SPLIT_KNOB];

const SPLIT_SHORT: &[Knob] = &[Knob { default: 1024.0, ..SPLIT_KNOB }];

const SPLIT_KNOB: Knob = Knob {
    name: "least",
    about: "parts of so many iterations are not halved; 0 makes a part for each thread",
    default: 16.0,
    range: (0.0, 1e9),
};

const WINDOWS: &[Knob] = &[Knob {
    name: "windows",
    about: "windows in a step; 0 chooses",
    default: 0.0,
    range: (0.0, 65536.0),
}];

type Build = fn(&Settings) -> Result<Box<dyn Simulation>, BuildError>;

const fn variant(
    name: &'static str,
    about: &'static str,
    knobs: &'static [Knob],
    build: Build,
) -> Variant<dyn Simulation> {
    Variant { name, about, promise: Promise::Canonical, knobs, build }
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
    settings: &Settings,
) -> Result<Box<dyn Simulation>, BuildError> {
    let workers = Workers::new(settings.threads)?;
    engine(Loops { which, schedule, workers: workers.clone() }, Choice::Sort, workers)
}

fn chosen(choice: Choice, settings: &Settings) -> Result<Box<dyn Simulation>, BuildError> {
    let workers = Workers::new(settings.threads)?;
    let (which, schedule) = (Which::Outer, dynamic(settings));
    engine(Loops { which, schedule, workers: workers.clone() }, choice, workers)
}

fn planned(windows: Option<usize>, settings: &Settings) -> Result<Box<dyn Simulation>, BuildError> {
    let workers = Workers::new(settings.threads)?;
    engine(Planned::new(workers.clone(), windows), Choice::Sort, workers)
}

fn dynamic(settings: &Settings) -> Schedule {
    Schedule::Dynamic { chunk: settings.knob("chunk") as usize }
}

fn rayon(settings: &Settings) -> Schedule {
    Schedule::Rayon { least: settings.knob("least") as usize }
}
