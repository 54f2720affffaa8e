//! Tasks 2.6 and 2.7: linked lists, and every pair once.

use std::iter;

use common::Vec2;
use common::soft::{Observer, Particle, Scene, Simulation, Statistics};
use solution1::{advance, pair_acceleration};

use crate::Grid;

/// The number that marks the end of a list.
const NONE: u32 = u32::MAX;

/// A linked list of particles for each bin. The nodes are made once and used again.
///
/// Particle i has node i, and a node is in one list at a time. So two arrays are enough:
///
/// - `heads[b]` is the first particle of bin b.
/// - `next[i]` is the particle after i in its list.
/// - `NONE` marks the end of a list.
#[derive(Debug, Default)]
pub struct BinLists {
    heads: Vec<u32>,
    next: Vec<u32>,
}

impl BinLists {
    /// Makes empty lists for `bins` bins, with nodes for `particles` particles.
    pub fn new(bins: usize, particles: usize) -> Self {
        Self { heads: vec![NONE; bins], next: vec![NONE; particles] }
    }

    /// Empties all lists.
    pub fn clear(&mut self) {
        self.heads.fill(NONE);
    }

    /// The particles in `bin`.
    #[inline]
    pub fn bin(&self, bin: usize) -> impl Iterator<Item = usize> {
        self.chain(self.heads[bin])
    }

    /// The particles that come after `particle` in its list.
    #[inline]
    pub fn after(&self, particle: usize) -> impl Iterator<Item = usize> {
        self.chain(self.next[particle])
    }

    #[inline]
    fn chain(&self, first: u32) -> impl Iterator<Item = usize> {
        iter::successors((first != NONE).then_some(first as usize), |at| {
            let next = self.next[*at];
            (next != NONE).then_some(next as usize)
        })
    }

    /// Whether no particle is in `bin`.
    #[inline]
    pub fn is_empty(&self, bin: usize) -> bool {
        self.heads[bin] == NONE
    }

    /// Puts `particle`, which is not in a list yet, at the head of the list of `bin`.
    ///
    /// Book: chapter 2, *Linked lists*.
    #[inline]
    pub fn insert(&mut self, bin: usize, particle: usize) {
        todo!("task 2.6: a particle becomes the head of its list")
    }
}

/// Writes the forward bins of bin (`row`, `column`) into `bins`, and returns their number.
///
/// The forward bins are the neighbouring bins that come after the bin: the bin to its right and the
/// three bins in the next row, where they exist. If every bin handles the pairs inside it and the
/// pairs with its forward bins, every pair of neighbouring bins is handled once.
///
/// Compare rows and columns instead of bin numbers. For a bin in the last column, bin + 1 is at the
/// other end of the next row.
///
/// Book: chapter 2, *Every pair once*.
#[inline]
pub fn forward(grid: &Grid, row: usize, column: usize, bins: &mut [usize; 4]) -> usize {
    todo!("task 2.7: the four bins that come after")
}

/// The engine with linked lists and two-way forces (CSC367 report, section 2.1).
///
/// The engine tests each pair once, and applies the force to both particles, with opposite signs.
/// So it tests half as many pairs as the other engines. But several pairs write to the acceleration
/// of one particle. This is harmless on one thread, but in lab 4 it becomes the problem.
///
/// Results are repeatable, because the program finds the pairs in the same order in every run.
#[derive(Default)]
pub struct LinkedList<O> {
    bin_size: f64,
    grid: Grid,
    particles: Vec<Particle>,
    accelerations: Vec<Vec2>,
    lists: BinLists,
    observer: O,
}

impl<O: Observer> LinkedList<O> {
    /// Makes an engine with bins at least `bin_size` cutoffs wide.
    pub fn new(bin_size: f64) -> Self {
        Self { bin_size, ..Self::default() }
    }

    fn fill_lists(&mut self) {
        self.lists.clear();
        for (i, particle) in self.particles.iter().enumerate() {
            self.lists.insert(self.grid.bin(particle), i);
        }
    }

    fn sum_forces(&mut self) {
        self.accelerations.fill(Vec2::ZERO);
        let mut ahead = [0; 4];
        for row in 0..self.grid.rows() {
            for column in 0..self.grid.columns() {
                let bin = row * self.grid.columns() + column;
                // If a bin's side is one cutoff, four out of five bins are empty.
                if self.lists.is_empty(bin) {
                    continue;
                }
                let count = forward(&self.grid, row, column, &mut ahead);
                self.sum_bin(bin, &ahead[..count]);
            }
        }
    }

    /// Adds the force of every pair of a bin to both particles.
    ///
    /// One particle of a pair is in `bin`. The other particle comes after it in the list of `bin`, or is
    /// in one of the bins `ahead`.
    ///
    /// Report each pair to `self.observer` once as tested (`tested`). If the pair is within the cutoff,
    /// also report its squared distance twice (`seen`), because it counts as two ordered pairs.
    ///
    /// Book: chapter 2, *Every pair once*.
    #[inline]
    fn sum_bin(&mut self, bin: usize, ahead: &[usize]) {
        todo!("task 2.7b: the pairs of a bin, each once, both ways")
    }
}

impl<O: Observer> Simulation for LinkedList<O> {
    fn load(&mut self, scene: &Scene) {
        self.grid = Grid::of_scene(scene, self.bin_size);
        self.particles = scene.particles().to_vec();
        self.accelerations = vec![Vec2::ZERO; scene.len()];
        self.lists = BinLists::new(self.grid.bins(), scene.len());
        self.observer = O::default();
    }

    fn step(&mut self) {
        self.observer = O::default();
        self.fill_lists();
        self.sum_forces();
        for (particle, a) in self.particles.iter_mut().zip(&self.accelerations) {
            advance(particle, *a, self.grid.size());
        }
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        out.copy_from_slice(&self.particles[first..first + out.len()]);
    }

    fn statistics(&self) -> Option<Statistics> {
        self.observer.statistics()
    }
}
