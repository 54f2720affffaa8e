//! Lab 14, the contest: the solution, which is the starter. The lab is described in
//! `labs/lab14/README.md`.

mod entry;

pub use entry::Entry;

use common::soft::Simulation;
use common::{Reproducibility, Variant};

/// The program of this lab. The contest runs the variant `entry` on all cores of the machine.
pub static VARIANTS: &[Variant<dyn Simulation>] = &[Variant {
    name: "entry",
    about: "your entry in the contest",
    reproducibility: Reproducibility::Tolerance,
    parameters: &[],
    build: |config| Ok(Box::new(Entry::new(config.threads))),
}];
