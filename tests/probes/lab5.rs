//! What is asked about lab 5.
//!
//! Ranks get blocks of as many rows as each other, except where the cut itself is asked about.

use std::ops::Range;

use common::soft::{CUTOFF, Particle, Statistics};
use common_mpi::Wire;
use lab5::{
    Cut, Parcel, VARIANTS, border_copies, broadcast, gather_at_root, reduce, replace_ghosts,
    scatter_from_root, sort_by_receiver, take_leavers_of_block,
};
use mpi::traits::*;
use solution2::{BIN_SIZE, Grid, VecBins};

use self::ranks::tell_all;
use self::soft::Engine;
use crate::{Answers, Random, weighed};

#[path = "ranks.rs"]
mod ranks;
#[path = "soft.rs"]
mod soft;

/// Asks everything about a task.
pub fn ask(task: &str, random: &mut Random, answers: &mut Answers) {
    match task {
        "5.1" => cuts(answers),
        "5.2" => leavers(random, answers),
        "5.3" => copies(random, answers),
        "5.4" => gathers(random, answers),
        "5.5" => parcels(random, answers),
        "5.6" => scatters(random, answers),
        "5.7" => ghosts(random, answers),
        "5.8" => steps(random, answers),
        "5.9" => statistics(random, answers),
        _ => panic!("there is no task {task}"),
    }
}

fn cuts(answers: &mut Answers) {
    for rows in [1, 2, 3, 7, 10, 12, 39, 100] {
        for ranks in 1..=16 {
            let cut = Cut { rows, ranks };
            let blocks = (0..ranks).map(|rank| cut.block(rank));
            let ends: Vec<f64> = blocks.flat_map(|b| [b.start as f64, b.end as f64]).collect();
            answers.exact(&format!("the blocks of {rows} rows on {ranks} ranks"), &ends);
            let owners: Vec<f64> = (0..rows).map(|row| cut.owner(row) as f64).collect();
            answers.exact(&format!("owner of each of {rows} rows, on {ranks} ranks"), &owners);
        }
    }
}

/// Particles in a box of side 1 with so many rows of bins, well inside them.
fn particles(random: &mut Random, rows: usize, n: usize) -> Vec<Particle> {
    let particle = |id| {
        let mut at = || (random.below(rows) as f64 + random.between(0.05, 0.95)) / rows as f64;
        let (x, y) = (at(), at());
        Particle { x, y, vx: random.between(-1.0, 1.0), vy: random.between(-1.0, 1.0), id }
    };
    (0..n as u32).map(particle).collect()
}

/// id x y vx vy, in the order of ids.
fn states(wires: &[Wire]) -> Vec<f64> {
    let mut wires = wires.to_vec();
    wires.sort_by_key(|wire| wire.id);
    wires.iter().flat_map(|w| [w.id as f64, w.x, w.y, w.vx, w.vy]).collect()
}

fn leavers(random: &mut Random, answers: &mut Answers) {
    let grid = Grid::with_bins_along(1.0, 10);
    for round in 0..30 {
        for block in [0..4, 4..7, 7..10, 3..4, 5..5, 0..10] {
            let (mut changed, mut remote) = (particles(random, 10, 60), Vec::new());
            take_leavers_of_block(&grid, &block, &mut changed, &mut remote);
            let name = format!("round {round}, rows {block:?}");
            answers.exact(
                &format!("{name}: particles that have only changed the bin"),
                &soft::ids(&changed),
            );
            answers.exact(&format!("{name}: particles that have left"), &soft::ids(&remote));
        }
    }
}

/// Rows that a rank sees: its block and a row on either side.
fn visible(block: &Range<usize>, rows: usize) -> Range<usize> {
    block.start.saturating_sub(1)..(block.end + 1).min(rows)
}

fn copies(random: &mut Random, answers: &mut Answers) {
    const ROWS: usize = 12;
    let grid = Grid::with_bins_along(1.0, ROWS);
    for round in 0..10 {
        for ranks in [1, 2, 3, 4, 6, 12] {
            let cut = Cut { rows: ROWS, ranks };
            for rank in 0..ranks {
                let block = rank * ROWS / ranks..(rank + 1) * ROWS / ranks;
                let mut bins = VecBins::new(grid);
                for p in particles(random, ROWS, 120) {
                    // Ghosts of the step before are there as well.
                    if visible(&block, ROWS).contains(&grid.row(p.y)) {
                        bins.put(p);
                    }
                }
                let copies = border_copies(&bins, &cut, &block);
                let question = format!(
                    "round {round}: id x y vx vy of the copies that rank {rank} of {ranks} makes"
                );
                answers.exact(&question, &states(&copies));
            }
        }
    }
}

/// What a rank has in the rounds of a job: nothing, a little, more than a packet.
fn list(random: &mut Random, most: usize) -> Vec<Wire> {
    let n = random.below(most + 1);
    particles(random, 10, n).iter().map(Wire::from).collect()
}

/// So many items at most, round by round.
const MOST: [usize; 4] = [0, 5, 40, 5000];

/// A list as its length and a few numbers that depend on its order.
fn digest(list: &[Wire]) -> [f64; 3] {
    [
        list.len() as f64,
        weighed(list.iter().map(|w| w.x + w.vy)),
        list.iter().map(|w| w.id as f64).sum(),
    ]
}

