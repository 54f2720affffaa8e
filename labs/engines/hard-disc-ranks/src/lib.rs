//! Hard discs on ranks: engines that distribute the discs of [`hard_discs`] to ranks.
//!
//! A step of hard discs consists of a search and of a decision in order of time. The engines
//! distribute both in different ways:
//!
//! | engine | discs of a rank | decision | trait |
//! |--------|-----------------|----------|-------|
//! | [`MasterWorkers`] | all on the master, blocks on a worker | by the master | [`Dealing`] |
//! | [`AsReported`] | the same; workers move them, as in the report | by the master | [`Dealing`] |
//! | [`SpatialCuts`] | those of its strip, and ghosts | by all ranks, in rounds | [`Deciding`] |
//!
//! The user's type supplies the steps of the algorithm; it implements one of these traits, and
//! [`Messages`]. The compiler resolves the calls. All ranks run the same program, and call the
//! functions of [`Simulation`](common::hard::Simulation) together. The bits are the same as on one
//! rank.
//!
//! # Example
//!
//! A disc in a message, and the workers of a job of four ranks:
//!
//! ```
//! use common::hard::Disc;
//! use hard_disc_ranks::{DiscWire, Team};
//!
//! let wire = DiscWire::new(17, &Disc::new(2.0, 5.0, 1.0, 0.0));
//! assert_eq!((wire.index(), Disc::from(&wire).x), (17, 2.0));
//!
//! // A master that does not work: worker 0 is rank 1.
//! let team = Team::new(4, false);
//! assert_eq!((team.workers, team.rank(0), team.worker(0)), (3, 1, None));
//! ```
//!
//! # Shapes, units, errors
//!
//! A disc's number is its index in the scene; a *slot* is an index into the discs that a rank has.
//! Lengths are in the scene's unit, times in steps. Lists in messages may have any length. A rank
//! that ends early ends the job. No function here returns an error.

mod as_reported;
mod deal;
mod decisions;
mod find;
mod master_workers;
pub mod programs;
mod queues;
mod seen;
mod spatial_cuts;
mod strips;
mod tally;
mod team;
mod wire;

pub use as_reported::AsReported;
pub use deal::{Deal, Job, Part};
pub use decisions::{Decisions, UNKNOWN};
pub use find::walls_of;
pub use master_workers::{Dealing, MasterWorkers};
pub use queues::{Queues, slots_of};
pub use seen::Seen;
pub use spatial_cuts::{Deciding, Range, SpatialCuts};
pub use strips::{Reach, Strips};
pub use tally::Tally;
pub use team::{MASTER, Messages, Team};
pub use wire::{CandidateWire, DiscWire};
