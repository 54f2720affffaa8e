//! What a scene does not need.

use std::f64::consts::PI;
use std::fmt;

use common::soft::CUTOFF;
use solution10::particles::Sample;
use solution10::{Bodies, Extent, Grid, Workers};

use crate::window_length::window_length;

/// How to go through the scene.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Strategy {
    /// A neighbour list: most particles have neighbours.
    #[default]
    List,
    /// A neighbour list, and small steps only for particles that may touch within an official one: a
    /// window of one step from a list that lasts for several.
    Contacts {
        /// Steps in a window when a particle is too fast for a list.
        steps: u32,
    },
    /// Windows of so many steps: most fly freely.
    Windows {
        /// Steps in a window.
        steps: u32,
    },
}

/// What the planner decided, and from which numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Plan {
    /// How to go.
    pub strategy: Strategy,
    /// Whether every cell is stored, or only occupied ones.
    pub dense: bool,
    /// How much closer than its free flight a pair may come that is not computed, in length.
    pub margin: f64,
    /// Speed that all but one in 500 particles stay below.
    pub speed: f64,
    /// Particles in the area of a cutoff disc, where the mean particle is.
    pub neighbours: f64,
}

impl Plan {
    /// Cells of side `near` or more for a window, and whether every cell is stored.
    pub(crate) fn grid(&self, bodies: &Bodies, near: f64, workers: &Workers) -> (Grid, bool) {
        let extent = Extent::among(bodies, workers);
        let n = bodies.len();
        let spacing = (extent.width * extent.height / n as f64).sqrt();
        let side = if self.dense { near.max(spacing) } else { near };
        let grid = Grid::new(&extent, side);
        let dense = self.dense && grid.is_dense(n);
        (grid, dense)
    }
}

/// Reads the scene and decides. `fixed` steps for a window, or 0 to choose; each step is divided
/// into `divide`.
pub fn plan(bodies: &Bodies, size: f64, fixed: u32, divide: u32) -> Plan {
    let n = bodies.len();
    let extent = Extent::of(bodies);
    let density = density(bodies, &extent);
    let neighbours = density * PI * CUTOFF * CUTOFF;
    let (mean, speed) = speeds(bodies, size);
    // Cells as wide as the mean distance cover a box that is evenly filled, however empty. If they
    // hold many each, the particles stand in clusters: then only occupied cells are stored.
    let spacing = (extent.width * extent.height / n as f64).sqrt().max(CUTOFF);
    let even = occupancy(bodies, &Grid::new(&extent, spacing)) < 4.0;
    let steps = if fixed > 0 { fixed } else { divided(window_length(density, mean), divide) };
    let strategy = if fixed > 0 || neighbours <= ALONE {
        Strategy::Windows { steps }
    } else if neighbours > company(divide) {
        Strategy::List
    } else if divide >= MANY {
        Strategy::Contacts { steps }
    } else {
        Strategy::Windows { steps }
    };
    Plan { strategy, dense: even, margin: MARGIN * CUTOFF, speed, neighbours }
}

/// The mean speed of the particles, and the speed that all but one in 500 of them stay below; that
/// is at least a little, in a box of side `size`.
pub(crate) fn speeds(bodies: &Bodies, size: f64) -> (f64, f64) {
    let mut sample = Sample::of(bodies, 4096);
    (sample.mean(), sample.all_but_one_in(500).max(1e-9 * size))
}

/// Particles in the area of a cutoff disc from which on a list is cheaper than windows, measured on
/// the machine of the book.
pub const COMPANY: f64 = 0.12;
/// As many up to which windows are cheaper than any list, however small the steps: most particles
/// then fly through a window of [`LONGEST`](crate::LONGEST) steps.
const ALONE: f64 = 0.04;
/// Small steps in an official one from which on windows are so short that a list pays.
const MANY: u32 = 5;
/// How close free flights come that are computed at once, beyond the cutoff and in cutoffs.
const MARGIN: f64 = 0.05;

/// How long a window should be in which groups take `divide` small steps for each of its `steps`.
///
/// Opening a window costs the same however it is divided, but the time that goes into groups grows
/// with the number of particles in them, so with its length, and a fifth of that time with
/// `divide`. The sum of both costs per step is least at a length like one over the root of the second.
fn divided(steps: u32, divide: u32) -> u32 {
    let dearer = 1.0 + 0.2 * f64::from(divide.max(1) - 1);
    ((f64::from(steps) / dearer.sqrt()) as u32).max(1)
}

/// As [`COMPANY`], if each step is divided into `divide`. Small steps for all cost nearly as many times
/// as much, small steps of groups do not; measured for two to twenty of them.
fn company(divide: u32) -> f64 {
    (COMPANY + 0.25 * f64::from(divide.max(1) - 1)).min(1.6)
}

/// Particles per area, where the mean particle is: other particles in its cell of four cutoffs.
/// Particles in the order of a crystal shun each other's cells, so it is at least what an even
/// spread would have.
fn density(bodies: &Bodies, extent: &Extent) -> f64 {
    let grid = Grid::new(extent, 4.0 * CUTOFF);
    let around = occupancy(bodies, &grid) / (grid.side() * grid.side());
    let even = (bodies.len() - 1) as f64 / ((extent.width + CUTOFF) * (extent.height + CUTOFF));
    around.max(even)
}

/// Other particles in its own cell, for the mean particle.
fn occupancy(bodies: &Bodies, grid: &Grid) -> f64 {
    let columns = u64::from(grid.columns);
    let key =
        |i: usize| u64::from(grid.row(bodies.y[i])) * columns + u64::from(grid.column(bodies.x[i]));
    let n = bodies.len();
    let pairs: usize = if grid.cells() <= 4 * n as u64 {
        let mut counts = vec![0_u32; grid.cells() as usize];
        (0..n).for_each(|i| counts[key(i) as usize] += 1);
        counts.into_iter().map(|count| count as usize * (count as usize).saturating_sub(1)).sum()
    } else {
        let mut keys: Vec<u64> = (0..n).map(key).collect();
        keys.sort_unstable();
        keys.chunk_by(|a, b| a == b).map(|cell| cell.len() * (cell.len() - 1)).sum()
    };
    pairs as f64 / bodies.len() as f64
}

impl fmt::Display for Plan {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { strategy, neighbours, speed, .. } = self;
        match strategy {
            Strategy::List => write!(f, "neighbour list")?,
            Strategy::Contacts { .. } => {
                write!(f, "neighbour list, small steps for who may touch")?
            }
            Strategy::Windows { steps } => {
                let cells = if self.dense { "every cell stored" } else { "occupied cells only" };
                let margin = self.margin / CUTOFF;
                write!(f, "windows of {steps} steps, {cells}, margin {margin:.2} cutoffs")?;
            }
        }
        write!(
            f,
            ": {neighbours:.2} particles in the area of a cutoff disc, speeds up to {speed:.3}"
        )
    }
}
