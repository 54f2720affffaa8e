//! What tests and probe ask alike about strips, with drawn inputs and what a plain model says.
//!
//! Whole numbers times a power of two make sums without rounding: there "at" is at.

use std::ops::Range;

use common::soft::CUTOFF;
use common_mpi::{calls_made, together};
use lab13::{
    ACROSS, GHOST, MOVED, RENEWAL, STEP, WAIT, best_depth, best_steps, choose, confirm, deep_width,
    exchange_positions, ghost_width, load, must_renew, pairs_across, partners, right_steps,
    weigh_rows,
};
use mpi::Rank;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use neighbour_list::LISTED;
use neighbour_list::kernels::Positions;
use strips::{Outlook, Scenery, Strips};

use super::ask::{Ask, beside, digest, flags, memory, no_other_calls, others_within, rounded};
use crate::Random;

/// A power of two, small or large.
fn unit(random: &mut Random) -> f64 {
    random.magnitude(1e-9, 1e9).log2().round().exp2()
}

/// How wide and how deep ghosts must be, for few and many steps, at rest, slow and fast.
pub(super) fn widths(random: &mut Random, ask: Ask<'_>, deep: bool) {
    for steps in random.sizes(70_000).into_iter().filter(|&steps| steps > 0) {
        for fastest in [0.0, random.magnitude(1e-15, 1e9), CUTOFF * random.magnitude(1e-3, 1e3)] {
            let cutoffs = if deep { steps as f64 } else { 1.0 };
            let right = cutoffs * CUTOFF + 2.0 * (steps - 1) as f64 * fastest;
            let width = if deep { deep_width } else { ghost_width };
            let found = rounded(width(fastest, steps as u32), right, right);
            let what = if deep { "deep" } else { "wide" };
            let question = format!(
                "how {what} ghosts are for {steps} steps, the fastest goes {fastest:?} in each"
            );
            ask(&question, vec![found], vec![right]);
        }
    }
}

/// By how much a number of steps costs more than the cheapest of 1 to `most`; 0 if it is none of them.
fn price(found: u32, most: u32, cost: impl Fn(u32) -> f64) -> f64 {
    let least = (1..=most).map(&cost).fold(f64::INFINITY, f64::min);
    if (1..=most).contains(&found) { rounded(cost(found) / least, 1.0, 1.0) } else { 0.0 }
}

/// For how many steps ghosts last: is another number cheaper?
pub(super) fn lasting(random: &mut Random, ask: Ask<'_>) {
    for _ in 0..1000 {
        let scenery = Scenery {
            fastest: CUTOFF * random.magnitude(1e-6, 1e3),
            density: random.magnitude(1e-4, 1e2) / (CUTOFF * CUTOFF),
            height: CUTOFF * random.magnitude(1e-1, 1e6),
            most: 1 + random.size(300) as u32,
        };
        let Scenery { fastest, density, height, most } = scenery;
        let found = best_steps(scenery);
        let cost = |steps: u32| {
            let width = CUTOFF + 2.0 * f64::from(steps - 1) * fastest;
            let pairs = 2.0 * 2.0 / 3.0 * density * width * width * width / height;
            RENEWAL / f64::from(steps) + GHOST * 2.0 * width / height + ACROSS * pairs
        };
        let question =
            format!("{scenery:?}: what its steps cost, by the cheapest; 0 if they may not be");
        ask(&question, vec![price(found, most, cost)], vec![1.0]);
    }
}

/// For how many steps no message is sent: is another number cheaper?
pub(super) fn depths(random: &mut Random, ask: Ask<'_>) {
    for _ in 0..1000 {
        let outlook = Outlook {
            fastest: CUTOFF * random.magnitude(1e-6, 1e3),
            height: CUTOFF * random.magnitude(1e-1, 1e6),
            particles: random.magnitude(1.0, 1e8),
            most: 1 + random.size(300) as u32,
        };
        let Outlook { fastest, height, particles, most } = outlook;
        let found = best_depth(outlook);
        let cost = |steps: u32| {
            let m = f64::from(steps);
            let depth = m * CUTOFF + 2.0 * (m - 1.0) * fastest;
            let particle = STEP + RENEWAL / m;
            particle + 2.0 * depth / height * particle + WAIT / (particles * m)
        };
        let question =
            format!("{outlook:?}: what its steps cost, by the cheapest; 0 if they may not be");
        ask(&question, vec![price(found, most, cost)], vec![1.0]);
    }
}

