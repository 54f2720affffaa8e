//! Given code for the labs with ranks (5, 6, 8 and 13).
//!
//! An MPI program is started many times at once, by `mpiexec -n 4 PROGRAM`; each copy is a *rank*
//! with memory of its own. The same in every lab:
//!
//! - [`as_rank`]: a job starts together and ends together. A rank that fails ends all
//!   others, else they would wait for its messages for ever.
//! - [`world`]: the communicator that all ranks share.
//! - [`Wire`] and [`Ghost`]: the form of a particle in a message.
//! - [`displacements`], [`total`] and [`split`]: lists of several ranks, one behind the other in one buffer.
//! - [`Traffic`]: how many messages and bytes a rank sends; [`report_memory`]: what it holds;
//!   [`Clock`]: when it computes, communicates and waits; [`together`]: where it is when the job stands still, and
//!   which calls it makes that other ranks do not.

mod calls;
mod clock;
mod epoch;
mod job;
mod parts;
mod record;
mod report;
mod watch;
mod wire;

pub use calls::{calls_made, note};
pub use clock::{Clock, Partners};
pub use job::{as_rank, drive, drive_hard, world};
pub use parts::{by_rank, displacements, split, total};
pub use report::{Traffic, report_memory};
pub use watch::together;
pub use wire::{Ghost, Wire};
