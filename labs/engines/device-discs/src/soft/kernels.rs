//! The kernels that the engine runs.

use device::{Launcher, Work};

use super::scan::{Scan, Sort};

/// The kernels of a step, in WGSL, and the order of their launches.
///
/// All kernels can use `real`, the number type, and the functions `invocation` and `invocations` of
/// the crate [`device`]. The kernels of the sort and of the forces are compiled with
/// [`discs`](Self::discs) and bound to these buffers:
///
/// | binding | type | contents |
/// |---|---|---|
/// | 0 | uniform | number of particles, columns of bins (u32), sides of the box and of a bin (`real`) |
/// | 1 | `array<u32>` | the starts of the bins, and the number of particles |
/// | 2, 3, 4 | `array<vec2<u32>>`, twice `array<vec2<real>>` | (bin, id), position and velocity of each particle |
/// | 5, 6, 7 | the same | the same, sorted by bin and within a bin by id |
/// | 8 | `array<u32>` | during the sort: the rank of each particle by its arrival in its bin |
/// | 8 | 2 `real`, 2 `u32` per workgroup | during the step: least r², sum of r, pairs, pair tests |
/// | 9 | `array<u32>` | the particles' numbers by bin, in the order of arrival |
pub trait SoftKernels: Launcher + Sized + 'static {
    /// Returns the declarations that the kernels share: the box and the particles.
    fn discs() -> &'static str;

    /// Returns the kernels `scan_blocks` and `add_sums` of a prefix sum.
    ///
    /// Binding 0 contains the numbers, and binding 1 the sums of their blocks. The kernels can call
    /// `put`, `fetch` and `meet` for a workgroup's shared numbers, and must set `own`.
    fn scan() -> &'static str;

    /// Returns the kernels `count`, `scatter` and `order` of a counting sort.
    fn sort() -> &'static str;

    /// Returns the kernel `step`.
    ///
    /// The kernel can use the constants `CUTOFF`, `MIN_R`, `MASS`, `DT` and `STATISTICS`, and the
    /// functions `separation` and `advance` of the positions.
    fn forces() -> &'static str;

    /// Returns the functions `separation` and `advance` of single-precision positions, relative to
    /// their bins.
    fn position_f32() -> &'static str;

    /// Records the launches of a prefix sum of any length.
    fn record_scan(scan: &Scan, work: &mut Work<'_>);

    /// Records the launches of a counting sort.
    fn record_sort(sort: &Sort, work: &mut Work<'_>);
}
