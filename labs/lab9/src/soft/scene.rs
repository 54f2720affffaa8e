//! A scene on the device: its buffers, and the kernels bound to them.

use std::cell::RefCell;
use std::marker::PhantomData;

use bytemuck::bytes_of;
use common::soft::{Particle, Scene};
use wgpu::Buffer;

use super::{Grid, Precision, Scan};
use crate::Launch;
use crate::gpu::{Bound, Gpu, GpuError, Kernel, Readback, Real, Work};

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

/// The kernels of a step.
pub(super) struct Kernels {
    pub(super) count: Kernel,
    pub(super) scatter: Kernel,
    pub(super) order: Kernel,
    pub(super) step: Kernel,
}

/// A scene on the device.
pub(crate) struct Loaded<P: Precision> {
    pub(crate) n: usize,
    pub(crate) grid: Grid,
    pub(crate) starts: Buffer,
    pub(crate) tags: Buffer,
    pub(crate) positions: Buffer,
    pub(crate) velocities: Buffer,
    pub(crate) sorted_tags: Buffer,
    pub(crate) tallies: Buffer,
    pub(crate) count: Bound,
    pub(crate) scan: Scan,
    pub(crate) scatter: Bound,
    pub(crate) order: Bound,
    pub(crate) step: Bound,
    pub(crate) launch: Launch,
    /// The particles as they were last read.
    pub(crate) mirror: RefCell<Option<Vec<Particle>>>,
    precision: PhantomData<P>,
}

impl<P: Precision> Loaded<P> {
    pub(super) fn new(
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
        let positions = gpu.storage("the particles' positions", pairs)?;
        let velocities = gpu.storage("the particles' velocities", pairs)?;
        let sorted_tags = gpu.storage("the particles' tags", 2 * words)?;
        let sorted_positions = gpu.storage("the particles' positions", pairs)?;
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
        gpu.upload(
            &positions,
            &written.iter().map(|((_, position), _)| *position).collect::<Vec<_>>(),
        );
        let velocity = |p: &Particle| [P::Real::of(p.vx), P::Real::of(p.vy)];
        gpu.upload(&velocities, &scene.particles().iter().map(velocity).collect::<Vec<_>>());

        let count = [(0, &area), (1, &starts), (2, &tags), (8, &arrivals)];
        let scatter = [(0, &area), (1, &starts), (2, &tags), (8, &arrivals), (9, &slots)];
        let before = [(2, &tags), (3, &positions), (4, &velocities)];
        let after = [(5, &sorted_tags), (6, &sorted_positions), (7, &sorted_velocities)];
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
            positions,
            velocities,
            sorted_tags,
            tallies,
            mirror: RefCell::default(),
            precision: PhantomData,
        })
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
            let (vx, vy) = (velocity[0].into(), velocity[1].into());
            particles[id as usize] = Particle { x, y, vx, vy, id };
        }
        particles
    }
}
