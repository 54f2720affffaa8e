//! Bins and particles that several questions share.

use common::soft::{CUTOFF, Particle};
use oracle::scenes;
use solution2::{Grid, VecBins};

/// Nine rows of bins with 150 particles at rest.
pub(crate) fn of_150() -> VecBins {
    let scene = scenes::lattice_with_jitter(150, 9.5 * CUTOFF, 0.0, 3);
    let mut bins = VecBins::of_scene(&scene, 1.0);
    bins.refill(scene.particles());
    bins
}

/// A box of some rows and columns of bins that are a cutoff wide and high.
pub(crate) fn of_cutoffs(along: usize) -> Grid {
    Grid::with_bins_along(along as f64 * CUTOFF, along)
}

/// Particle `id` at rest at (x, y), in cutoffs.
pub(crate) fn at(id: u32, x: f64, y: f64) -> Particle {
    Particle { x: x * CUTOFF, y: y * CUTOFF, id, ..Particle::default() }
}

/// The ids of the particles in each row of bins, with a bar between rows.
pub(crate) fn row_by_row(grid: &Grid, bins: &[Vec<Particle>]) -> String {
    let row = |row: &[Vec<Particle>]| ids(row.iter().flatten());
    bins.chunks(grid.columns()).map(row).collect::<Vec<_>>().join(" | ")
}

/// The ids of particles in ascending order.
pub(crate) fn ids<'a>(particles: impl IntoIterator<Item = &'a Particle>) -> String {
    oracle::ascending(particles.into_iter().map(|p| p.id))
}

/// id, x, y, vx, vy of each particle, in the order of ids. Either zero will do for a position.
pub(crate) fn states<'a>(particles: impl IntoIterator<Item = &'a Particle>) -> Vec<f64> {
    let mut all: Vec<&Particle> = particles.into_iter().collect();
    all.sort_by_key(|p| p.id);
    all.iter().flat_map(|p| [f64::from(p.id), p.x + 0.0, p.y + 0.0, p.vx, p.vy]).collect()
}