/// The partners of ranks with high, low and empty strips: of edges exactly as far apart as the width, and a hair
/// more or less.
pub(super) fn neighbours(random: &mut Random, ask: Ask<'_>) {
    for ranks in
        random.sizes(257).into_iter().filter(|&ranks| ranks > 0).flat_map(|ranks| [ranks; 6])
    {
        let unit = unit(random);
        let mut edges: Vec<f64> =
            (1..ranks).map(|_| (1 + random.below(2 * ranks)) as f64 * unit).collect();
        edges.sort_by(f64::total_cmp);
        // Some have no rows below or above.
        let ends = random.below(3).min(ranks - 1);
        let low = vec![f64::NEG_INFINITY; if ends == 1 { 2 } else { 1 }];
        let high = vec![f64::INFINITY; if ends == 2 { 2 } else { 1 }];
        edges.truncate(ranks + 1 - low.len() - high.len());
        let strips = Strips { edges: [low, edges, high].concat() };
        let width = beside(random.below(8) as f64 * unit)[random.below(3)].max(0.0);
        let is_empty = |rank: usize| strips.edges[rank] >= strips.edges[rank + 1];
        for _ in 0..ranks.min(12) {
            let rank = random.below(ranks);
            let near = |&other: &usize| {
                let between = strips.edges[rank.max(other)] - strips.edges[rank.min(other) + 1];
                other != rank && !is_empty(rank) && !is_empty(other) && between <= width
            };
            let right: Vec<f64> = (0..ranks).filter(near).map(|other| other as f64).collect();
            let found = partners(&strips, rank, width).into_iter().map(f64::from).collect();
            let edges =
                if ranks < 9 { format!("cut at {:?}, ", strips.edges) } else { String::new() };
            ask(
                &format!("{ranks} strips, {edges}ghosts {width:?} wide: partners of rank {rank}"),
                found,
                right,
            );
        }
    }
}

/// Few and many particles before and after a strip, inside the width, at it, a hair further, and far.
pub(super) fn ghosts(random: &mut Random, ask: Ask<'_>) {
    for n in random.sizes(65_537).into_iter().flat_map(|n| [n, n]).chain([70_000]) {
        let unit = unit(random);
        let whole = |random: &mut Random, most: usize| (1 + random.below(most)) as f64 * unit;
        let (width, below) = (whole(random, 20), random.below(2) == 0);
        let start = 100.0 * unit + whole(random, 50);
        let end = start + whole(random, 5);
        let at = if below { start - width } else { end + width };
        let strip: Range<f64> = match (below, random.below(3)) {
            (true, 0) => start..f64::INFINITY,
            (false, 0) => f64::NEG_INFINITY..end,
            _ => start..end,
        };
        let far = |random: &mut Random| random.magnitude(1e-12, 50.0) * unit;
        let y: Vec<f64> = (0..n)
            .map(|_| match random.below(4) {
                0 => beside(at)[random.below(3)],
                1 if below => (start - far(random)).next_down(),
                1 => end + far(random),
                2 => at + far(random).min(0.9 * width) * if below { 1.0 } else { -1.0 },
                _ => at - far(random) * if below { 1.0 } else { -1.0 },
            })
            .collect();
        let near = |y: f64| if below { y >= at } else { y <= at };
        let right = (0..n).filter(|&index| near(y[index])).map(|index| index as f64).collect();
        let found = choose(&y, &strip, width).into_iter().map(f64::from).collect();
        let shown = if n < 9 { format!(" at y = {y:?}") } else { String::new() };
        ask(
            &format!("of {n} particles{shown} those no further than {width:?} from {strip:?}"),
            found,
            right,
        );
    }
}

