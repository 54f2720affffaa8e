//! The planner: it decides whether windows or a list are cheaper for a scene.

use std::f64::consts::PI;
use std::fmt;

use common::soft::{CUTOFF, DT};
use neighbour_list::particles::Sample;
use neighbour_list::{Bodies, Extent, Grid};

use crate::rules::Rules;

/// The way to advance a scene.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Strategy {
    /// A neighbour list, because most particles have neighbours.
    #[default]
    List,
    /// Windows of several steps, because most particles fly freely.
    Windows {
        /// Number of official steps in a window.
        steps: u32,
    },
}

/// The planner's decision, and the numbers that led to it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Plan {
    /// The chosen strategy.
    pub strategy: Strategy,
    /// Pairs whose free flights come within the cutoff plus this length are computed.
    pub margin: f64,
    /// The speed of the fastest particle.
    pub fastest: f64,
    /// Mean number of other particles in a disc whose radius is the cutoff, around a particle.
    pub neighbours: f64,
    /// Number of particles per unit area around a particle, averaged over all particles.
    pub density: f64,
}

/// Surveys the particles and chooses the way to advance them.
///
/// A window has `fixed` steps, or as many as the rules choose if `fixed` is 0. Each step is divided
/// into `divide` small steps.
pub fn plan<R: Rules>(bodies: &Bodies, fixed: u32, divide: u32) -> Plan {
    let extent = Extent::of(bodies);
    let density = density(bodies, &extent);
    let neighbours = density * PI * CUTOFF * CUTOFF;
    let mean = Sample::of(bodies, 4096).mean();
    let fastest = bodies.fastest();
    let steps = if fixed > 0 { fixed } else { divided(R::window_length(density, mean), divide) };
    // The list of a window allows for the fastest particle; the list of lab 10 treats this particle
    // as an outlier.
    let far = CUTOFF + 2.0 * fastest * f64::from(steps) * DT;
    let alone = neighbours <= max_neighbours_in_windows(divide) && far * far * density <= FULL;
    let strategy = if fixed > 0 || alone { Strategy::Windows { steps } } else { Strategy::List };
    let margin = CUTOFF * if divide > 1 { SMALL_MARGIN } else { MARGIN };
    Plan { strategy, margin, fastest, neighbours, density }
}

/// Number of particles per cutoff disc above which lists are cheaper than windows.
///
/// The number was measured on the machine of the book.
const MAX_NEIGHBOURS_IN_WINDOWS: f64 = 0.12;
/// Greatest number of particles in a square as wide as the reach of a window's list.
const FULL: f64 = 20.0;
/// Margin in units of the cutoff. A pair is computed if its free flights come closer than the
/// cutoff plus this margin.
const MARGIN: f64 = 0.05;
/// The margin for divided steps: windows are short then, and a force bends a path less.
const SMALL_MARGIN: f64 = 0.02;

/// Returns the best number of official steps in a window, if groups take `divide` small steps for
/// each.
///
/// Opening a window costs the same for every length. The time for groups is proportional to
/// `divide`. It also grows with the number of particles in groups, and longer windows have more of
/// these particles. The sum of both costs per step is least at a length proportional to
/// 1 / √`divide`. Opening a window for a single step is not worth its cost.
fn divided(steps: u32, divide: u32) -> u32 {
    let length = f64::from(steps) / f64::from(divide.max(1)).sqrt();
    (length as u32).max(steps.min(2))
}

/// Returns the number of particles per cutoff disc above which lists are cheaper than windows.
///
/// Each official step is divided into `divide` small steps. For undivided steps the result is
/// [`MAX_NEIGHBOURS_IN_WINDOWS`].
///
/// A step costs nearly `divide` times as much if all particles take small steps, but not if only
/// groups do. The numbers were measured for `divide` from 2 to 20.
fn max_neighbours_in_windows(divide: u32) -> f64 {
    (MAX_NEIGHBOURS_IN_WINDOWS + 0.25 * f64::from(divide.max(1) - 1)).min(1.2)
}

/// Returns the number of particles per unit area around a particle, averaged over all particles.
///
/// The function counts other particles in the same cell, which is four cutoffs wide. As a particle
/// does not count itself, the count in a regular lattice is too low. Therefore the result is never
/// less than the density of the whole scene.
fn density(bodies: &Bodies, extent: &Extent) -> f64 {
    let grid = Grid::new(extent, 4.0 * CUTOFF);
    let around = occupancy(bodies, &grid) / (grid.side() * grid.side());
    let even = (bodies.len() - 1) as f64 / ((extent.width + CUTOFF) * (extent.height + CUTOFF));
    around.max(even)
}

/// Returns the number of other particles in the cell of a particle, averaged over all particles.
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
        let Self { strategy, neighbours, fastest, .. } = self;
        match strategy {
            Strategy::List => write!(f, "neighbour list")?,
            Strategy::Windows { steps } => {
                let margin = self.margin / CUTOFF;
                write!(f, "windows of {steps} steps, margin {margin:.2} cutoffs")?;
            }
        }
        write!(
            f,
            ": {neighbours:.2} particles in the area of a cutoff disc, speeds up to {fastest:.3}"
        )
    }
}
