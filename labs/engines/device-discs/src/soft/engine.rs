//! The engine: a step is five or more launches, and the particles stay on the device.

use std::cell::{Cell, RefCell};
use std::marker::PhantomData;
use std::time::Instant;

use common::soft::{CUTOFF, Particle, Scene, SceneError, Simulation, Statistics};
use device::{Gpu, GpuError, Readback, Real, Stopwatch, Work};

use super::kernels::SoftKernels;
use super::positions::{CONSTANTS, Grid, Precision};
use super::scene::{Kernels, Loaded, Options};

/// Soft discs on the device, with the kernels `K` in precision `P`.
pub struct SoftDiscs<K, P: Precision> {
    gpu: &'static Gpu,
    kernels: Kernels,
    options: Options,
    stopwatch: Option<Stopwatch>,
    scene: Option<Loaded<P>>,
    readback: RefCell<Readback>,
    /// Seconds for copies between host and device, including the time that the host waited for
    /// them.
    transfer: Cell<f64>,
    in_flight: u32,
    kernels_of: PhantomData<K>,
}

/// The particles' ids after a sort.
#[derive(Debug, PartialEq)]
pub struct Sorted {
    /// The bins.
    pub grid: Grid,
    /// The index of each bin's first particle, and finally the number of particles.
    pub starts: Vec<u32>,
    /// The ids, bin by bin.
    pub ids: Vec<u32>,
}

impl<K: SoftKernels, P: Precision> SoftDiscs<K, P> {
    /// Compiles the kernels. With a stopwatch, each kernel is timed, and every step waits for the
    /// device.
    ///
    /// # Errors
    /// The device cannot compute in this precision or run workgroups of this size.
    pub fn new(
        gpu: &'static Gpu,
        options: Options,
        stopwatch: Option<Stopwatch>,
    ) -> Result<Self, GpuError> {
        gpu.expect_real::<P::Real>()?;
        K::launch(1, options.threads, &gpu.limits())?;
        let alias = P::Real::ALIAS;
        let sort = [K::sort(), K::discs(), alias];
        let step = [K::forces(), P::source::<K>(), K::discs(), CONSTANTS, alias];
        let looks = [("STATISTICS", f64::from(u8::from(options.statistics)))];
        let threads = options.threads;
        let kernels = Kernels {
            count: K::compiled(gpu, "count", &sort, threads, &[])?,
            scatter: K::compiled(gpu, "scatter", &sort, threads, &[])?,
            order: K::compiled(gpu, "order", &sort, threads, &[])?,
            step: K::compiled(gpu, "step", &step, threads, &looks)?,
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
            kernels_of: PhantomData,
        })
    }

    /// Starts from `scene`.
    ///
    /// # Errors
    /// The device has too little memory for the scene.
    pub fn try_load(&mut self, scene: &Scene) -> Result<(), GpuError> {
        self.scene = None;
        let start = Instant::now();
        let loaded = Loaded::new::<K>(self.gpu, &self.kernels, &self.options, scene)?;
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

    /// Sorts the particles into bins without moving them, and returns the result.
    pub fn sort(&self) -> Sorted {
        let scene = self.scene();
        let mut work = Work::new(self.gpu, None);
        K::record_sort(&scene.sort, &mut work);
        let mut readback = self.readback.borrow_mut();
        let [starts] = readback.read(
            self.gpu,
            work,
            [(&scene.sort.starts, 0..u64::from(scene.grid.bins()) + 1)],
        );
        let work = Work::new(self.gpu, None);
        let [tags] = readback.read(self.gpu, work, [(&scene.sorted_tags, 0..scene.n as u64)]);
        let ids = tags.iter().map(|&[_, id]: &[u32; 2]| id).collect();
        Sorted { grid: scene.grid, starts, ids }
    }

    fn scene(&self) -> &Loaded<P> {
        self.scene.as_ref().expect("a scene is loaded before anything else")
    }
}

impl<K: SoftKernels, P: Precision> Simulation for SoftDiscs<K, P> {
    fn load(&mut self, scene: &Scene) {
        self.try_load(scene).unwrap_or_else(|error| panic!("{error}"));
    }

    fn load_official(&mut self, n: u64, seed: u32) -> Result<(), SceneError> {
        let scene = Scene::official(n, seed)?;
        self.try_load(&scene).map_err(|_| SceneError::Memory("particle", n))
    }

    fn step(&mut self) {
        let scene = self.scene();
        scene.host_copy.replace(None);
        let mut work = Work::new(self.gpu, self.stopwatch.as_ref());
        K::record_sort(&scene.sort, &mut work);
        work.launch(&scene.step, scene.sort.launch);
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
        let mut host_copy = scene.host_copy.borrow_mut();
        let particles = host_copy
            .get_or_insert_with(|| scene.download(self.gpu, &mut self.readback.borrow_mut()));
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
        let bytes = u64::from(scene.sort.launch.blocks()) * tally as u64;
        let work = Work::new(self.gpu, None);
        let [tallies] =
            self.readback.borrow_mut().read::<u8, 1>(self.gpu, work, [(&scene.tallies, 0..bytes)]);
        let mut all = Statistics::default();
        for tally in tallies.chunks_exact(tally) {
            let (sums, counts) = tally.split_at(2 * real);
            let [least, sum]: [P::Real; 2] = bytemuck::pod_read_unaligned(sums);
            let counts: [u32; 2] = bytemuck::pod_read_unaligned(counts);
            all.dmin = all.dmin.min(least.into().sqrt() / CUTOFF);
            all.davg += sum.into() / CUTOFF;
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
