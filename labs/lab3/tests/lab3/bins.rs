//! Bins and particles that several questions share.

use common::soft::{CUTOFF, Particle};
use oracle::scenes;
use solution2::{Grid, VecBins};

/// Returns nine rows of bins with 150 particles at rest.
pub(crate) fn of_150() -> VecBins {
    let scene = scenes::lattice_with_jitter(150, 9.5 * CUTOFF, 0.0, 3);
    let mut bins = VecBins::of_scene(&scene, 1.0);
    bins.refill(scene.particles());
    bins
}

/// Returns a grid of `along` rows and columns of bins that are one cutoff wide and high.
pub(crate) fn of_cutoffs(along: usize) -> Grid {
    Grid::with_bins_along(along as f64 * CUTOFF, along)
}

/// Returns particle `id` at rest at (x, y), in cutoffs.
pub(crate) fn at(id: u32, x: f64, y: f64) -> Particle {
    Particle { x: x * CUTOFF, y: y * CUTOFF, id, ..Particle::default() }
}

/// Lists the ids of the particles in each row of bins, with a bar between rows.
pub(crate) fn row_by_row(grid: &Grid, bins: &[Vec<Particle>]) -> String {
    let row = |row: &[Vec<Particle>]| ids(row.iter().flatten());
    bins.chunks(grid.columns()).map(row).collect::<Vec<_>>().join(" | ")
}

/// Lists the ids of particles in ascending order.
pub(crate) fn ids<'a>(particles: impl IntoIterator<Item = &'a Particle>) -> String {
    oracle::ascending(particles.into_iter().map(|p| p.id))
}

/// Returns id, x, y, vx, vy of each particle, in the order of ids. Negative zero as a position
/// becomes zero.
pub(crate) fn states<'a>(particles: impl IntoIterator<Item = &'a Particle>) -> Vec<f64> {
    let mut all: Vec<&Particle> = particles.into_iter().collect();
    all.sort_by_key(|p| p.id);
    all.iter().flat_map(|p| [f64::from(p.id), p.x + 0.0, p.y + 0.0, p.vx, p.vy]).collect()
}
