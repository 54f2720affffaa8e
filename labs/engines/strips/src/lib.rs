//! Soft discs on ranks: the engine of [`neighbour_list`] on each strip of a box that no rank stores
//! as a whole.
//!
//! A neighbour list is used until it could be wrong. *Ghosts*, the particles of other ranks near a
//! strip, are used in the same way. The two engines differ in the messages that they send before
//! ghosts are chosen again:
//!
//! | engine | messages in a step | trait |
//! |--------|--------------------|-------|
//! | [`Distributed`] | the positions of ghosts | [`Halo`] |
//! | [`Deep`] | no message: ranks move ghosts and roll back if a step was wrong | [`DeepHalo`] |
//!
//! The user's type makes the decisions of the algorithm: it implements one of these traits, and
//! [`Partition`] for both. The compiler resolves the calls. All ranks run the same program, and
//! call the functions of [`Simulation`](common::soft::Simulation) together.
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
//! // A position on an edge belongs to the strip above it. Beyond a wall there is no other strip.
//! assert_eq!((strips.owner(2.0), strips.owner(6.0)), (1, 2));
//! ```
//!
//! # Shapes
//!
//! The box is cut across y into [`Strips`]. The particles of a rank are
//! [`Bodies`](neighbour_list::Bodies), structures of arrays in the engine's order. An index denotes
//! the same particle until the next rebuild. Positions in messages are all x, then all y. A pair
//! across a border is the index of an own particle and the index of a ghost.
//!
//! # Units
//!
//! Lengths are in units of the box, including the distance that a particle moves in a step of
//! [`DT`](common::soft::DT). The parameter `skin` is in cutoffs. Costs are in nanoseconds.
//!
//! # Errors
//!
//! A scene that is not valid causes a [`SceneError`](common::soft::SceneError). A rank that ends
//! early ends the job.
//!
//! # Bits
//!
//! A run on the same number of ranks repeats bit by bit. On a different number of ranks, sums are
//! taken in a different order.

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
