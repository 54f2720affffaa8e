//! Given code for the labs with ranks (5, 6, 8 and 13).
//!
//! `mpiexec -n 4 PROGRAM` starts four copies of an MPI program. Each copy is a *rank* with its own
//! memory. Every lab with ranks uses these items:
//!
//! - [`as_rank`]: starts and ends a job. A rank that fails ends all other ranks, because they would
//!   wait for its messages forever.
//! - [`world`]: the communicator that all ranks share.
//! - [`Wire`] and [`Ghost`]: the form of a particle in a message.
//! - [`displacements`], [`total`] and [`split`]: lists of several ranks, one after another in a buffer.
//! - [`Traffic`]: the number of messages and bytes that a rank sends. [`report_memory`]: its memory.
//! - [`Clock`]: the times in which a rank computes, communicates and waits.
//! - [`together`]: a call of all ranks. If the job hangs, this function reports where each rank is,
//!   and which calls the ranks do not make together.

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
