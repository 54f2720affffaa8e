//! The entry: an engine with bins and the official step, to begin with.

use common::Vec2;
use common::soft::{NoStatistics, Particle, Scene, Simulation, read_by_id};
use solution1::{add_pair, advance};
use solution2::Grid;

/// Marks the end of the list of a bin.
const NONE: u32 = u32::MAX;

/// A correct and slow engine: every particle looks at all particles of nine bins.
pub struct Entry {
    grid: Grid,
    /// Particles in the order of their ids.
    particles: Vec<Particle>,
    accelerations: Vec<Vec2>,
    /// First particle of each bin.
    heads: Vec<u32>,
    /// For each particle, the next particle in the same bin.
    next: Vec<u32>,
}

impl Entry {
    /// Makes an engine without a scene. It may use `_threads` threads.
    pub fn new(_threads: usize) -> Self {
        Self {
            grid: Grid::default(),
            particles: Vec::new(),
            accelerations: Vec::new(),
            heads: Vec::new(),
            next: Vec::new(),
        }
    }

    /// Puts each particle at the head of the list of its bin.
    fn fill_bins(&mut self) {
        self.heads.fill(NONE);
        for (number, particle) in self.particles.iter().enumerate() {
            let head = &mut self.heads[self.grid.bin(particle)];
            self.next[number] = std::mem::replace(head, number as u32);
        }
    }

    /// Adds up the accelerations that all particles in the nine bins around `particle` cause.
    fn acceleration(&self, particle: &Particle) -> Vec2 {
        let mut a = Vec2::ZERO;
        for row in self.grid.near(self.grid.row(particle.y)) {
            for column in self.grid.near(self.grid.column(particle.x)) {
                let mut other = self.heads[row * self.grid.columns() + column];
                while let Some(neighbour) = self.particles.get(other as usize) {
                    add_pair(&mut a, particle.to(neighbour), &mut NoStatistics);
                    other = self.next[other as usize];
                }
            }
        }
        a
    }
}

impl Simulation for Entry {
    fn load(&mut self, scene: &Scene) {
        self.grid = Grid::of_scene(scene, 1.0);
        self.particles = scene.particles().to_vec();
        self.accelerations = vec![Vec2::ZERO; scene.len()];
        self.heads = vec![NONE; self.grid.bins()];
        self.next = vec![NONE; scene.len()];
    }

    fn step(&mut self) {
        self.fill_bins();
        for number in 0..self.particles.len() {
            self.accelerations[number] = self.acceleration(&self.particles[number]);
        }
        for (particle, a) in self.particles.iter_mut().zip(&self.accelerations) {
            advance(particle, *a, self.grid.size());
        }
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        read_by_id(&self.particles, first, out);
    }
}
