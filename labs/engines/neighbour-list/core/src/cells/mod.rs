//! The grid of cells, and sorting particles by cell.
//!
//! [`Grid`] finds the cell of a position, [`Sorter`] sorts the particles, and [`Cells`] returns the
//! particles of a cell and of the cells around it.

mod bands;
mod grid;
mod sort;
mod table;

pub use grid::{Extent, Grid};
pub use sort::Sorter;
pub use table::{Cells, Kind, Rows};
