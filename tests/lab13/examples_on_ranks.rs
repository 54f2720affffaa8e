//! The worked examples on three ranks.

use common::soft::CUTOFF;
use common_mpi::calls_made;
use lab13::{confirm, exchange_positions, must_renew};
use mpi::topology::SimpleCommunicator;
use oracle::{Ask, Random, begins_send, spaced};
use oracle_mpi::on_each;

/// Shows the positions that travel between ranks. Ranks 0 and 2 are partners of rank 1, which names
/// rank 2 first.
pub(crate) fn positions_travel(random: &mut Random, ask: &mut impl Ask) {
    on_each(ask, "13.4", &[3], random, |rank, _, ask| {
        let partners = [vec![1], vec![2, 0], vec![1]];
        let sent = [
            vec![vec![0.2, 0.7, 0.3, 0.8]],
            vec![vec![0.5, 1.9], vec![0.1, 1.1, 0.6, 1.2]],
            vec![vec![]],
        ];
        // The lengths are known since the list was made.
        let received = [vec![vec![0.0; 4]], vec![vec![], vec![0.0; 4]], vec![vec![0.0; 2]]];
        let own = rank.number;
        let rows = rank.call("exchange_positions", |world| {
            exchange(world, &partners[own], &sent[own], received[own].clone())
        });
        let table = rank.columns(&rows);
        if rank.is_root() {
            ask.example(|| table);
        }
    });
}

/// Returns the rows of a rank's column.
fn exchange(
    world: &SimpleCommunicator,
    partners: &[i32],
    sent: &[Vec<f64>],
    mut received: Vec<Vec<f64>>,
) -> Vec<(&'static str, String)> {
    let mut calls = Vec::new();
    let meanwhile = || calls.push(calls_made());
    exchange_positions(world, partners, sent, &mut received, meanwhile);
    vec![
        ("to rank: x y", by_rank(partners, sent)),
        ("inner particles move", format!("{} time", calls.len())),
        ("  then receives under way", count(&calls, |call| call == "MPI_Irecv")),
        ("  and sends under way", count(&calls, begins_send)),
        ("from rank: x y", by_rank(partners, &received)),
    ]
}

/// Counts the calls before the first move that `is_one` accepts.
fn count(calls: &[Vec<&str>], is_one: fn(&str) -> bool) -> String {
    let before = calls.first().map_or(&[][..], |calls| calls);
    before.iter().filter(|call| is_one(call)).count().to_string()
}

fn by_rank(partners: &[i32], lists: &[Vec<f64>]) -> String {
    let all = partners.iter().zip(lists);
    all.map(|(rank, list)| format!("{rank}: {}", spaced(list))).collect::<Vec<_>>().join("|")
}

/// Shows that one rank's decision suffices. Ghosts are two cutoffs wide, so a particle may move
/// half a cutoff.
pub(crate) fn one_decides(random: &mut Random, ask: &mut impl Ask) {
    on_each(ask, "13.6", &[3], random, |rank, _, ask| {
        let all = [
            [(false, 0.1), (false, 0.5), (false, 0.0)],
            [(false, 0.1), (false, 0.6), (false, 0.0)],
            [(true, 0.1), (false, 0.2), (false, 0.0)],
            [(true, 0.6), (true, 0.6), (true, 0.6)],
        ];
        let mut rows = Vec::new();
        for words in all {
            let (expired, moved) = words[rank.number];
            let renew = rank.call("must_renew", |world| {
                must_renew(world, expired, moved * CUTOFF, 2.0 * CUTOFF)
            });
            rows.push(("own list has expired", yes(expired)));
            rows.push(("moved / cutoff", moved.to_string()));
            rows.push(("  all rebuild lists", yes(renew)));
        }
        let table = rank.columns(&rows);
        if rank.is_root() {
            ask.example(|| table);
        }
    });
}

fn yes(is: bool) -> String {
    if is { "yes" } else { "no" }.into()
}

/// Shows the agreement on four steps, followed by two numbers for the next epoch. With a depth of
/// 5.5 cutoffs, four steps would be correct by the numbers of each rank alone.
pub(crate) fn confirmed(random: &mut Random, ask: &mut impl Ask) {
    on_each(ask, "13.8", &[3], random, |rank, _, ask| {
        let moves = [[0.1, 0.1, 0.1, 0.1], [0.5, 0.1, 0.1, 0.1], [0.1, 0.4, 0.1, 0.8]][rank.number];
        let others = [[7.0, 2.0], [9.0, 1.0], [8.0, 3.0]][rank.number];
        let mut numbers: Vec<f64> = moves.iter().map(|far| far * CUTOFF).collect();
        numbers.extend(others);
        let own = numbers.clone();
        let mut rows = vec![
            ("furthest in each step / cutoff", in_cutoffs(&own[..4])),
            ("other numbers", spaced(&own[4..])),
        ];
        for (depth, name) in
            [(5.5, "depth 5.5: steps right"), (4.5, "depth 4.5"), (2.5, "depth 2.5")]
        {
            numbers.clone_from(&own);
            let right =
                rank.call("confirm", |world| confirm(world, &mut numbers, 4, depth * CUTOFF));
            rows.push((name, right.to_string()));
        }
        rows.push(("furthest of all", in_cutoffs(&numbers[..4])));
        rows.push(("other numbers of all", spaced(&numbers[4..])));
        let table = rank.columns(&rows);
        if rank.is_root() {
            ask.example(|| table);
        }
    });
}

fn in_cutoffs(lengths: &[f64]) -> String {
    spaced(lengths.iter().map(|length| format!("{:.1}", length / CUTOFF)))
}
