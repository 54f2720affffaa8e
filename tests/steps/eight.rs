//! Eight particles in four rows of bins, and two threads with two rows each.

use common::soft::{DT, Particle};
use oracle::spaced;
use solution2::Grid;

/// Returns the grid of the box: four bins along each side, of side 1.
pub(crate) fn grid() -> Grid {
    Grid::with_bins_along(4.0, 4)
}

/// Returns eight particles. Particles 2r and 2r + 1 begin in row r. Particles 1 and 3 fly up and
/// particle 4 flies down, one row in each step; all other particles rest. All particles stay far
/// from each other.
pub(crate) fn particles() -> Vec<Particle> {
    let particle = |id: u32| {
        let rows_per_step = match id {
            1 | 3 => 1.0,
            4 => -1.0,
            _ => 0.0,
        };
        let (x, y) = (0.25 + 0.5 * f64::from(id), f64::from(id / 2) + 0.5);
        Particle { id, x, y, vx: 0.0, vy: rows_per_step / DT }
    };
    (0..8).map(particle).collect()
}

/// Returns the ids of particles.
pub(crate) fn numbers<'a>(particles: impl IntoIterator<Item = &'a Particle>) -> String {
    let mut ids: Vec<u32> = particles.into_iter().map(|p| p.id).collect();
    ids.sort_unstable();
    spaced(ids)
}
