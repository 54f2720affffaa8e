//! A scene on the device: its buffers, and the kernels bound to them.

use std::cell::RefCell;
use std::marker::PhantomData;

use bytemuck::bytes_of;
use common::soft::{Particle, Scene};
use device::{Bound, Gpu, GpuError, Kernel, Readback, Real, Work};
use wgpu::Buffer;

use super::kernels::SoftKernels;
use super::positions::{Grid, Precision};
use super::scan::{Scan, Sort};

/// The options of an engine.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Number of invocations in a workgroup.
    pub threads: u32,
    /// Least side of a bin, in cutoffs.
    pub bin: f64,
    /// Number of steps that may be submitted before the host waits.
    pub in_flight: u32,
    /// Whether each step computes statistics.
    pub statistics: bool,
}

/// The kernels of a step.
pub(super) struct Kernels {
    pub(super) count: Kernel,
    pub(super) scatter: Kernel,
    pub(super) order: Kernel,
    pub(super) step: Kernel,
}

/// A scene on the device.
pub(super) struct Loaded<P: Precision> {
    pub(super) n: usize,
    pub(super) grid: Grid,
    pub(super) sort: Sort,
    pub(super) step: Bound,
    tags: Buffer,
    positions: Buffer,
    velocities: Buffer,
    pub(super) sorted_tags: Buffer,
    pub(super) tallies: Buffer,
    /// The particles as they were last read, or `None` if they have moved since.
    pub(super) host_copy: RefCell<Option<Vec<Particle>>>,
    precision: PhantomData<P>,
}

impl<P: Precision> Loaded<P> {
    pub(super) fn new<K: SoftKernels>(
        gpu: &Gpu,
        kernels: &Kernels,
        options: &Options,
        scene: &Scene,
    ) -> Result<Self, GpuError> {
        let n = scene.len();
        let grid = Grid::new(scene.size(), n, options.bin);
        let launch = K::launch_over(n as u32, options.threads, &gpu.limits())?;
        let pairs = (n * 2 * size_of::<P::Real>()) as u64;
        let words = n as u64 * 4;
        let tally = 2 * size_of::<P::Real>() as u64 + 8;

        let starts = gpu.storage("the bins", (u64::from(grid.bins()) + 1) * 4)?;
        let tags = gpu.storage("the particles' tags", 2 * words)?;
        let positions = gpu.storage("the particles' positions", pairs)?;
        let velocities = gpu.storage("the particles' velocities", pairs)?;
        let sorted_tags = gpu.storage("the particles' tags", 2 * words)?;
        let sorted_positions = gpu.storage("the particles' positions", pairs)?;
        let sorted_velocities = gpu.storage("the particles' velocities", pairs)?;
        let arrivals = gpu.storage("the particles' arrivals", words)?;
        let slots = gpu.storage("the bins' slots", words)?;
        let tallies = gpu.storage("the statistics", u64::from(launch.blocks()) * tally)?;

        let numbers = [P::Real::of(grid.size), P::Real::of(grid.side)];
        let area = gpu.uniform(&[bytes_of(&[n as u32, grid.columns]), bytes_of(&numbers)].concat());
        let count = [(0, &area), (1, &starts), (2, &tags), (8, &arrivals)];
        let scatter = [(0, &area), (1, &starts), (2, &tags), (8, &arrivals), (9, &slots)];
        let before = [(2, &tags), (3, &positions), (4, &velocities)];
        let after = [(5, &sorted_tags), (6, &sorted_positions), (7, &sorted_velocities)];
        let both = [[(0, &area), (1, &starts)].as_slice(), &before, &after].concat();
        let with = |more| [both.as_slice(), &[more]].concat();
        let sort = Sort {
            count: kernels.count.bind(gpu, &count),
            scan: Scan::new::<K>(gpu, &starts, grid.bins() + 1, options.threads)?,
            scatter: kernels.scatter.bind(gpu, &scatter),
            order: kernels.order.bind(gpu, &with((9, &slots))),
            starts: starts.clone(),
            launch,
        };
        let step = kernels.step.bind(gpu, &with((8, &tallies)));
        let loaded = Self {
            n,
            grid,
            sort,
            step,
            tags,
            positions,
            velocities,
            sorted_tags,
            tallies,
            host_copy: RefCell::default(),
            precision: PhantomData,
        };
        loaded.upload(gpu, scene.particles());
        Ok(loaded)
    }

    fn upload(&self, gpu: &Gpu, particles: &[Particle]) {
        let written: Vec<_> = particles.iter().map(|p| P::write(p, &self.grid)).collect();
        let tags = written.iter().zip(particles).map(|((bin, _), p)| [*bin, p.id]);
        gpu.upload(&self.tags, &tags.collect::<Vec<_>>());
        let positions = written.iter().map(|(_, position)| *position);
        gpu.upload(&self.positions, &positions.collect::<Vec<_>>());
        let velocities = particles.iter().map(|p| [P::Real::of(p.vx), P::Real::of(p.vy)]);
        gpu.upload(&self.velocities, &velocities.collect::<Vec<_>>());
    }

    pub(super) fn download(&self, gpu: &Gpu, readback: &mut Readback) -> Vec<Particle> {
        let n = self.n as u64;
        let [tags] = readback.read::<[u32; 2], 1>(gpu, Work::new(gpu, None), [(&self.tags, 0..n)]);
        let numbers = [(&self.positions, 0..2 * n), (&self.velocities, 0..2 * n)];
        let [positions, velocities] =
            readback.read::<P::Real, 2>(gpu, Work::new(gpu, None), numbers);
        let unsorted = tags.iter().zip(positions.chunks_exact(2)).zip(velocities.chunks_exact(2));
        let mut particles = vec![Particle::default(); self.n];
        for ((&[bin, id], position), velocity) in unsorted {
            let [x, y] = P::read(bin, [position[0], position[1]], &self.grid);
            particles[id as usize] =
                Particle { x, y, vx: velocity[0].into(), vy: velocity[1].into(), id };
        }
        particles
    }
}