fn gathers(random: &mut Random, answers: &mut Answers) {
    ranks::each(&[1, 2, 3, 5], |world| {
        let (rank, ranks) = (world.rank() as usize, world.size() as usize);
        for (round, most) in MOST.into_iter().enumerate() {
            let lists: Vec<_> = (0..ranks).map(|_| list(random, most)).collect();
            let found = gather_at_root(world, &lists[rank]);
            if rank == 0 {
                let digests: Vec<f64> = found.iter().flat_map(|list| digest(list)).collect();
                let question = format!(
                    "{ranks} ranks, round {round}: number, sum and ids of the items of each rank"
                );
                answers.exact(&question, &digests);
            } else {
                assert!(found.is_empty(), "rank {rank} is not the root and got something");
            }
        }
    });
}

fn scatters(random: &mut Random, answers: &mut Answers) {
    ranks::each(&[1, 2, 3, 5], |world| {
        let (rank, ranks) = (world.rank() as usize, world.size() as usize);
        for (round, most) in MOST.into_iter().enumerate() {
            let lists: Vec<_> = (0..ranks).map(|_| list(random, most)).collect();
            let found = scatter_from_root(world, if rank == 0 { &lists } else { &[] });
            let question =
                format!("{ranks} ranks, round {round}: number, sum and ids of what each rank got");
            tell_all(world, answers, &question, &digest(&found));
        }
    });
}

fn parcels(random: &mut Random, answers: &mut Answers) {
    const ROWS: usize = 12;
    let grid = Grid::with_bins_along(1.0, ROWS);
    for round in 0..10 {
        for ranks in [1, 2, 3, 4, 6, 12] {
            let cut = Cut { rows: ROWS, ranks };
            let all = particles(random, ROWS, 200);
            let mut parcels = vec![Parcel::default(); ranks];
            for p in &all {
                let row = grid.row(p.y);
                let owner = row * ranks / ROWS;
                let is_border = row * ranks % ROWS == 0 || (row + 1) * ranks % ROWS == 0;
                match random.below(3) {
                    // A particle that came from any other rank.
                    0 if ranks > 1 => {
                        let from = (owner + 1 + random.below(ranks - 1)) % ranks;
                        parcels[from].leavers.push(p.into());
                    }
                    1 if is_border => parcels[owner].copies.push(p.into()),
                    _ => {}
                }
            }
            let lists = sort_by_receiver(&grid, &cut, &parcels);
            for (rank, list) in lists.iter().enumerate() {
                let question = format!(
                    "round {round}: id x y vx vy of what the root has for rank {rank} of {ranks}"
                );
                answers.exact(&question, &states(list));
            }
        }
    }
}

fn ghosts(random: &mut Random, answers: &mut Answers) {
    const ROWS: usize = 10;
    let grid = Grid::with_bins_along(1.0, ROWS);
    for round in 0..20 {
        for block in [0..4, 4..7, 7..10, 3..4, 0..10] {
            let seen = visible(&block, ROWS);
            let mut bins = VecBins::new(grid);
            let near = |p: &Particle| seen.contains(&grid.row(p.y));
            for p in particles(random, ROWS, 80).into_iter().filter(near) {
                bins.put(p);
            }
            let arrived = particles(random, ROWS, 80).into_iter().filter(near);
            let arrived: Vec<Wire> =
                arrived.map(|p| Wire { id: u64::from(p.id) + 1000, ..Wire::from(&p) }).collect();
            replace_ghosts(&mut bins, &block, &arrived);
            for row in 0..ROWS {
                let inside = bins.bins()[row * ROWS..(row + 1) * ROWS].iter().flatten();
                let question = format!(
                    "round {round}, rows {block:?}: particles in row {row}, new ones from 1000 on"
                );
                answers.exact(&question, &soft::ids(inside));
            }
        }
    }
}

/// A box of 12 rows of bins of one cutoff, so that blocks are even.
const SIDE: f64 = 12.5 * CUTOFF;

/// All ranks get the scene, and run it: that takes all tasks before this one.
fn steps(random: &mut Random, answers: &mut Answers) {
    ranks::each(&[1, 2, 3, 4], |world| {
        let (rank, ranks) = (world.rank() as usize, world.size() as usize);
        let scene = soft::spread(random, 200, SIDE, 1.0);
        let (size, found) = broadcast(world, (rank == 0).then_some(&scene));
        let wires: Vec<Wire> = found.iter().map(Wire::from).collect();
        let [n, sum, ids] = digest(&wires);
        let question = format!("{ranks} ranks: side, number, sum and ids of the scene on each");
        tell_all(world, answers, &question, &[size, n, sum, ids]);
        for (name, scene, steps) in [
            ("200 in 12.5 cutoffs", scene, 8),
            ("fast ones", soft::spread(random, 150, SIDE, 60.0), 3),
            ("a crowd", soft::crowd(random, 250, SIDE, 1.0), 2),
        ] {
            let mut engine = Engine::new(VARIANTS, "through-root", 1, &[(BIN_SIZE, 1.0)]);
            let run = engine.run(&scene, steps);
            if rank == 0 {
                answers.bits(&format!("through-root on {ranks} ranks, {name}"), &run);
            }
        }
    });
}

fn statistics(random: &mut Random, answers: &mut Answers) {
    ranks::each(&[1, 2, 3, 5], |world| {
        let (rank, ranks) = (world.rank() as usize, world.size() as usize);
        for round in 0..5 {
            let mut own = || Statistics {
                dmin: random.between(0.2, 1.0),
                davg: random.between(0.0, 100.0),
                navg: random.below(1000) as u64,
                pair_tests: random.below(100_000) as u64,
            };
            let all: Vec<_> = (0..ranks).map(|_| own()).collect();
            let found = reduce(world, &all[rank]);
            assert_eq!(found.is_some(), rank == 0, "the root alone has the statistics");
            if let Some(found) = found {
                let question =
                    format!("{ranks} ranks, round {round}: dmin, davg, navg, pair tests");
                answers.close(&question, &soft::numbers(found));
            }
        }
    });
}
