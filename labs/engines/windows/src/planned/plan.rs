//! What a scene does not need.

use std::f64::consts::PI;
use std::fmt;

use common::soft::{CUTOFF, DT};
use neighbour_list::particles::Sample;
use neighbour_list::{Bodies, Extent, Grid};

use crate::rules::Rules;

/// How to go through the scene.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Strategy {
    /// A neighbour list: most particles have neighbours.
    #[default]
    List,
    /// Windows of several steps: most fly freely.
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
    /// How much closer than its free flight a pair may come that is not computed, in length.
    pub margin: f64,
    /// The speed of the fastest particle.
    pub fastest: f64,
    /// Particles in the area of a cutoff disc, where the mean particle is.
    pub neighbours: f64,
    /// The same per area.
    pub density: f64,
}

/// Reads the scene and decides. `fixed` steps for a window, or 0 to choose; each step is divided
/// into `divide`.
pub fn plan<R: Rules>(bodies: &Bodies, fixed: u32, divide: u32) -> Plan {
    let extent = Extent::of(bodies);
    let density = density(bodies, &extent);
    let neighbours = density * PI * CUTOFF * CUTOFF;
    let mean = Sample::of(bodies, 4096).mean();
    let fastest = bodies.fastest();
    let steps = if fixed > 0 { fixed } else { divided(R::window_length(density, mean), divide) };
    // The list of a window looks as far as the fastest goes; lab 10's leaves that one out.
    let far = CUTOFF + 2.0 * fastest * f64::from(steps) * DT;
    let alone = neighbours <= company(divide) && far * far * density <= FULL;
    let strategy = if fixed > 0 || alone { Strategy::Windows { steps } } else { Strategy::List };
    let margin = CUTOFF * if divide > 1 { SMALL_MARGIN } else { MARGIN };
    Plan { strategy, margin, fastest, neighbours, density }
}

/// Particles in the area of a cutoff disc from which on a list is cheaper than windows, measured on
/// the machine of the book.
const COMPANY: f64 = 0.12;
/// The most particles in a square that is as wide as the list of a window looks.
const FULL: f64 = 20.0;
/// How close free flights come that are computed at once, beyond the cutoff and in cutoffs.
const MARGIN: f64 = 0.05;
/// The same where steps are small and windows short: there a force bends a path by less.
const SMALL_MARGIN: f64 = 0.02;

/// How long a window should be in which groups take `divide` small steps for each of its `steps`.
///
/// Opening a window costs the same however it is divided, but the time that goes into groups grows
/// with the number of particles in them, so with its length, and with `divide`. The sum of both costs
/// per step is least at a length like one over the root of the second; but to open a window for a
/// single step does not pay.
fn divided(steps: u32, divide: u32) -> u32 {
    let length = f64::from(steps) / f64::from(divide.max(1)).sqrt();
    (length as u32).max(steps.min(2))
}

/// As `COMPANY`, if each step is divided into `divide`. Small steps for all cost nearly as many times
/// as much, small steps of groups do not; measured for two to twenty of them.
fn company(divide: u32) -> f64 {
    (COMPANY + 0.25 * f64::from(divide.max(1) - 1)).min(1.2)
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