/// Few and many on both sides: in whole numbers, some of them exactly at reach, and anywhere; or all at one position.
pub(super) fn across(random: &mut Random, ask: Ask<'_>) {
    let few = random.sizes(257).into_iter().flat_map(|n| [(n, 7), (7, n), (n, n)]);
    for (case, (own, ghosts)) in few.chain([(1, 70_000), (70_000, 1)]).enumerate() {
        let unit = unit(random);
        let side = [3, 12, 60][case % 3];
        let mut axis = |n: usize| -> Vec<f64> {
            (0..n)
                .map(|_| match case % 4 {
                    0 | 1 => random.below(side) as f64 * unit,
                    2 => random.between(0.0, side as f64) * unit,
                    _ => 0.1 * unit,
                })
                .collect()
        };
        let [x, y, ghost_x, ghost_y] = [axis(own), axis(own), axis(ghosts), axis(ghosts)];
        let reach = beside([1.0, 2.0, 5.0, 0.01][random.below(4)] * unit)[random.below(3)];
        let mut right = Vec::new();
        for (i, j) in (0..own).flat_map(|i| (0..ghosts).map(move |j| (i, j))) {
            let (dx, dy) = (ghost_x[j] - x[i], ghost_y[j] - y[i]);
            if dx * dx + dy * dy <= reach * reach {
                right.extend([i as f64, j as f64]);
            }
        }
        let positions = |x, y| Positions { x, y, first: 0 };
        let mut pairs = pairs_across(positions(&x, &y), positions(&ghost_x, &ghost_y), reach);
        let name = format!(
            "{own} particles and {ghosts} ghosts in {side} by {side}, reach {:?}",
            reach / unit
        );
        ask(
            &format!("{name}: do pairs ascend in the first?"),
            flags(&[pairs.is_sorted_by_key(|pair| pair[0])]),
            flags(&[true]),
        );
        pairs.sort_unstable();
        let found = pairs.as_flattened().iter().map(|k| f64::from(*k)).collect();
        ask(&format!("{name}: own particle and ghost of each pair"), found, right);
    }
    // Who looks at every pair does not come to an end.
    let x: Vec<f64> = (0..500_000).map(f64::from).collect();
    let y = vec![0.0; x.len()];
    let positions = || Positions { x: &x, y: &y, first: 0 };
    let pairs = pairs_across(positions(), positions(), 0.5);
    let alike = pairs.iter().filter(|[own, ghost]| own == ghost).count();
    let question = "half a million in a row, and a ghost at each: how many pairs, how many of them are of one position";
    ask(question, vec![pairs.len() as f64, alike as f64], vec![5e5; 2]);
}

