//! What tests and probe ask alike about lists that travel between ranks.

use common_mpi::{Ghost, calls_made, together};
use lab6::{exchange_all, exchange_beside};
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

use super::ask::{Ask, digest, memory, others_within};
use crate::Random;

/// The items of a list in a long run.
const LONG: usize = 1000;

/// Lists from every rank to every rank, `[from][to]`, some of them empty.
fn letters(random: &mut Random, ranks: usize, most: usize) -> Vec<Vec<Vec<Ghost>>> {
    let mut list = |_| -> Vec<Ghost> {
        let n = random.below(4) * most / 3;
        let mut ghost = |id| Ghost { x: random.between(0.0, 1.0), y: random.between(0.0, 1.0), id };
        (0..n as u64).map(&mut ghost).collect()
    };
    (0..ranks).map(|_| (0..ranks).map(&mut list).collect()).collect()
}

fn told(list: &[Ghost]) -> Vec<f64> {
    digest(list.iter().map(|ghost| (ghost.x + 2.0 * ghost.y, ghost.id)))
}

/// Lists to other ranks and from them, in any order, the neighbours or all: nothing, a little, and more than the
/// library keeps aside for a rank that sends before it receives. A watch hears which calls come before the work.
pub(super) fn beside(world: &SimpleCommunicator, random: &mut Random, ask: Ask<'_>) {
    let (rank, ranks) = (world.rank() as usize, world.size() as usize);
    for (most, furthest) in [(0, 1), (5, ranks), (1000, 1), (200_000, ranks)] {
        let others = others_within(furthest, rank, ranks);
        let letters = letters(random, ranks, most);
        let outgoing: Vec<_> =
            others.iter().map(|&to| (to as i32, letters[rank][to].clone())).collect();
        let mut calls = Vec::new();
        let (incoming, result) = together("exchange_beside", || {
            exchange_beside(world, &outgoing, || {
                calls.push(calls_made());
                6 * 7
            })
        });
        let name = format!("exchange_beside on rank {rank} of {ranks}, lists of up to {most}");
        ask(
            &format!("{name}: how often it works, and what the work returns"),
            vec![calls.len() as f64, f64::from(result)],
            vec![1.0, 42.0],
        );
        let before = calls.first().map_or(&[][..], |calls| calls);
        let begun = |call: &&&str| ["MPI_Isend", "MPI_Irecv"].contains(*call);
        let last = before.iter().rev().take_while(begun).count();
        let blocking = |call: &&&str| ["MPI_Send", "MPI_Ssend", "MPI_Recv"].contains(*call);
        let blocking = before.iter().filter(blocking).count();
        let question = format!(
            "{name}: sends and receives begun after the last wait, just before the work; and calls that block"
        );
        ask(&question, vec![last as f64, blocking as f64], vec![2.0 * others.len() as f64, 0.0]);
        let all = |lists: &[Vec<Ghost>]| {
            let mut all = vec![lists.len() as f64];
            all.extend(lists.iter().flat_map(|list| told(list)));
            all.resize(1 + 3 * ranks, 0.0);
            all
        };
        let right: Vec<_> = others.iter().map(|&from| letters[from][rank].clone()).collect();
        let question =
            format!("{name}: how many lists arrive, and how many items and sums of each");
        ask(&question, all(&incoming), all(&right));
    }
    let ghosts = vec![Ghost { x: 0.5, y: 0.5, id: 7 }; LONG];
    let others = others_within(1, rank, ranks);
    let outgoing: Vec<_> = others.iter().map(|&to| (to as i32, ghosts.clone())).collect();
    let turn = |_| {
        together("exchange_beside", || drop(exchange_beside(world, &outgoing, || ())));
        world.barrier();
    };
    let name = format!("exchange_beside on rank {rank} of {ranks}");
    memory(&name, (50, size_of_val(&ghosts[..])), |turns| (0..turns).for_each(turn), ask);
}

/// Lists from all ranks to all: nothing, a few items, more than 16 bits count, and then less.
pub(super) fn all(world: &SimpleCommunicator, random: &mut Random, ask: Ask<'_>) {
    let (rank, ranks) = (world.rank() as usize, world.size() as usize);
    for most in [0, 5, 70_000, 5] {
        let letters = letters(random, ranks, most);
        let found = together("exchange_all", || exchange_all(world, &letters[rank]));
        let right: Vec<Ghost> = letters.iter().flat_map(|from| from[rank].clone()).collect();
        let question = format!(
            "exchange_all on rank {rank} of {ranks}, lists of up to {most}: how many items arrive, and sums of them"
        );
        ask(&question, told(&found), told(&right));
    }
    let lists = vec![vec![Ghost { x: 0.5, y: 0.5, id: 7 }; LONG]; ranks];
    let turn = |_| {
        together("exchange_all", || drop(exchange_all(world, &lists)));
        world.barrier();
    };
    let name = format!("exchange_all on rank {rank} of {ranks}");
    memory(&name, (50, LONG * size_of::<Ghost>()), |turns| (0..turns).for_each(turn), ask);
}
