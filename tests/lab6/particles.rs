//! Questions about particles: the particles that leave a block, and the particles of a scene that a
//! rank keeps.

use std::cell::Cell;

use common::soft::Particle;
use common_mpi::Wire;
use lab6::{Cuts, Leavers, keep_share, sort_leavers};
use oracle::scenes::on_edges;
use oracle::{Ask, Random, integers, resident};
use solution2::Grid;

use super::blocks::{owner, starts};

/// Particles that left the block of a rank.
struct Left {
    grid: Grid,
    cuts: Cuts,
    rank: usize,
    /// Ranks before and after the rank.
    beside: [Option<usize>; 2],
    wires: Vec<Wire>,
}

impl Left {
    fn drawn(random: &mut Random) -> Self {
        let ranks = 2 + random.size(600);
        let rank = random.below(ranks);
        let mut rows: Vec<usize> =
            (0..ranks).map(|_| [0, 1, 1 + random.below(5)][random.below(3)]).collect();
        let beside = some_rows_beside(random, &mut rows, rank);
        let mut starts = vec![0];
        rows.iter().for_each(|rows| starts.push(starts[starts.len() - 1] + rows));
        let cuts = Cuts { starts };
        let grid = Grid::with_bins_along(random.between(0.1, 9.0), cuts.rows());
        // Sometimes numbers exceed 32 bits.
        let shift = random.below(40);
        let left = |p: &&Particle| !cuts.block(rank).contains(&grid.row(p.y));
        let mut particles = on_edges(random, 60, grid.size(), cuts.rows());
        // The particles come in any order, not in the order of their ids.
        random.shuffle(&mut particles);
        let wires = particles.iter().filter(left);
        let wires = wires.map(|p| Wire { id: u64::from(p.id) << shift, ..Wire::from(p) }).collect();
        Self { grid, cuts, rank, beside, wires }
    }

    /// Returns the destination of each particle.
    fn sorted(&self) -> Leavers {
        let mut sorted = Leavers::default();
        for wire in &self.wires {
            let to = owner(&self.cuts, self.grid.row(wire.y));
            match self.beside.iter().position(|other| *other == Some(to)) {
                Some(side) => sorted.near[side].push(*wire),
                None => sorted.far.push((to, *wire)),
            }
        }
        sorted
    }
}

/// Changes the number of rows of each rank so that the neighbours of `rank` are obvious. They are
/// the ranks with adjacent numbers, or there are none. (Finding the neighbours in other cases is
/// task 6.2.)
fn some_rows_beside(random: &mut Random, rows: &mut [usize], rank: usize) -> [Option<usize>; 2] {
    let case = random.below(5);
    let mut some = |at: Option<usize>| {
        let at = at.filter(|at| *at < rows.len())?;
        rows[at] = rows[at].max(1);
        Some(at)
    };
    let beside = [some(rank.checked_sub(1)), some(Some(rank + 1))];
    some(Some(rank));
    match case {
        // A rank without rows.
        0 => {
            rows[rank] = 0;
            [None, None]
        }
        // All lower ranks have no rows.
        1 => {
            rows[..rank].fill(0);
            [None, beside[1]]
        }
        _ => beside,
    }
}

/// Asks about particles that move to the neighbours and beyond.
pub(crate) fn leavers(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..150 {
        let left = Left::drawn(random);
        let Left { grid, cuts, rank, beside, wires } = &left;
        let sorted = sort_leavers(grid, cuts, *beside, wires);
        let name = format!(
            "case {case}, {} particles that left the block {:?} of rank {rank}",
            wires.len(),
            cuts.block(*rank)
        );
        for side in [0, 1] {
            let question = format!(
                "{name}: id, x, y, vx, vy of each particle for the neighbour with the {} number, in the order in which \
                 the particles came",
                ["lower", "higher"][side]
            );
            let found = || numbers(&sorted.near[side]);
            ask.exact(&question, found, || numbers(&left.sorted().near[side]));
        }
        let question =
            format!("{name}: rank, id, x, y, vx, vy of each particle for a rank farther away");
        ask.exact(&question, || with_ranks(&sorted.far), || with_ranks(&left.sorted().far));
    }
}

fn numbers(wires: &[Wire]) -> Vec<f64> {
    wires.iter().flat_map(|w| [w.id as f64, w.x, w.y, w.vx, w.vy]).collect()
}