/// Positions to partners in any order, from none to all other ranks: none, few and many, and not as many each way.
/// Which calls of MPI come before the inner particles move is heard by a watch.
pub(super) fn exchanges(world: &SimpleCommunicator, random: &mut Random, ask: Ask<'_>) {
    let (rank, ranks) = (world.rank(), world.size());
    let within = |furthest| -> Vec<Rank> {
        let others = others_within(furthest, rank as usize, ranks as usize);
        others.into_iter().map(|other| other as Rank).collect()
    };
    let all = ranks as usize;
    for (most, furthest) in [(0, 1), (7, all), (1000, 2), (300_000, all)] {
        let partners = within(furthest);
        let lengths: Vec<usize> = (0..ranks * ranks).map(|_| random.below(most + 1)).collect();
        let letter = |from: Rank, to: Rank| -> Vec<f64> {
            let length = lengths[(ranks * from + to) as usize];
            (0..length).map(|k| f64::from(10 * from + to) + k as f64).collect()
        };
        let sent: Vec<_> = partners.iter().map(|to| letter(rank, *to)).collect();
        let right: Vec<_> = partners.iter().map(|from| letter(*from, rank)).collect();
        let mut received: Vec<_> = right.iter().map(|letter| vec![-1.0; letter.len()]).collect();
        let mut calls = Vec::new();
        together("exchange_positions", || {
            let meanwhile = || calls.push(calls_made());
            exchange_positions(world, &partners, &sent, &mut received, meanwhile);
        });
        let name = format!("rank {rank} of {ranks}, lists of up to {most}");
        let question = format!("{name}: how often its inner particles move");
        ask(&question, vec![calls.len() as f64], vec![1.0]);
        let before = calls.first().map_or(&[][..], |calls| calls);
        let made = |call: &str| before.iter().filter(|made| **made == call).count();
        let (receives, sends) = (made("MPI_Irecv"), made("MPI_Isend"));
        let question =
            format!("{name}: receives and sends begun, and other calls, before they move");
        ask(
            &question,
            [receives, sends, before.len() - receives - sends].map(|n| n as f64).to_vec(),
            [partners.len(), partners.len(), 0].map(|n| n as f64).to_vec(),
        );
        let told = |letters: &[Vec<f64>]| {
            let told = |letter: &Vec<f64>| digest(letter.iter().map(|x| (*x, 0)));
            let mut told: Vec<f64> = letters.iter().flat_map(told).collect();
            told.resize(3 * all, 0.0);
            told
        };
        let question =
            format!("{name}: how many positions come from each partner, and sums of them");
        ask(&question, told(&received), told(&right));
    }
    let partners = within(all);
    let sent = vec![vec![0.5; 4000]; partners.len()];
    let mut received = sent.clone();
    let mut turn = |_| {
        let call = || exchange_positions(world, &partners, &sent, &mut received, || ());
        together("exchange_positions", call);
        world.barrier();
    };
    let name = format!("exchange_positions on rank {rank} of {ranks}");
    memory(&name, (50, 4000 * size_of::<f64>()), |turns| (0..turns).for_each(&mut turn), ask);
}

/// Loads of few and many, and their shares in few and many rows, in which a product needs more than 64 bits.
pub(super) fn loads(random: &mut Random, ask: Ask<'_>) {
    let count = |random: &mut Random| match random.below(4) {
        0 => 0,
        1 => random.size(70_000) as u64,
        _ => random.magnitude(1.0, 1e12) as u64,
    };
    for _ in 0..500 {
        let (particles, pairs) = (count(random) as usize, count(random) as usize);
        let right = (MOVED * particles as f64 + LISTED * pairs as f64).ceil();
        let found = load(particles, pairs) as f64;
        ask(&format!("load of {particles} particles, {pairs} pairs"), vec![found], vec![right]);
    }
    for rows in random.sizes(4097).into_iter().flat_map(|rows| [rows; 5]) {
        let counts: Vec<u64> = (0..rows).map(|_| count(random)).collect();
        let counts = if random.below(6) == 0 { vec![0; rows] } else { counts };
        let load = random.magnitude(1.0, 9e18) as u64;
        let all: u128 = counts.iter().map(|&count| u128::from(count)).sum();
        let share = |&count: &u64| (u128::from(load) * u128::from(count) / all.max(1)) as u64;
        // Two halves: a number with a point has 53 bits.
        let halves = |shares: Vec<u64>| {
            shares
                .into_iter()
                .flat_map(|share| [(share >> 32) as f64, f64::from(share as u32)])
                .collect()
        };
        let shown = if rows < 9 { format!("{counts:?}") } else { format!("{rows} counts") };
        let question =
            format!("a load of {load} in rows of {shown}: upper and lower 32 bits of each share");
        ask(
            &question,
            halves(weigh_rows(&counts, load)),
            halves(counts.iter().map(share).collect()),
        );
    }
}

