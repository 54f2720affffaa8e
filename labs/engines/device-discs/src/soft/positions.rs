//! The bins, and two ways to store positions: f64 from the box's corner, or f32 from the bin's
//! corner.

use common::soft::{CUTOFF, Particle};
use device::Real;

use super::kernels::SoftKernels;

/// The division of the box into `columns` × `columns` bins of side `side`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    /// Side of the box.
    pub size: f64,
    /// Number of bins along x, and also along y.
    pub columns: u32,
    /// Side of a bin, `size / columns`.
    pub side: f64,
}

/// Factor by which bins are wider than the cutoff.
///
/// The factor is so large that rounding, even to single precision, never puts two particles one
/// cutoff apart into bins that are not adjacent.
const SLACK: f64 = 1.0 + 1.0 / (1 << 20) as f64;

impl Grid {
    /// Makes bins of at least `bin` cutoffs (1 or more) in a box of side `size`.
    ///
    /// There are not many more bins than the `n` particles, because empty parts of the box need no
    /// bins.
    pub fn new(size: f64, n: usize, bin: f64) -> Self {
        let most = (8.0 * n as f64).sqrt().clamp(64.0, 46_340.0);
        let columns = (size / (CUTOFF * bin * SLACK)).floor().clamp(1.0, most);
        Self { size, columns: columns as u32, side: size / columns }
    }

    /// Returns the number of bins.
    pub fn bins(&self) -> u32 {
        self.columns * self.columns
    }

    /// Returns the column of coordinate `x`, or the row of `y`. The far wall belongs to the last
    /// column.
    pub fn column(&self, x: f64) -> u32 {
        ((x / self.side) as u32).min(self.columns - 1)
    }
}

/// A way to store positions on the device.
pub trait Precision: 'static {
    /// The number type that the kernels compute with.
    type Real: Real;

    /// Returns the functions `separation` and `advance`, for the kernels `K`.
    fn source<K: SoftKernels>() -> &'static str;

    /// Returns the particle's bin, and its position in the device's form.
    fn write(particle: &Particle, grid: &Grid) -> (u32, [Self::Real; 2]);

    /// Returns the coordinates of a position, from its bin and its form on the device.
    fn read(bin: u32, position: [Self::Real; 2], grid: &Grid) -> [f64; 2];
}

/// Positions in double precision.
pub struct Double;

/// Positions in single precision, relative to the bin.
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
