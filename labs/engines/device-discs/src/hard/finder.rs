//! The search for candidates with kernels on the device.

use std::marker::PhantomData;
use std::ops::Range;

use common::hard::Disc;
use device::{Bound, Gpu, GpuError, Kernel, Launch, Readback, Real, Stopwatch, Work};
use solution7::Square;
use wgpu::Buffer;

use super::kernels::{HardKernels, Launches, Search};
use super::margins::Margins;

/// The second number of a candidate that consists of a disc and a wall.
pub const WALL: u32 = u32::MAX;

/// Capacity of the first list, in candidates.
const FIRST_CAPACITY: u64 = 1024;

/// The distribution of the work to the invocations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Deal {
    /// An invocation tests a disc with the walls and with all discs after it.
    Discs,
    /// An invocation tests numbered pairs. Another kernel tests the walls.
    Pairs,
}

/// A search for the discs that may collide, on the device, with the kernels `K` in precision `R`.
pub struct Finder<K, R> {
    gpu: &'static Gpu,
    kernels: Vec<Kernel>,
    launch: Launch,
    stopwatch: Option<Stopwatch>,
    readback: Readback,
    parameters: Buffer,
    discs: Buffer,
    count: Buffer,
    candidates: Buffer,
    bound: Vec<Bound>,
    capacity: u64,
    /// Greatest number of candidates that the device has memory for.
    most: u64,
    /// Number of discs, and the bounds of the filter for them.
    n: u32,
    margins: Margins,
    parts: PhantomData<(K, R)>,
}

impl<K: HardKernels, R: Real> Finder<K, R> {
    /// Compiles the kernels of a `deal`, to be run with `launch`.
    ///
    /// # Errors
    /// The device cannot compute with `R`, or refuses a kernel.
    pub fn new(
        gpu: &'static Gpu,
        deal: Deal,
        launch: Launch,
        stopwatch: Option<Stopwatch>,
    ) -> Result<Self, GpuError> {
        gpu.expect_real::<R>()?;
        let (source, names): (_, &[_]) = match deal {
            Deal::Discs => (K::basic(), &["find_collisions"]),
            Deal::Pairs => (K::balanced(), &["find_walls", "find_pairs"]),
        };
        let sources = [source, K::filter(), R::ALIAS];
        let kernels =
            names.iter().map(|name| K::compiled(gpu, name, &sources, launch.threads, &[]));
        let mut finder = Self {
            gpu,
            kernels: kernels.collect::<Result<_, _>>()?,
            launch,
            stopwatch,
            readback: Readback::default(),
            parameters: gpu.uniform(&vec![0; 16 + 4 * size_of::<R>()]),
            discs: gpu.storage("the discs", 4 * size_of::<R>() as u64)?,
            count: gpu.storage("the number of candidates", 4)?,
            candidates: gpu.storage("the candidates", FIRST_CAPACITY * 8)?,
            bound: Vec::new(),
            capacity: FIRST_CAPACITY,
            most: gpu.most_bytes() / 8,
            n: 0,
            margins: Margins::default(),
            parts: PhantomData,
        };
        finder.bind();
        Ok(finder)
    }

    /// Limits the list to `most` candidates, so that a test can try the search with little memory.
    #[must_use]
    pub fn with_room_for(self, most: u64) -> Self {
        Self { most: most.min(self.most), ..self }
    }

    /// Fills `found` with the candidates of this step: pairs a < b, and (a, [`WALL`]) for walls.
    ///
    /// Each candidate occurs once, in any order. If `margins` were computed for these discs, no
    /// collision is missing.
    ///
    /// # Errors
    /// The device has too little memory for the discs.
    pub fn find(
        &mut self,
        discs: &[Disc],
        margins: Margins,
        square: Square,
        found: &mut Vec<[u32; 2]>,
    ) -> Result<(), GpuError> {
        found.clear();
        let bytes = discs.len() as u64 * 4 * size_of::<R>() as u64;
        if self.discs.size() < bytes {
            self.discs = self.gpu.storage("the discs", bytes)?;
            self.bind();
        }
        let numbers = discs.iter().map(|disc| {
            [disc.x, disc.y, disc.vx, disc.vy].map(|number| R::of(number / square.side))
        });
        self.gpu.upload(&self.discs, &numbers.collect::<Vec<_>>());
        // A launch counts candidates in 32 bits, so it may test at most 2³² pairs.
        let n = discs.len() as u32;
        self.n = n;
        self.margins = margins;
        let rows = ((1_u64 << 32) / u64::from(n) - 1).clamp(1, u64::from(n)) as u32;
        for first in (0..n).step_by(rows as usize) {
            K::collect(self, first..n.min(first.saturating_add(rows)), found)?;
        }
        Ok(())
    }

    fn bind(&mut self) {
        let buffers =
            [(0, &self.parameters), (1, &self.discs), (2, &self.count), (3, &self.candidates)];
        self.bound = self.kernels.iter().map(|kernel| kernel.bind(self.gpu, &buffers)).collect();
    }

    /// Returns the clock, if there is one.
    pub fn stopwatch(&self) -> Option<&Stopwatch> {
        self.stopwatch.as_ref()
    }
}

impl<K: HardKernels, R: Real> Search for Finder<K, R> {
    fn run(&mut self, rows: Range<u32>) -> u64 {
        self.gpu.upload(&self.parameters, &self.margins.bytes::<R>(self.n, rows));
        let mut work = Work::new(self.gpu, self.stopwatch.as_ref());
        let launches = Launches { kernels: &self.bound, launch: self.launch, count: &self.count };
        K::record(launches, &mut work);
        let [count] = self.readback.read::<u32, 1>(self.gpu, work, [(&self.count, 0..1)]);
        u64::from(count[0])
    }

    fn capacity(&self) -> u64 {
        self.capacity
    }

    fn grow(&mut self, count: u64) -> Result<(), GpuError> {
        if count > self.most {
            return Err(GpuError::Memory {
                what: "the candidates",
                bytes: count * 8,
                most: self.most * 8,
                name: self.gpu.name(),
            });
        }
        let capacity = count.next_power_of_two().min(self.most);
        self.candidates = self.gpu.storage("the candidates", capacity * 8)?;
        self.capacity = capacity;
        self.bind();
        Ok(())
    }

    fn fetch(&mut self, count: u64, found: &mut Vec<[u32; 2]>) {
        let work = Work::new(self.gpu, None);
        let [mut list] = self.readback.read(self.gpu, work, [(&self.candidates, 0..count)]);
        found.append(&mut list);
    }
}
