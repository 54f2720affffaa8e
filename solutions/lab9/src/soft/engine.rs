//! The engine: a step is five or more launches, and the particles never leave the device.

use std::cell::{Cell, RefCell};
use std::marker::PhantomData;
use std::time::Instant;

use bytemuck::bytes_of;
use common::soft::{CUTOFF, Particle, Scene, SceneError, Simulation, Statistics};
use wgpu::Buffer;

use super::precision::CONSTANTS;
use super::{Grid, Precision, Scan, wgsl};
use crate::gpu::{Bound, Gpu, GpuError, Kernel, Launch, Readback, Real, Stopwatch, Work};

/// Soft discs on the device, in precision `P`.
pub struct SoftDiscs<P: Precision> {
    gpu: &'static Gpu,
    kernels: Kernels,
    options: Options,
    stopwatch: Option<Stopwatch>,
    scene: Option<Loaded<P>>,
    readback: RefCell<Readback>,
    /// Seconds that copies between host and device took, waiting for them included.
    transfer: Cell<f64>,
    in_flight: u32,
}

/// What can be chosen about an engine.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Invocations in a workgroup.
    pub threads: u32,
    /// Least side of a bin, in cutoffs.
    pub bin: f64,
    /// Steps that may be submitted before the host waits.
    pub in_flight: u32,
    /// Whether each step's statistics will be asked for.
    pub statistics: bool,
}

struct Kernels {
    count: Kernel,
    scatter: Kernel,
    order: Kernel,
    step: Kernel,
}

/// A scene on the device.
struct Loaded<P: Precision> {
    n: usize,
    grid: Grid,
    starts: Buffer,
    tags: Buffer,
    places: Buffer,
    velocities: Buffer,
    sorted_tags: Buffer,
    tallies: Buffer,
    count: Bound,
    scan: Scan,
    scatter: Bound,
    order: Bound,
    step: Bound,
    launch: Launch,
    /// The particles as they were when somebody last looked.
    mirror: RefCell<Option<Vec<Particle>>>,
    precision: PhantomData<P>,
}

/// The particles' ids as one sort leaves them.
#[derive(Debug, PartialEq)]
pub struct Sorted {
    /// The bins.
    pub grid: Grid,
    /// Where each bin begins, and at last the number of particles.
    pub starts: Vec<u32>,
    /// The ids, bin by bin.
    pub ids: Vec<u32>,
}

impl<P: Precision> SoftDiscs<P> {
    /// Compiles the kernels. With a stopwatch each is timed, and every step waits.
    ///
    /// # Errors
    /// The device cannot compute in this precision or run workgroups of this size.
    pub fn new(
        gpu: &'static Gpu,
        options: Options,
        stopwatch: Option<Stopwatch>,
    ) -> Result<Self, GpuError> {
        gpu.expect_real::<P::Real>()?;
        Launch::new(1, options.threads, &gpu.limits())?;
        let shared = include_str!("discs.wgsl");
        let alias = P::Real::ALIAS;
        let sort = [wgsl::sort(), shared, alias];
        let step = [wgsl::step(), P::source(), shared, CONSTANTS, alias];
        let looks = [("STATISTICS", f64::from(u8::from(options.statistics)))];
        let sorting = |name| Kernel::new(gpu, name, &sort, options.threads, &[]);
        let kernels = Kernels {
            count: sorting("count")?,
            scatter: sorting("scatter")?,
            order: sorting("order")?,
            step: Kernel::new(gpu, "step", &step, options.threads, &looks)?,
        };
        Ok(Self {
            gpu,
            kernels,
            options,
            stopwatch,
            scene: None,
            readback: RefCell::default(),
            transfer: Cell::new(0.0),
            in_flight: 0,
        })
    }

    /// Starts over from `scene`.
    ///
    /// # Errors
    /// The device has not the memory for it.
    pub fn try_load(&mut self, scene: &Scene) -> Result<(), GpuError> {
        self.scene = None;
        let start = Instant::now();
        let loaded = Loaded::new(self.gpu, &self.kernels, &self.options, scene)?;
        self.gpu.queue.submit([]);
        self.gpu.wait();
        self.transfer.set(start.elapsed().as_secs_f64());
        self.scene = Some(loaded);
        self.in_flight = 0;
        if let Some(stopwatch) = &self.stopwatch {
            stopwatch.reset();
        }
        Ok(())
    }

