//! A grid of cells over the particles, and particles sorted by cell.

mod bands;
mod grid;
mod sort;
mod table;

pub use grid::{Extent, Grid};
pub use sort::Sorter;
pub use table::{Cells, Kind, Rows};
