//! What the engine asks for.

use device::{Launcher, Work};

use super::scan::{Scan, Sort};

/// The kernels of a step, in WGSL, and the order of their launches.
///
/// All kernels see `real`, the number that they compute with, and `invocation` and `invocations` of the crate
/// [`device`]. Those of the sort and of the forces are compiled with [`discs`](Self::discs) and bound to
///
/// | binding | type | what |
/// |---|---|---|
/// | 0 | uniform | number of particles, columns of bins (u32), sides of the box and of a bin (`real`) |
/// | 1 | `array<u32>` | the starts of the bins, and the number of particles |
/// | 2, 3, 4 | `array<vec2<u32>>`, twice `array<vec2<real>>` | (bin, id), position and velocity of each particle |
/// | 5, 6, 7 | the same | the same, sorted by bin and within a bin by id |
/// | 8 | `array<u32>`, or 2 `real` and 2 `u32` for each workgroup | what a particle's rank of arrival in its bin is; in the step, least r², sum of r, pairs and pair tests |
/// | 9 | `array<u32>` | the particles' numbers by bin, in the order of arrival |
pub trait SoftKernels: Launcher + Sized + 'static {
    /// What the kernels share: the box and the particles.
    fn discs() -> &'static str;

    /// The kernels `scan_blocks` and `add_sums` of a prefix sum: binding 0 the numbers, binding 1 the sums of
    /// their blocks. They see the functions `put`, `fetch` and `meet` of a workgroup's shared numbers, and set `own`.
    fn scan() -> &'static str;

    /// The kernels `count`, `scatter` and `order` of a counting sort.
    fn sort() -> &'static str;

    /// The kernel `step`. It sees `CUTOFF`, `MIN_R`, `MASS` and `DT`, and the functions `separation` and `advance`
    /// of the positions; it looks at `STATISTICS`.
    fn forces() -> &'static str;

    /// The functions `separation` and `advance` of positions in single precision, relative to their bins.
    fn position_f32() -> &'static str;

    /// Writes down the launches of a prefix sum of any length.
    fn record_scan(scan: &Scan, work: &mut Work<'_>);

    /// Writes down the launches of a counting sort.
    fn record_sort(sort: &Sort, work: &mut Work<'_>);
}