    /// Sorts the particles into bins, and moves none.
    pub fn sort(&self) -> Sorted {
        let scene = self.scene();
        let mut work = Work::new(self.gpu, None);
        scene.record_sort(&mut work);
        let mut readback = self.readback.borrow_mut();
        let [starts] =
            readback.read(self.gpu, work, [(&scene.starts, 0..u64::from(scene.grid.bins()) + 1)]);
        let work = Work::new(self.gpu, None);
        let [tags] = readback.read(self.gpu, work, [(&scene.sorted_tags, 0..scene.n as u64)]);
        let ids = tags.iter().map(|&[_, id]: &[u32; 2]| id).collect();
        Sorted { grid: scene.grid, starts, ids }
    }

    fn scene(&self) -> &Loaded<P> {
        self.scene.as_ref().expect("a scene is loaded before anything else")
    }
}

impl<P: Precision> Loaded<P> {
    fn new(
        gpu: &Gpu,
        kernels: &Kernels,
        options: &Options,
        scene: &Scene,
    ) -> Result<Self, GpuError> {
        let n = scene.len();
        let grid = Grid::new(scene.size(), n, options.bin);
        let launch = Launch::over(n as u32, options.threads, &gpu.limits())?;
        let pairs = (n * 2 * size_of::<P::Real>()) as u64;
        let words = n as u64 * 4;
        let tally = 2 * size_of::<P::Real>() as u64 + 8;

        let starts = gpu.storage("the bins", (u64::from(grid.bins()) + 1) * 4)?;
        let tags = gpu.storage("the particles' tags", 2 * words)?;
        let places = gpu.storage("the particles' places", pairs)?;
        let velocities = gpu.storage("the particles' velocities", pairs)?;
        let sorted_tags = gpu.storage("the particles' tags", 2 * words)?;
        let sorted_places = gpu.storage("the particles' places", pairs)?;
        let sorted_velocities = gpu.storage("the particles' velocities", pairs)?;
        let arrivals = gpu.storage("the particles' arrivals", words)?;
        let slots = gpu.storage("the bins' slots", words)?;
        let tallies = gpu.storage("the statistics", u64::from(launch.blocks()) * tally)?;

        let numbers = [P::Real::of(grid.size), P::Real::of(grid.side)];
        let parameters = [bytes_of(&[n as u32, grid.columns]), bytes_of(&numbers)].concat();
        let area = gpu.uniform(&parameters);
        let written: Vec<_> = scene.particles().iter().map(|p| (P::write(p, &grid), p)).collect();
        let with_id = |&((bin, _), p): &((u32, _), &Particle)| [bin, p.id];
        gpu.upload(&tags, &written.iter().map(with_id).collect::<Vec<_>>());
        gpu.upload(&places, &written.iter().map(|((_, place), _)| *place).collect::<Vec<_>>());
        let velocity = |p: &Particle| [P::Real::of(p.vx), P::Real::of(p.vy)];
        gpu.upload(&velocities, &scene.particles().iter().map(velocity).collect::<Vec<_>>());

        let count = [(0, &area), (1, &starts), (2, &tags), (8, &arrivals)];
        let scatter = [(0, &area), (1, &starts), (2, &tags), (8, &arrivals), (9, &slots)];
        let before = [(2, &tags), (3, &places), (4, &velocities)];
        let after = [(5, &sorted_tags), (6, &sorted_places), (7, &sorted_velocities)];
        let both = [[(0, &area), (1, &starts)].as_slice(), &before, &after].concat();
        let with = |more| [both.as_slice(), &[more]].concat();
        Ok(Self {
            n,
            grid,
            count: kernels.count.bind(gpu, &count),
            scan: Scan::new(gpu, &starts, grid.bins() + 1, options.threads)?,
            scatter: kernels.scatter.bind(gpu, &scatter),
            order: kernels.order.bind(gpu, &with((9, &slots))),
            step: kernels.step.bind(gpu, &with((8, &tallies))),
            launch,
            starts,
            tags,
            places,
            velocities,
            sorted_tags,
            tallies,
            mirror: RefCell::default(),
            precision: PhantomData,
        })
    }

