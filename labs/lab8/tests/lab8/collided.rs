//! Questions about the messages to workers after a step, and about the workers' updates.

use std::collections::BTreeSet;
use std::ops::Range;

use common::hard::Disc;
use hard_disc_ranks::DiscWire;
use lab8::{collided, update};
use oracle::{Ask, Random};
use solution5::Cut;
use solution7::{Candidate, Hit};

use super::candidates::discs_of;
use super::wires::{DISC, disc, same_discs, wires};

/// Asks for the messages about discs of held blocks that have collided: few and many, with walls
/// and with discs of any block.
pub(crate) fn collided_discs(random: &mut Random, ask: &mut impl Ask) {
    for n in random.sizes(4097).into_iter().chain([70_000]).filter(|&n| n > 0) {
        let discs: Vec<Disc> = (0..n).map(|_| disc(random)).collect();
        let ranks = 1 + random.below(9);
        let blocks = Cut { rows: n, ranks };
        let taken = happened(random, n);
        let held: Vec<usize> = (0..ranks).filter(|_| random.below(2) == 0).collect();
        let question = format!(
            "{n} discs in {ranks} blocks, {} collisions: {DISC} of each disc that has collided and is in one of the \
             blocks {held:?}",
            taken.len()
        );
        let found = || {
            let mut found = collided(&discs, &blocks, &held, &taken);
            // The order does not matter.
            found.sort_by_key(|wire| wire.number);
            wires(&found)
        };
        ask.judge(&question, found, |found| {
            let involved: BTreeSet<u32> = taken.iter().flat_map(discs_of).collect();
            let held = held.iter().flat_map(|&block| blocks.block(block));
            let right = held.filter(|&number| involved.contains(&(number as u32)));
            let right: Vec<DiscWire> =
                right.map(|number| DiscWire::new(number, &discs[number])).collect();
            same_discs(found, &right)
        });
    }
}

/// Draws collisions of `n` discs in a step. Each disc is in at most one collision.
fn happened(random: &mut Random, n: usize) -> Vec<Candidate> {
    let mut free: Vec<u32> = (0..n as u32).collect();
    random.shuffle(&mut free);
    free.truncate(random.below(n + 1).max(n / 2));
    let mut taken = Vec::new();
    while let Some(a) = free.pop() {
        let other = if random.below(4) > 0 { free.pop() } else { None };
        let walls = [Hit::WallX(a), Hit::WallY(a), Hit::Corner(a)];
        let hit = match other {
            Some(b) => Hit::Pair(a.min(b), a.max(b)),
            None => walls[random.below(3)],
        };
        taken.push(Candidate { time: random.between(0.0, 1.0), hit });
    }
    taken
}

/// Asks for the held blocks, moving or not, after discs have arrived, including discs of blocks
/// that are not held.
pub(crate) fn updates(random: &mut Random, ask: &mut impl Ask) {
    for n in random.sizes(1025).into_iter().filter(|&n| n > 0).flat_map(|n| [n; 3]) {
        let before: Vec<Disc> = (0..n).map(|_| disc(random)).collect();
        let cut = random.below(n + 1);
        let held =
            [[0..cut, n..n], [cut..cut, cut..n], [0..cut / 2, cut..n]][random.below(3)].clone();
        let moves = random.below(3) > 0;
        let arrived: Vec<usize> = (0..n).filter(|_| random.below(4) == 0).collect();
        let arrived: Vec<DiscWire> =
            arrived.into_iter().map(|number| DiscWire::new(number, &disc(random))).collect();
        let question = format!(
            "a worker that has discs {held:?} of {n} (it moves these discs: {moves}), and {} discs that arrive: \
             {DISC} of all discs",
            arrived.len()
        );
        let found = || {
            let mut discs = before.clone();
            update(&mut discs, &held, moves, &arrived);
            wires(&numbered(&discs))
        };
        ask.judge(&question, found, |found| {
            let right = (0..n).map(|number| match arrived.iter().find(|w| w.index() == number) {
                Some(wire) => *wire,
                None => DiscWire::new(number, &flown(&before, number, &held, moves)),
            });
            same_discs(found, &right.collect::<Vec<_>>())
        });
    }
}

fn numbered(discs: &[Disc]) -> Vec<DiscWire> {
    discs.iter().enumerate().map(|(number, disc)| DiscWire::new(number, disc)).collect()
}

/// Returns a disc at the end of a step in which it has not collided.
fn flown(discs: &[Disc], number: usize, held: &[Range<usize>], moves: bool) -> Disc {
    let disc = discs[number];
    if moves && held.iter().any(|block| block.contains(&number)) {
        Disc { x: disc.x + disc.vx, y: disc.y + disc.vy, ..disc }
    } else {
        disc
    }
}
