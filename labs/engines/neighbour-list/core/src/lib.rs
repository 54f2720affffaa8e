//! A neighbour-list engine for soft discs that works with any primitives.
//!
//! If you want a fast engine, use the package `neighbour-list`, which adds fast primitives. Here a
//! type parameter supplies the [`Primitives`]: the move, the search for pairs, the filter for
//! pairs, and the life of the list. If you write your own primitives, as in lab 10, this package
//! contains the rest of the engine.
//!
//! - [`particles`]: particles as a structure of arrays, [`Bodies`], and their move.
//! - [`cells`]: the [`Grid`], and sorting by cell, which makes neighbours in the box neighbours in
//!   memory.
//! - [`kernels`]: loops for vector registers.
//! - [`list`]: the neighbour list in blocks, and the few particles that are too fast for it.
//! - [`threads`]: the number of threads, and the division of work into pieces that depend on the
//!   scene only.
//! - [`engine`]: the engine, [`NeighbourList`].
//!
//! Lengths are in units of the box, times in steps, costs in nanoseconds. An index counts particles
//! in the sorted order, so a sort makes all indices invalid. A scene is checked when it is made
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
pub use parameters::{DIVIDE, SHARE, SKIN, TIMING, crew};
pub use particles::{Bodies, Moving};
pub use threads::Crew;
pub use workers::Workers;