    /// Writes down the launches that sort the particles: the tags, places and velocities of the
    /// last step go to the sorted arrays, and `starts` says where each bin begins.
    ///
    /// - `starts` is counted up from zero by the kernel `count`;
    /// - `scan` turns the counts into starts ([`Scan::record`]);
    /// - `scatter` gives each particle a slot in its bin, `order` copies it to its place.
    ///
    /// All three kernels run once for each particle: `self.launch`.
    ///
    /// Book: chapter 9, *A counting sort*.
    fn record_sort(&self, work: &mut Work<'_>) {
        // task 9.7d: the launches of a sort
        work.clear(&self.starts);
        work.launch(&self.count, self.launch);
        self.scan.record(work);
        work.launch(&self.scatter, self.launch);
        work.launch(&self.order, self.launch);
        // end 9.7d
    }

    fn download(&self, gpu: &Gpu, readback: &mut Readback) -> Vec<Particle> {
        let n = self.n as u64;
        let [tags] = readback.read::<[u32; 2], 1>(gpu, Work::new(gpu, None), [(&self.tags, 0..n)]);
        let numbers = [(&self.places, 0..2 * n), (&self.velocities, 0..2 * n)];
        let [places, velocities] = readback.read::<P::Real, 2>(gpu, Work::new(gpu, None), numbers);
        let unsorted = tags.iter().zip(places.chunks_exact(2)).zip(velocities.chunks_exact(2));
        let mut particles = vec![Particle::default(); self.n];
        for ((&[bin, id], place), velocity) in unsorted {
            let [x, y] = P::read(bin, [place[0], place[1]], &self.grid);
            let (vx, vy) = (velocity[0].into(), velocity[1].into());
            particles[id as usize] = Particle { x, y, vx, vy, id };
        }
        particles
    }
}

impl<P: Precision> Simulation for SoftDiscs<P> {
    fn load(&mut self, scene: &Scene) {
        self.try_load(scene).unwrap_or_else(|error| panic!("{error}"));
    }

    fn load_official(&mut self, n: u64, seed: u32) -> Result<(), SceneError> {
        let scene = Scene::official(n, seed)?;
        self.try_load(&scene).map_err(|_| SceneError::Memory(n))
    }

    fn step(&mut self) {
        let scene = self.scene();
        scene.mirror.replace(None);
        let mut work = Work::new(self.gpu, self.stopwatch.as_ref());
        scene.record_sort(&mut work);
        work.launch(&scene.step, scene.launch);
        work.submit();
        self.in_flight += 1;
        if self.in_flight >= self.options.in_flight {
            self.gpu.wait();
            self.in_flight = 0;
        }
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        let start = Instant::now();
        let scene = self.scene();
        let mut mirror = scene.mirror.borrow_mut();
        let particles =
            mirror.get_or_insert_with(|| scene.download(self.gpu, &mut self.readback.borrow_mut()));
        out.copy_from_slice(&particles[first..first + out.len()]);
        self.transfer.set(self.transfer.get() + start.elapsed().as_secs_f64());
    }

    fn statistics(&self) -> Option<Statistics> {
        if !self.options.statistics {
            return None;
        }
        let start = Instant::now();
        let scene = self.scene();
        let real = size_of::<P::Real>();
        let tally = 2 * real + 8;
        let bytes = u64::from(scene.launch.blocks()) * tally as u64;
        let work = Work::new(self.gpu, None);
        let [tallies] =
            self.readback.borrow_mut().read::<u8, 1>(self.gpu, work, [(&scene.tallies, 0..bytes)]);
        let mut all = Statistics::default();
        for tally in tallies.chunks_exact(tally) {
            let number = |k: usize| -> f64 {
                bytemuck::pod_read_unaligned::<P::Real>(&tally[k * real..(k + 1) * real]).into()
            };
            let counts: [u32; 2] = bytemuck::pod_read_unaligned(&tally[2 * real..]);
            all.dmin = all.dmin.min(number(0).sqrt() / CUTOFF);
            all.davg += number(1) / CUTOFF;
            all.navg += u64::from(counts[0]);
            all.pair_tests += u64::from(counts[1]);
        }
        self.transfer.set(self.transfer.get() + start.elapsed().as_secs_f64());
        Some(all)
    }

    fn counters(&self) -> Vec<(&'static str, f64)> {
        let mut counters = vec![("transfer time [s]", self.transfer.get())];
        if let Some(stopwatch) = &self.stopwatch {
            let seconds = stopwatch.seconds();
            counters.push(("kernel time [s]", seconds.iter().map(|(_, s)| s).sum()));
            counters.extend(seconds);
        }
        counters
    }
}
