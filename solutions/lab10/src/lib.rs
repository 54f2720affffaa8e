//! Lab 10, fast and accurate: an engine that leaves out what a scene does not need.
//!
//! In the official scene nine of ten particles touch nobody. All labs before this one move them
//! all the same, one step at a time, and look around for each of them. Here a window of several
//! steps is opened: whose path could come near somebody else's within it? The others fly freely
//! and are visited once. Those that could meet form small groups, which are computed on their own
//! from the beginning of the window to its end, while they are in the processor's registers. A
//! push bends a path, so at the end everybody is asked how far it was off, and where that could
//! have mattered the groups are joined and computed again.
//!
//! Nothing of it may show in the results. Groups sum their pairs by ascending id, and free flight
//! makes the same additions as step by step: windows have the bits of the naive program.
//!
//! | task | file | what |
//! |------|------|------|
//! | 10.1 | `lanes.rs` | a move that vector registers like |
//! | 10.2 | `list.rs` | the neighbours of a particle, without a branch |
//! | 10.3 | `skin.rs` | when a neighbour list is worn out |
//! | 10.4 | `skin.rs` | how thick its skin should be |
//! | 10.5 | `path.rs` | who meets a wall within a window |
//! | 10.6 | `path.rs` | how close two free flights come |
//! | 10.7 | `flight.rs` | free flight, once per window and yet bit by bit |
//! | 10.8 | `watch.rs` | whether the margin held |
//! | 10.9 | `planner.rs` | how long a window should be |

mod approach;
mod around;
mod band;
mod batch;
mod bodies;
mod by_list;
mod cells;
mod contacts;
mod counts;
mod eight;
mod ending;
mod filter;
mod flight;
mod flights;
mod ghosts;
mod grid;
mod grouper;
mod groups;
mod lanes;
mod layout;
mod limits;
mod list;
mod listed;
mod meeting;
mod missed;
mod neighbours;
mod overlap;
mod pace;
mod pack;
mod path;
mod planned;
mod planner;
mod record;
mod runners;
mod seam;
mod search;
mod shortlist;
mod signs;
mod skin;
mod sort;
mod sparse;
mod specials;
mod speeds;
mod sums;
mod sweep;
mod tallies;
mod together;
mod touching;
mod verlet;
mod walls;
mod watch;
mod wear;
mod window;
mod workers;

pub use bodies::Bodies;
pub use cells::{Cells, Kind};
pub use contacts::{BATCH, Contacts};
pub use counts::Counts;
pub use eight::Eight;
pub use flight::fly;
pub use grid::{Extent, Grid};
pub use lanes::drift;
pub use list::{Block, Pairs, Piece, collect};
pub use overlap::{Disc, overlapping};
pub use pack::pack;
pub use path::{Path, Span, closest_squared};
pub use planned::Planned;
pub use planner::{COMPANY, LONGEST, Plan, Way, plan, window_length};
pub use signs::{AnyProcessor, EIGHT, Signs};
pub use skin::{LISTED, REBUILD, TESTED, best_skin, worn_out};
pub use sort::Sorter;
pub use verlet::Verlet;
pub use watch::too_far_off;
pub use workers::Workers;

use common::soft::{NoStatistics, Simulation};
use common::{BuildError, Config, Parameter, Reproducibility, Variant};
use solution1::Tally;

const DIVIDE: Parameter = Parameter {
    name: "divide",
    about: "steps that an official step of 0.0005 is divided into",
    default: 1.0,
    range: (1.0, 1000.0),
};
const SKIN: Parameter = Parameter {
    name: "skin",
    about: "how far beyond the cutoff the list looks, in cutoffs; 0: the cheapest",
    default: 0.0,
    range: (0.0, 10.0),
};
const WINDOW: Parameter = Parameter {
    name: "window",
    about: "steps in a window; 0: the planner's choice",
    default: 0.0,
    range: (0.0, 64.0),
};

type Built = Result<Box<dyn Simulation>, BuildError>;

fn verlet(config: &Config) -> Built {
    let (skin, divide) = (config.parameter("skin"), config.parameter("divide") as u32);
    Ok(if config.statistics {
        Box::new(Verlet::<Tally>::new(config.threads, skin, divide))
    } else {
        Box::new(Verlet::<NoStatistics>::new(config.threads, skin, divide))
    })
}

fn planned(config: &Config, divide: u32) -> Built {
    let steps = config.parameter("window") as u32;
    Ok(if config.statistics {
        Box::new(Planned::<Tally>::new(config.threads, steps, divide))
    } else {
        Box::new(Planned::<NoStatistics>::new(config.threads, steps, divide))
    })
}

/// The programs of this lab.
pub static VARIANTS: &[Variant<dyn Simulation>] = &[
    Variant {
        name: "verlet",
        about: "sorted cells, a neighbour list with a skin, a move without branches",
        reproducibility: Reproducibility::Deterministic,
        parameters: &[SKIN, DIVIDE],
        build: verlet,
    },
    Variant {
        name: "planned",
        about: "reads the scene, decides what to skip, and computes free flight once per window",
        reproducibility: Reproducibility::Deterministic,
        parameters: &[WINDOW],
        build: |config| planned(config, 1),
    },
    Variant {
        name: "substep",
        about: "as planned, and who is in contact takes several small steps for each official one",
        reproducibility: Reproducibility::Deterministic,
        parameters: &[
            WINDOW,
            Parameter {
                name: "substeps",
                about: "small steps in an official one",
                default: 10.0,
                range: (1.0, 1000.0),
            },
        ],
        build: |config| planned(config, config.parameter("substeps") as u32),
    },
];
