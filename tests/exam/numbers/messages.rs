//! Labs 5, 6, 8 and 13.

use super::{Numbers, integers, starts};

pub(super) fn numbers() -> Vec<Numbers> {
    [root(), neighbours(), workers(), strips()].concat()
}

/// Returns the starts of blocks of rows, and the end of the last block.
fn cuts(rows: usize, ranks: usize) -> Vec<usize> {
    (0..=ranks).map(|k| k * rows / ranks).collect()
}

/// Returns the number of particles in each block.
fn held(rows: &[usize], cuts: &[usize]) -> Vec<usize> {
    cuts.windows(2).map(|ends| rows[ends[0]..ends[1]].iter().sum()).collect()
}

fn root() -> Vec<Numbers> {
    let ten = cuts(10, 4);
    let owner = |row: usize| ten.iter().rposition(|start| *start <= row).unwrap();
    let empty = cuts(3, 5).windows(2).filter(|ends| ends[0] == ends[1]).count();
    let counts = [3, 0, 2, 4];
    // Rank 0 owns rows 0 and 1. A ghost goes to the ranks with an adjacent row.
    let rank = |row: usize| row / 2;
    let ghosts = |row: usize| {
        let adjoin = [row.checked_sub(1), Some(row + 1).filter(|row| *row < 6)];
        adjoin.into_iter().flatten().map(rank).filter(move |to| *to != rank(row))
    };
    let routes = [2]
        .into_iter()
        .map(rank)
        .chain(ghosts(2))
        .chain(ghosts(3))
        .chain([rank(0)])
        .chain(ghosts(0));
    let copies = |ranks: usize| 2 * (ranks - 1) * 100 * 40;
    vec![
        ("5.1", integers([&ten[..4], &[owner(5), empty]].concat())),
        ("5.2", integers([starts(&counts), vec![counts.iter().sum()]].concat())),
        ("5.5", integers(routes)),
        ("5.7", integers([copies(16), copies(32), 2 * 100 * 40])),
    ]
}

fn neighbours() -> Vec<Numbers> {
    let rows = [0, 0, 8, 2, 2, 1, 1, 1, 1, 0];
    let before = |row: usize| rows[..row].iter().sum::<usize>();
    let start = |k: usize| (0..=10).find(|row| before(*row) >= k * 16 / 4).unwrap();
    let balanced = [0, start(1), start(2), start(3), 10];
    let owner =
        |row: usize| (0..4).find(|k| (balanced[*k]..balanced[k + 1]).contains(&row)).unwrap();
    let (fullest, equal) =
        (held(&rows, &balanced).into_iter().max(), held(&rows, &cuts(10, 4)).into_iter().max());
    let (fullest, equal) = (fullest.unwrap(), equal.unwrap());
    let overlap = |interior: f64| [interior.max(2.0) + 0.5, 2.0 + interior + 0.5];
    let table = [[0, 2, 1], [3, 0, 0], [1, 1, 0]];
    let counts = table.map(|row| row[0]);
    let mut balance = integers([start(1), start(2), start(3), fullest, equal]);
    balance.extend(integers([owner(balanced[2] - 1), owner(balanced[3])]));
    balance.push(fullest as f64 / (16.0 / 4.0));
    vec![
        ("6.1", balance),
        ("6.2", integers([4096 / 24])),
        ("6.4", vec![2.0 + 0.1e-3 * 24_000.0, 2.0 / 0.1e-3]),
        ("6.5", vec![100.0, 100.0_f64.sqrt(), 2.0 / (4.0 / 8.0)]),
        ("6.6", [overlap(3.0), overlap(1.0)].concat()),
        ("6.7", integers([&counts[..], &starts(&counts)].concat())),
    ]
}

fn workers() -> Vec<Numbers> {
    let jobs =
        |worker: usize| [(0, 0), (0, 1), (1, 3)].map(|(a, b)| ((a + worker) % 5, (b + worker) % 5));
    let third = jobs(3).into_iter().flat_map(|(a, b)| [a, b]);
    let mut dealt: Vec<_> = (0..5).flat_map(jobs).map(|(a, b)| (a.min(b), a.max(b))).collect();
    dealt.sort_unstable();
    dealt.dedup();
    let distances = |blocks: &[usize], ring: usize| {
        let pairs = blocks
            .iter()
            .enumerate()
            .flat_map(|(at, a)| blocks[at + 1..].iter().map(move |b| b - a));
        pairs.map(|apart| apart.min(ring - apart)).collect::<Vec<_>>()
    };
    let (seven, thirteen) = (distances(&[0, 1, 3], 7), distances(&[0, 1, 3, 9], 13));
    let most = [seven.len(), thirteen.len()];
    vec![
        ("8.1", integers(third.chain([dealt.len()]))),
        ("8.2", integers([seven, thirteen, most.to_vec()].concat())),
        ("8.3", integers([3, 4].map(|blocks| blocks * 10_000 * 48))),
        ("8.4", [2.0, 3.0, 16.0].map(|p| (p - 1.0) / p).to_vec()),
        ("8.5", integers([rounds(4), rounds(8)])),
    ]
}

/// Returns the rounds of a chain of candidates. The candidate at index i has discs i and i + 1, and
/// is earlier than the candidates after it.
fn rounds(candidates: usize) -> usize {
    let mut open: Vec<usize> = (0..candidates).collect();
    let mut rounds = 0;
    while !open.is_empty() {
        let first_of = |disc: usize| open.iter().find(|c| **c == disc || **c + 1 == disc).copied();
        let taken: Vec<usize> =
            open.iter().copied().filter(|c| [*c, *c + 1].map(first_of) == [Some(*c); 2]).collect();
        open.retain(|c| taken.iter().all(|taken| c.abs_diff(*taken) > 1));
        rounds += 1;
    }
    rounds
}

fn strips() -> Vec<Numbers> {
    let width = |m: f64| 1.0 + 2.0 * (m - 1.0) * 0.1;
    let depth = |m: f64| m + 2.0 * (m - 1.0) * 0.1;
    let moves = [0.1, 0.2, 0.5, 0.6];
    let right =
        (1..=4).filter(|k| *k as f64 + 2.0 * moves[..k - 1].iter().sum::<f64>() <= 5.5).max();
    let (shallow, deep) = (|alpha: f64| 10.0 * (alpha + 16.0), |alpha: f64| alpha + 120.0 + 300.0);
    let loads = [(1e4, 5e3), (8e3, 2e4)].map(|(particles, pairs)| 2.0 * particles + 0.65 * pairs);
    vec![
        ("13.1", vec![width(1.0), width(10.0)]),
        ("13.2", vec![depth(10.0), 2.0 * depth(10.0) / 100.0, 2.0 * width(10.0) / 100.0]),
        ("13.3", integers(right)),
        ("13.4", integers([10 * 2 * 4, 10 * 2, 2])),
        ("13.5", vec![shallow(20.0), deep(20.0), (deep(0.0) - shallow(0.0)) / 9.0]),
        ("13.7", vec![loads[0], loads[1], loads[1] / ((loads[0] + loads[1]) / 2.0)]),
    ]
}
