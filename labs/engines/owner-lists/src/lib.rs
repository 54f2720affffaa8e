//! Linked lists with owners: the CSC367 report's program (sections 2.1 and 2.2).
//!
//! Each thread has consecutive rows of bins. It reads all particles and puts the particles of its
//! rows into linked lists, whose nodes are allocated once. It tests every pair of its rows once,
//! and the pairs of its last row with the row above. Then the threads divide the particles by
//! number, and move them.
//!
//! The report does not explain how two threads add to one particle at a border. Here each thread
//! has its own sums.

use std::ops::Range;
use std::sync::Arc;

use common::Vec2;
use common::soft::{Observer, Particle, Scene, Simulation, Statistics, merged};
use rayon::ThreadPool;
use rayon::prelude::*;
use solution1::{advance, pair_acceleration};
use solution2::{BinLists, Grid, forward};
use solution3::{pool, rows_of_each};

/// A thread's rows and lists.
struct Owner {
    rows: Range<usize>,
    /// Lists of the bins in the thread's rows, with a node for each particle of the scene.
    lists: BinLists,
    /// The memory of nodes that are allocated again in each step; a node is a particle and a link.
    #[expect(clippy::vec_box, reason = "memory of its own for each node is what this measures")]
    fresh: Vec<Box<[usize; 2]>>,
}

/// The results of a thread in this step.
struct Sums<O> {
    /// Acceleration of each particle, at its number; valid in the thread's rows and in the row
    /// above.
    accelerations: Vec<Vec2>,
    observer: O,
}

/// The engine.
pub struct OwnerLists<O> {
    pool: Arc<ThreadPool>,
    bin_size: f64,
    fresh: bool,
    grid: Grid,
    /// The particles, in the order of their numbers.
    particles: Vec<Particle>,
    owners: Vec<Owner>,
    sums: Vec<Sums<O>>,
    /// The thread that owns each row.
    owner_of: Vec<usize>,
}

impl<O: Observer> OwnerLists<O> {
    /// Makes an engine for `threads` threads and bins of `bin_size` cutoffs or more.
    ///
    /// With `fresh`, each step allocates a node for each particle, and frees the node again.
    pub fn new(threads: usize, bin_size: f64, fresh: bool) -> Self {
        Self {
            pool: Arc::new(pool(threads)),
            bin_size,
            fresh,
            grid: Grid::default(),
            particles: Vec::new(),
            owners: Vec::new(),
            sums: Vec::new(),
            owner_of: Vec::new(),
        }
    }

    /// Fills the lists and clears the sums of all threads. Each thread reads all particles.
    fn fill_lists(&mut self) {
        let Self { grid, particles, fresh, .. } = self;
        self.owners.par_iter_mut().zip(&mut self.sums).for_each(|(owner, sums)| {
            owner.lists.clear();
            owner.fresh.clear();
            for (i, particle) in particles.iter().enumerate() {
                let row = grid.row(particle.y);
                if owner.rows.contains(&row) {
                    let bin = (row - owner.rows.start) * grid.columns() + grid.column(particle.x);
                    owner.lists.insert(bin, i);
                    if *fresh {
                        owner.fresh.push(Box::new([i, bin]));
                    }
                    sums.accelerations[i] = Vec2::ZERO;
                } else if row == owner.rows.end {
                    sums.accelerations[i] = Vec2::ZERO;
                }
            }
        });
    }

    fn sum_forces(&mut self) {
        let Self { grid, particles, owners, owner_of, .. } = self;
        self.sums.par_iter_mut().zip(&*owners).for_each(|(sums, owner)| {
            sums.observer = O::default();
            let above = owner_of.get(owner.rows.end).map_or(owner, |above| &owners[*above]);
            for row in owner.rows.clone() {
                for column in 0..grid.columns() {
                    sum_bin(sums, grid, particles, [owner, above], (row, column));
                }
            }
        });
    }

    /// Moves the particles. The owner of the row below may have added to a particle's acceleration
    /// across the border.
    fn move_particles(&mut self) {
        let Self { grid, sums, owner_of, .. } = self;
        let share = self.particles.len().div_ceil(sums.len()).max(1);
        self.particles.par_chunks_mut(share).for_each(|own| {
            for particle in own {
                let row = grid.row(particle.y);
                let i = particle.id as usize;
                let owner = owner_of[row];
                let mut a = sums[owner].accelerations[i];
                if row > 0 && owner_of[row - 1] != owner {
                    a += sums[owner_of[row - 1]].accelerations[i];
                }
                advance(particle, a, grid.size());
            }
        });
    }
}

/// Adds the forces of all pairs of a bin, and of its pairs with the bins after it, to both
/// particles.
///
/// The bin belongs to the first of the two owners. The second owner has the row above the first
/// owner's rows.
fn sum_bin<O: Observer>(
    sums: &mut Sums<O>,
    grid: &Grid,
    particles: &[Particle],
    [owner, above]: [&Owner; 2],
    (row, column): (usize, usize),
) {
    let columns = grid.columns();
    let [first, end] = [owner.rows.start, owner.rows.end].map(|row| row * columns);
    let bin = row * columns + column - first;
    // If bins are one cutoff wide, four out of five are empty.
    if owner.lists.is_empty(bin) {
        return;
    }
    let mut add_to_both = |i: usize, j: usize| {
        let d = particles[i].to(&particles[j]);
        sums.observer.tested(1);
        if let Some(a) = pair_acceleration(d) {
            sums.accelerations[i] += a;
            sums.accelerations[j] -= a;
            sums.observer.seen(d.norm_squared());
            sums.observer.seen(d.norm_squared());
        }
    };
    let mut ahead = [0; 4];
    let count = forward(grid, row, column, &mut ahead);
    for i in owner.lists.bin(bin) {
        for j in owner.lists.after(i) {
            add_to_both(i, j);
        }
        for bin in &ahead[..count] {
            let (lists, start) =
                if *bin < end { (&owner.lists, first) } else { (&above.lists, end) };
            for j in lists.bin(bin - start) {
                add_to_both(i, j);
            }
        }
    }
}

impl<O: Observer> Simulation for OwnerLists<O> {
    fn load(&mut self, scene: &Scene) {
        self.grid = Grid::of_scene(scene, self.bin_size);
        self.particles = scene.particles().to_vec();
        let rows_of_each = rows_of_each(self.pool.current_num_threads(), self.grid.rows());
        self.owner_of.clear();
        self.owners.clear();
        for (owner, rows) in rows_of_each.enumerate() {
            self.owner_of.resize(rows.end, owner);
            let lists = BinLists::new(rows.len() * self.grid.columns(), scene.len());
            self.owners.push(Owner { rows, lists, fresh: Vec::new() });
        }
        self.sums.clear();
        for _ in &self.owners {
            let accelerations = vec![Vec2::ZERO; scene.len()];
            self.sums.push(Sums { accelerations, observer: O::default() });
        }
    }

    fn step(&mut self) {
        let pool = Arc::clone(&self.pool);
        pool.install(|| {
            self.fill_lists();
            self.sum_forces();
            self.move_particles();
        });
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        out.copy_from_slice(&self.particles[first..first + out.len()]);
    }

    fn statistics(&self) -> Option<Statistics> {
        merged(self.sums.iter().map(|sums| &sums.observer))
    }
}
