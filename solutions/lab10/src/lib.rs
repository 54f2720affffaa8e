//! Lab 10, fast and accurate.

mod bodies;
mod cells;
mod contacts;
mod flight;
mod grid;
mod groups;
mod lanes;
mod list;
mod path;
mod planned;
mod planner;
mod search;
mod skin;
mod sort;
mod verlet;
mod window;
mod workers;

pub use bodies::Bodies;
pub use cells::{Cells, Kind};
pub use grid::{Extent, Grid};
pub use lanes::drift;
pub use list::{Block, collect};
pub use path::{Path, Span, closest_squared};
pub use planned::Planned;
pub use planner::{COMPANY, LONGEST, Plan, Way, plan, window_length};
pub use skin::{LISTED, REBUILD, TESTED, best_skin, worn_out};
pub use sort::Sorter;
pub use verlet::{Counts, Verlet};
pub use window::too_far_off;
pub use workers::Workers;

use common::soft::{Silent, Simulation};
use common::{Knob, Promise, Variant};
use solution1::Tally;

/// The programs of this lab.
pub static VARIANTS: &[Variant<dyn Simulation>] = &[
    Variant {
        name: "verlet",
        about: "sorted cells, a neighbour list with a skin, a move without branches",
        promise: Promise::Repeatable,
        knobs: &[Knob {
            name: "skin",
            about: "how far beyond the cutoff the list looks, in cutoffs; 0: the cheapest",
            default: 0.0,
            range: (0.0, 10.0),
        }],
        build: |settings| {
            let skin = settings.knob("skin");
            Ok(if settings.statistics {
                Box::new(Verlet::<Tally>::new(settings.threads, skin))
            } else {
                Box::new(Verlet::<Silent>::new(settings.threads, skin))
            })
        },
    },
    Variant {
        name: "planned",
        about: "reads the scene, decides what to skip, and computes free flight once per window",
        promise: Promise::Repeatable,
        knobs: &[Knob {
            name: "window",
            about: "steps in a window; 0: the planner's choice",
            default: 0.0,
            range: (0.0, 64.0),
        }],
        build: |settings| {
            let steps = settings.knob("window") as u32;
            Ok(if settings.statistics {
                Box::new(Planned::<Tally>::new(settings.threads, steps))
            } else {
                Box::new(Planned::<Silent>::new(settings.threads, steps))
            })
        },
    },
];
