//! The graders' side of the kit: a model written independently of the labs, scenes that expose
//! wrong programs, and questions whose answers are judged in the domain's words.
//!
//! The macro [`questions!`] declares the table of a lab's questions; a question asks through
//! [`Ask`]:
//!
//! ```no_run
//! # static VARIANTS: &[common::Variant<dyn common::soft::Simulation>] = &[];
//! use oracle::{Ask, Random, Runs, scenes};
//!
//! fn dense_box(_: &mut Random, ask: &mut impl Ask) {
//!     Runs::new("2.5", VARIANTS, "sorted").resynchronised(ask, &scenes::dense(), 20);
//! }
//! ```
//!
//! Particles are chaotic: two correct programs that add in a different order drift apart until
//! nothing is left to compare. So the model restarts from the program's own state before every step,
//! and that one step is compared ([`Runs::resynchronised`]). Correct programs then differ by 1e-16;
//! the mildest known mistake causes a difference of 6e-8.

mod allowed;
mod apart;
mod asking;
mod bits;
mod columns;
mod compare;
pub mod contest;
mod count;
mod diagnosis;
pub mod drawn;
mod frames;
pub mod hard;
mod model;
mod official;
mod panics;
mod question;
mod questions;
mod random;
pub mod reference;
mod right;
mod runs;
pub mod scenes;
mod share;
mod single;
mod table;
mod watchdog;

pub use apart::apart;
pub use asking::{
    Ask, InTest, Judge, Near, begins_send, beside, digest, flags, in_test, integers, memory,
    no_other_calls, others_within, resident, rounded, truth,
};
pub use bits::difference;
pub use columns::{Columns, spaced};
pub use count::Count;
pub use frames::{read_frames, write_scene};
pub use lab_machine::nanoseconds_each;
pub use model::{Model, acceleration_of_pair, energy, fold, potential_of_pair};
pub use question::Question;
#[cfg(unix)]
pub use questions::answer;
pub use questions::{judge, print as print_questions};
pub use random::Random;
pub use runs::{Runs, States, statistics_of_run};
pub use share::Share;
pub use table::{Table, ascending};
pub use watchdog::{watched, within};

#[cfg(unix)]
pub use asking::{Recorder, itself_on};

#[cfg(unix)]
pub mod mpiexec;
