//! A neighbour-list engine for soft discs, whatever primitives it is built on.
//!
//! Somebody who wants the engine takes the package `neighbour-list`, which brings fast primitives. Here
//! they are a type parameter, [`Primitives`]: the move, the search for pairs, their filter, and how long
//! the list lasts. Somebody who writes these, as in lab 10, gets the rest.
//!
//! - [`particles`]: particles as a structure of arrays, [`Bodies`], and their move.
//! - [`cells`]: the [`Grid`], and sorting by cell. Neighbours in the box are then neighbours in memory.
//! - [`kernels`]: loops for vector registers: eight positions, eight signs, forces of pairs that touch.
//! - [`list`]: the lists in blocks, and the few particles that are too fast for them.
//! - [`threads`]: as many threads as pay for the particles, and work cut into pieces by the scene.
//! - [`engine`]: the engine, [`NeighbourList`].
//!
//! Lengths are in units of the box, times in steps, costs in nanoseconds. An index counts particles in the
//! sorted order; sorting makes all of them invalid. Scenes are checked when they are made
//! ([`common::soft::Scene`]), so nothing here fails.

mod parameters;

pub mod cells;
pub mod engine;
pub mod kernels;
pub mod list;
pub mod particles;
pub mod threads;

pub use cells::{Cells, Extent, Grid, Kind, Sorter};
pub use engine::{External, NeighbourList};
pub use kernels::{AnyProcessor, Contacts, EIGHT, Positions, Primitives, Signs, make_room, pack};
pub use list::{Block, Disc, LISTED, Pairs, REBUILD, TESTED, overlapping};
pub use parameters::{DIVIDE, SHARE, SKIN, crew};
pub use particles::{Bodies, Moving};
pub use threads::Crew;
pub use workers::Workers;
