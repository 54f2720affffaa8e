//! Soft discs on ranks: the engine of [`neighbour_list`] on each strip of a box that no rank has all of.
//!
//! A neighbour list is used until it could be wrong. So are *ghosts* here, the particles of other ranks near a strip.
//! Two engines differ in what a rank hears of its ghosts until they are chosen again:
//!
//! | engine | what is sent in a step | trait |
//! |--------|------------------------|-------|
//! | [`Distributed`] | the positions of ghosts | [`Halo`] |
//! | [`Deep`] | nothing: a rank moves ghosts itself, and all ranks roll back if that was wrong | [`DeepHalo`] |
//!
//! Each asks a type that its user gives for the decisions of its algorithm; both ask it for [`Partition`]. Calls are
//! resolved by the compiler. All ranks run the same program, and call the functions of
//! [`Simulation`](common::soft::Simulation) together.
//!
//! # Example
//!
//! The strips of a box of side 6 for three ranks, each two rows of bins high:
//!
//! ```
//! use solution2::Grid;
//! use solution6::balanced;
//! use strips::Strips;
//!
//! let grid = Grid::with_bins_along(6.0, 6);
//! let strips = Strips::of(&grid, &balanced(&[5, 5, 5, 5, 5, 5], 3));
//! assert_eq!(strips.strip(1), 2.0..4.0);
//! assert_eq!(strips.owner(4.5), 2);
//! // What lies on an edge belongs to the strip above it, and beyond a wall there is no other strip.
//! assert_eq!((strips.owner(2.0), strips.owner(6.0)), (1, 2));
//! ```
//!
//! # Shapes
//!
//! The box is cut across y into [`Strips`]. Particles of a rank are [`Bodies`](neighbour_list::Bodies), structures of
//! arrays in the engine's own order; an index means the same particle until the next rebuild. Positions in messages
//! are all x, then all y. A pair across a border is the index of an own particle and the index of a ghost.
//!
//! # Units
//!
//! Lengths are those of the box, also how far a particle goes in a step of [`DT`](common::soft::DT); the parameter
//! `skin` is in cutoffs. Costs are nanoseconds.
//!
//! # Errors
//!
//! A scene that cannot be is a [`SceneError`](common::soft::SceneError). A rank that ends early ends the job.
//!
//! # Bits
//!
//! A run repeats bit by bit on as many ranks. On another number of them sums are taken in another order.

mod border;
mod deep;
mod deep_ghosts;
mod deep_halo;
mod distributed;
mod domain;
mod epoch;
mod partition;
pub mod programs;
mod recut;
mod renew;
mod sent_halo;

pub use deep::Deep;
pub use deep_halo::{DeepHalo, Outlook};
pub use distributed::Distributed;
pub use partition::{Partition, Strips};
pub use sent_halo::{Halo, Scenery};
