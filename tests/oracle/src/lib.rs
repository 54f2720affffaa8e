//! The graders' side of the kit: a model written independently of the labs, scenes on which wrong
//! programs show, and checks that say in the domain's words what is wrong.
//!
//! A test asks a [`Grader`] for a check of one variant:
//!
//! ```no_run
//! # static VARIANTS: &[common::Variant<dyn common::soft::Simulation>] = &[];
//! use oracle::{Grader, scenes};
//!
//! Grader::new("2.5", VARIANTS, "sorted").resynchronised(&scenes::dense(), 20);
//! ```
//!
//! Particles are chaotic: two correct programs that add in a different order drift apart until
//! nothing is left to compare. So the checks restart the model from the program's own state
//! before every step and compare that one step ([`Grader::resynchronised`]). Correct programs
//! then differ by 1e-16; the mildest mistake that we know makes 6e-8.

mod allowed;
mod apart;
pub mod ask;
mod asking;
mod bits;
mod columns;
mod compare;
mod count;
mod diagnosis;
pub mod drawn;
mod frames;
mod grader;
pub mod hard;
pub mod limits;
mod long_run;
mod model;
mod questions;
mod random;
pub mod reference;
mod right;
mod runs;
pub mod scenes;
mod share;
mod single;
mod table;
mod threads;
mod watchdog;
pub mod yardstick;

pub use apart::apart;
pub use asking::{
    Ask, InTest, Judge, Near, Recorder, beside, digest, flags, in_test, memory, no_other_calls,
    others_within, rounded, truth, whole,
};
pub use bits::difference;
pub use columns::{Columns, spaced};
pub use compare::check_step;
pub use count::Count;
pub use frames::{read_frames, write_scene};
pub use grader::Grader;
pub use model::{Model, acceleration_of_pair, energy, fold, potential_of_pair};
pub use questions::{Question, answer, judge, print as print_questions};
pub use random::Random;
pub use right::right;
pub use runs::{Runs, States, statistics_of_run};
pub use share::Share;
pub use table::{Table, ascending};
pub use watchdog::{watched, within};

#[cfg(unix)]
pub use asking::itself_on;

#[cfg(unix)]
pub mod mpiexec;
