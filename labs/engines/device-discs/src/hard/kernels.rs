//! The kernels that the engine runs, and the host's part of the search.

use std::ops::Range;

use common::hard::Disc;
use device::{Bound, GpuError, Launch, Launcher, Work};
use solution7::{Candidate, Square};
use wgpu::Buffer;

/// A search on the device with a list of candidates that can grow.
pub trait Search {
    /// Runs the kernels on some rows and returns the number of candidates found.
    fn run(&mut self, rows: Range<u32>) -> u64;

    /// Returns the number of candidates that the list has room for.
    fn capacity(&self) -> u64;

    /// Makes room for at least `count` candidates. The list loses its contents.
    ///
    /// # Errors
    /// The device has too little memory for these candidates.
    fn grow(&mut self, count: u64) -> Result<(), GpuError>;

    /// Adds the first `count` candidates of the list to `found`.
    fn fetch(&mut self, count: u64, found: &mut Vec<[u32; 2]>);
}

/// The launches of a search.
#[derive(Clone, Copy)]
pub struct Launches<'a> {
    pub(super) kernels: &'a [Bound],
    pub(super) launch: Launch,
    pub(super) count: &'a Buffer,
}

impl<'a> Launches<'a> {
    /// Returns the kernels in their order, bound to their buffers.
    pub fn kernels(&self) -> &'a [Bound] {
        self.kernels
    }

    /// Returns the launch of each kernel.
    pub fn launch(&self) -> Launch {
        self.launch
    }

    /// Returns the buffer for the number of candidates, one u32.
    pub fn count(&self) -> &'a Buffer {
        self.count
    }
}

/// The kernels of the search and of the choice, in WGSL, and the host's part of the search.
///
/// All kernels can use `real`, the number type, and the functions `invocation` and `invocations` of
/// the crate [`device`]. The kernels of the search are compiled with [`filter`](Self::filter) and
/// bound to these buffers:
///
/// | binding | type | contents |
/// |---|---|---|
/// | 0 | uniform | numbers of discs and rows, bounds: [`Margins::bytes`](super::Margins::bytes) |
/// | 1 | `array<vec4<real>>` | (x, y, vx, vy) of each disc, in sides of the square |
/// | 2 | `atomic<u32>` | number of candidates |
/// | 3 | `array<vec2<u32>>` | the candidates, as many as there is room for |
pub trait HardKernels: Launcher + Sized + 'static {
    /// Returns the functions of the search: the test of a pair, and a list that many invocations
    /// append to.
    fn filter() -> &'static str;

    /// Returns the kernel `find_collisions`: a row of work is a disc with all discs after it.
    fn basic() -> &'static str;

    /// Returns two kernels: `find_walls` tests all walls, and `find_pairs` tests numbered pairs.
    fn balanced() -> &'static str;

    /// Returns the kernels of a round of the choice: `forget`, `least_high`, `least_low`,
    /// `least_rank`, `take`.
    fn choose() -> &'static str;

    /// Adds all candidates of the rows `rows` to `found`, in any order.
    ///
    /// # Errors
    /// The device has too little memory for the candidates of a single row.
    fn collect(
        finder: &mut dyn Search,
        rows: Range<u32>,
        found: &mut Vec<[u32; 2]>,
    ) -> Result<(), GpuError>;

    /// Records the launches that find the candidates and count them from zero.
    fn record(finder: Launches<'_>, work: &mut Work<'_>);

    /// Fills `candidates` with the members of `found` that collide, and their times.
    ///
    /// A member is (a, b) with a < b, or (a, [`WALL`](super::WALL)).
    fn confirm(discs: &[Disc], square: Square, found: &[[u32; 2]], candidates: &mut Vec<Candidate>);
}
