//! The bins, and the two ways to store a position: f64 from the corner of the box, f32 from that of
//! the bin.

use common::soft::{CUTOFF, Particle};
use device::Real;

use super::kernels::SoftKernels;

/// How the box is divided: `columns` × `columns` bins of side `side`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    /// Side of the box.
    pub size: f64,
    /// Bins along x, and as many along y.
    pub columns: u32,
    /// Side of a bin, `size / columns`.
    pub side: f64,
}

/// Bins are so much wider than the cutoff that no rounding, not even that of single precision,
/// lets two particles at the cutoff be two bins apart.
const SLACK: f64 = 1.0 + 1.0 / (1 << 20) as f64;

impl Grid {
    /// Bins of at least `bin` cutoffs (1 or more) in a box of side `size`, but not many more than
    /// the `n` particles in it: an empty plain needs no bins.
    pub fn new(size: f64, n: usize, bin: f64) -> Self {
        let most = (8.0 * n as f64).sqrt().clamp(64.0, 46_340.0);
        let columns = (size / (CUTOFF * bin * SLACK)).floor().clamp(1.0, most);
        Self { size, columns: columns as u32, side: size / columns }
    }

    /// Number of bins.
    pub fn bins(&self) -> u32 {
        self.columns * self.columns
    }

    /// The column of coordinate `x`, or the row of `y`. The far wall belongs to the last.
    pub fn column(&self, x: f64) -> u32 {
        ((x / self.side) as u32).min(self.columns - 1)
    }
}

/// How positions are stored on the device.
pub trait Precision: 'static {
    /// The number that the kernels compute with.
    type Real: Real;

    /// The functions `separation` and `advance`, for the kernels `K`.
    fn source<K: SoftKernels>() -> &'static str;

    /// Where the particle is: its bin, and its position as the device stores it.
    fn write(particle: &Particle, grid: &Grid) -> (u32, [Self::Real; 2]);

    /// The coordinates of a position, from its bin.
    fn read(bin: u32, position: [Self::Real; 2], grid: &Grid) -> [f64; 2];
}

/// Double precision.
pub struct Double;

/// Single precision, relative to the bin.
pub struct Single;

/// The constants of chapter 1, in WGSL.
pub(super) const CONSTANTS: &str = "
const CUTOFF: real = 0.01;
const MIN_R: real = 0.0001;
const MASS: real = 0.01;
const DT: real = 0.0005;
";

impl Precision for Double {
    type Real = f64;

    fn source<K: SoftKernels>() -> &'static str {
        include_str!("position_f64.wgsl")
    }

    fn write(particle: &Particle, grid: &Grid) -> (u32, [f64; 2]) {
        let bin = grid.column(particle.y) * grid.columns + grid.column(particle.x);
        (bin, [particle.x, particle.y])
    }

    fn read(_bin: u32, position: [f64; 2], _grid: &Grid) -> [f64; 2] {
        position
    }
}

impl Precision for Single {
    type Real = f32;

    fn source<K: SoftKernels>() -> &'static str {
        K::position_f32()
    }

    fn write(particle: &Particle, grid: &Grid) -> (u32, [f32; 2]) {
        let place = [particle.x, particle.y];
        let [column, row] = place.map(|x| grid.column(x));
        let offset = place.map(|x| (x / grid.side - f64::from(grid.column(x))) as f32);
        (row * grid.columns + column, offset)
    }

    fn read(bin: u32, position: [f32; 2], grid: &Grid) -> [f64; 2] {
        let column = f64::from(bin % grid.columns) + f64::from(position[0]);
        let row = f64::from(bin / grid.columns) + f64::from(position[1]);
        [column, row].map(|x| (x * grid.side).min(grid.size))
    }
}
