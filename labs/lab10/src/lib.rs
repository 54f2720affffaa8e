//! Lab 10, fast and accurate.

mod bodies;
mod cells;
mod contacts;
mod grid;
mod lanes;
mod list;
mod skin;
mod sort;
mod verlet;
mod workers;

pub use bodies::Bodies;
pub use cells::{Cells, Kind};
pub use grid::{Extent, Grid};
pub use lanes::drift;
pub use list::{Block, collect};
pub use skin::{LISTED, REBUILD, TESTED, best_skin, worn_out};
pub use sort::Sorter;
pub use verlet::{Counts, Verlet};
pub use workers::Workers;

use common::soft::{Silent, Simulation};
use common::{Knob, Promise, Variant};
use solution1::Tally;

/// The programs of this lab.
pub static VARIANTS: &[Variant<dyn Simulation>] = &[Variant {
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
}];