/// Whether lists are rebuilt: where one rank has to, because of its list or of a particle that has gone half of what
/// there is between cutoff and width, a hair more or less.
pub(super) fn renewals(world: &SimpleCommunicator, random: &mut Random, ask: Ask<'_>) {
    let (rank, ranks) = (world.rank() as usize, world.size() as usize);
    for _ in 0..60 {
        let width = CUTOFF * [2.0, random.magnitude(1.0, 1e6), 1.0][random.below(3)];
        let half = 0.5 * (width - CUTOFF);
        let shares = [0.0, 0.5, 1.0 - 1e-12, if width == 2.0 * CUTOFF { 1.0 } else { 0.999 }];
        let mut said: Vec<(bool, f64)> =
            (0..ranks).map(|_| (false, half * shares[random.below(4)])).collect();
        let one = random.below(ranks);
        match random.below(3) {
            0 => said[one].0 = true,
            1 => {
                said[one].1 =
                    half * [1.0 + 1e-12, random.magnitude(1.001, 1e9)][random.below(2)] + 1e-300
            }
            _ => {}
        }
        let right = said.iter().any(|&(expired, moved)| expired || moved > half);
        let found = together("must_renew", || must_renew(world, said[rank].0, said[rank].1, width));
        let question = format!(
            "are lists rebuilt? Of each of {ranks} ranks whether its list has expired, and how far a particle \
             has gone: {said:?}, ghosts {width:?} wide"
        );
        ask(&question, flags(&[found]), flags(&[right]));
        let name = format!("{question}, rank {rank}");
        no_other_calls(&calls_made(), &["MPI_Allreduce"], &name, ask);
    }
}

/// How far the fastest go in few and many steps, and ghosts as deep as makes some of them right: a hair more or less.
pub(super) fn rights(random: &mut Random, ask: Ask<'_>) {
    for taken in
        random.sizes(257).into_iter().filter(|&taken| taken > 0).flat_map(|taken| [taken; 20])
    {
        let moves: Vec<f64> = (0..taken).map(|_| CUTOFF * random.magnitude(1e-6, 1e3)).collect();
        let moves = if random.below(5) == 0 { vec![0.0; taken] } else { moves };
        let right = 1 + random.below(taken);
        let needed =
            |steps: usize| CUTOFF * steps as f64 + 2.0 * moves[..steps - 1].iter().sum::<f64>();
        let (hair, more) = (1.0 + 3e-13, random.between(0.0, 0.9));
        let next = if right < taken { needed(right + 1) } else { 2.0 * needed(right) };
        let least = needed(right);
        let width = [least * hair, next / hair, least + more * (next - least)][random.below(3)];
        let found = right_steps(&moves, width) as f64;
        let shown = if taken < 9 { format!("{moves:?}") } else { String::new() };
        let question = format!(
            "{taken} steps were taken, moves {shown}, ghosts are {width:?} deep: how many are right"
        );
        ask(&question, vec![found], vec![right as f64]);
    }
    let question = "2 steps were taken, nothing moves, ghosts are exactly two cutoffs deep: how many are right";
    ask(question, vec![right_steps(&[0.0, 0.0], 2.0 * CUTOFF) as f64], vec![2.0]);
}

/// What all ranks say: how many steps are right on all of them, and the greatest of each number.
pub(super) fn confirmations(world: &SimpleCommunicator, random: &mut Random, ask: Ask<'_>) {
    let (rank, ranks) = (world.rank() as usize, world.size() as usize);
    for _ in 0..60 {
        let (steps, more) = (1 + random.below(12), random.below(4));
        let said: Vec<Vec<f64>> = (0..ranks)
            .map(|_| (0..steps + more).map(|_| CUTOFF * random.magnitude(1e-3, 10.0)).collect())
            .collect();
        let greatest = |k: usize| said.iter().map(|said| said[k]).fold(0.0, f64::max);
        let all: Vec<f64> = (0..steps + more).map(greatest).collect();
        let width = CUTOFF * random.magnitude(1.0, 100.0);
        let needed =
            |steps: usize| CUTOFF * steps as f64 + 2.0 * all[..steps - 1].iter().sum::<f64>();
        let right = (1..=steps).take_while(|&k| k == 1 || needed(k) <= width).count();
        let mut found = said[rank].clone();
        let confirmed = together("confirm", || confirm(world, &mut found, steps, width));
        let question = format!(
            "{ranks} ranks, {steps} steps were taken, ghosts are {width:?} deep, they say {said:?}: how many are right \
             on all, and what is said then"
        );
        ask(
            &question,
            [vec![confirmed as f64], found].concat(),
            [vec![right as f64], all].concat(),
        );
        let name = format!("{question}, rank {rank}");
        no_other_calls(&calls_made(), &["MPI_Allreduce"], &name, ask);
    }
}