fn with_ranks(far: &[(usize, Wire)]) -> Vec<f64> {
    far.iter().flat_map(|(rank, wire)| [vec![*rank as f64], numbers(&[*wire])].concat()).collect()
}

/// Asks for the part of a replayed scene that a rank keeps, and for the number of replays. The
/// scene has many particles in few rows, or few particles in many rows.
pub(crate) fn shares(random: &mut Random, ask: &mut impl Ask) {
    for n in [random.sizes(1025), vec![70_000, 1]].concat() {
        let most = [5, 300][random.below(2)];
        let rows = 1 + random.size(most);
        let ranks = 1 + random.size(9);
        let grid = Grid::with_bins_along(random.magnitude(1e-6, 1e6), rows);
        let particles = on_edges(random, n, grid.size(), rows);
        for rank in [0, random.below(ranks), ranks - 1] {
            share(&grid, &particles, ranks, rank, ask);
        }
    }
}

/// Asks for the memory of a rank that keeps few of four million particles.
pub(crate) fn large_scene(_: &mut Random, ask: &mut impl Ask) {
    const ROWS: usize = 256;
    const ALL: usize = 1 << 22;
    let question = "4,194,304 particles in 256 rows on 256 ranks, rank 5: (1) the number of particles that this rank \
                    keeps, (2) the bytes of memory that it needs during the replays, or that it reserves for its \
                    share (the greater of the two numbers; 0 if it is below one byte for each particle of the scene)";
    ask.apart(|ask| ask.exact(question, || kept_of(ALL, ROWS), || integers([ALL / ROWS, 0])));
}

/// Returns the number of particles that the sixth rank keeps, and the memory that it needs. The
/// scene has `all` particles in as many rows as ranks. The memory is in bytes, 0 for little memory.
fn kept_of(all: usize, rows: usize) -> Vec<f64> {
    let before = resident();
    let most = Cell::new(before);
    let replay = |visit: &mut dyn FnMut(Particle)| {
        for id in 0..all {
            visit(Particle { id: id as u32, y: (id % rows) as f64 + 0.5, ..Particle::default() });
        }
        most.set(most.get().max(resident()));
    };
    let (_, share) = keep_share(&Grid::with_bins_along(rows as f64, rows), rows, 5, &replay);
    let held = most.get() - before;
    let reserved = (share.capacity() * size_of::<Particle>()) as u64;
    let bytes = held.max(reserved);
    vec![share.len() as f64, if bytes < all as u64 { 0.0 } else { bytes as f64 }]
}

/// Asks for the particles that one rank keeps.
fn share(grid: &Grid, particles: &[Particle], ranks: usize, rank: usize, ask: &mut impl Ask) {
    let replays = Cell::new(0);
    let replay = |visit: &mut dyn FnMut(Particle)| {
        replays.set(replays.get() + 1);
        particles.iter().for_each(|p| visit(*p));
    };
    let (cuts, share) = keep_share(grid, ranks, rank, &replay);
    let count = particles.len();
    let name = format!("rank {rank} of {ranks}, {count} particles in {} rows", grid.rows());
    let question = format!("{name}: row at which each block starts, then the number of rows");
    ask.exact(&question, || integers(cuts.starts), || integers(starts_of(grid, particles, ranks)));
    ask.exact(
        &format!("{name}: ids of the particles that this rank keeps, in ascending order"),
        || ids(&share),
        || {
            let starts = starts_of(grid, particles, ranks);
            let own = starts[rank]..starts[rank + 1];
            ids(particles.iter().filter(|p| own.contains(&grid.row(p.y))))
        },
    );
    // A rank that replays the scene once has stored all particles until it knew its own.
    let question = format!("{name}: number of times that this rank replays the scene");
    ask.exact(&question, || integers([replays.get()]), || vec![2.0]);
}

/// Returns the starts of the blocks of these particles.
fn starts_of(grid: &Grid, particles: &[Particle], ranks: usize) -> Vec<usize> {
    let mut counts = vec![0; grid.rows()];
    particles.iter().for_each(|p| counts[grid.row(p.y)] += 1);
    starts(&counts, ranks)
}

fn ids<'a>(particles: impl IntoIterator<Item = &'a Particle>) -> Vec<f64> {
    let mut ids: Vec<u32> = particles.into_iter().map(|p| p.id).collect();
    ids.sort_unstable();
    ids.into_iter().map(f64::from).collect()
}
