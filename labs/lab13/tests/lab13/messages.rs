//! Questions about positions that travel between ranks, and about the decision to rebuild lists.

use common::soft::CUTOFF;
use common_mpi::calls_made;
use lab13::{exchange_positions, must_renew};
use oracle::{Ask, Random, begins_send, digest, integers, others_within, truth};
use oracle_mpi::{Rank, on_each};

/// Positions that travel between ranks.
struct Letters {
    /// Number of positions from rank to rank, `[from][to]`.
    lengths: Vec<Vec<usize>>,
    /// Ranks with which this rank exchanges positions.
    partners: Vec<usize>,
}

impl Letters {
    fn letter(&self, from: usize, to: usize) -> Vec<f64> {
        (0..self.lengths[from][to]).map(|k| (10 * from + to + k) as f64).collect()
    }

    fn ranks(&self) -> Vec<mpi::Rank> {
        self.partners.iter().map(|&partner| partner as mpi::Rank).collect()
    }
}

/// Asks about exchanges of positions with any number of partners, in any order. The numbers of
/// positions differ in the two directions: zero, few or many.
pub(crate) fn exchanges(random: &mut Random, ask: &mut impl Ask) {
    on_each(ask, "13.4", &[1, 2, 3, 5], random, |rank, random, ask| {
        for (most, furthest) in [(0, 1), (7, rank.ranks), (1000, 2), (300_000, rank.ranks)] {
            let mut lengths = vec![vec![0; rank.ranks]; rank.ranks];
            lengths.iter_mut().flatten().for_each(|length| *length = random.below(most + 1));
            let partners = others_within(furthest, rank.number, rank.ranks);
            exchange(rank, &Letters { lengths, partners }, most, ask);
        }
        keeps_its_memory(rank, ask);
    });
}

/// Asks about one exchange.
fn exchange(rank: &Rank<'_>, letters: &Letters, most: usize, ask: &mut impl Ask) {
    let Letters { lengths, partners } = letters;
    let own = rank.number;
    let sent: Vec<Vec<f64>> = partners.iter().map(|&to| letters.letter(own, to)).collect();
    let mut received: Vec<Vec<f64>> =
        partners.iter().map(|&from| vec![-1.0; lengths[from][own]]).collect();
    let mut calls = Vec::new();
    rank.call("exchange_positions", |world| {
        let meanwhile = || calls.push(calls_made());
        exchange_positions(world, &letters.ranks(), &sent, &mut received, meanwhile);
    });
    let name =
        format!("{}, lists of up to {most} positions for the ranks {partners:?}", rank.name());
    let times = || vec![calls.len() as f64];
    ask.exact(&format!("{name}: number of times that the inner particles move"), times, || {
        vec![1.0]
    });
    let before = calls.first().map_or(&[][..], |calls| calls);
    ask.exact(
        &format!(
            "{name}: before the inner particles move, (1) number of receives begun, (2) number of sends begun, (3) \
             number of other MPI calls"
        ),
        || made(before),
        || vec![partners.len() as f64, partners.len() as f64, 0.0],
    );
    ask.exact(
        &format!("{name}: for each partner, (1) number of positions from this partner, (2) a checksum of these \
                  positions in their order, (3) 0"),
        || received.iter().flat_map(|letter| sums_of(letter)).collect(),
        || partners.iter().flat_map(|&from| sums_of(&letters.letter(from, own))).collect(),
    );
}

/// Returns the numbers of calls that begin a receive, that begin a send, and of all other calls.
fn made(calls: &[&str]) -> Vec<f64> {
    let receives = calls.iter().filter(|call| **call == "MPI_Irecv").count();
    let sends = calls.iter().filter(|call| begins_send(call)).count();
    [receives, sends, calls.len() - receives - sends].map(|count| count as f64).to_vec()
}

fn sums_of(letter: &[f64]) -> Vec<f64> {
    digest(letter.iter().map(|x| (*x, 0)))
}

/// Asks whether the memory grows with the number of exchanges.
fn keeps_its_memory(rank: &Rank<'_>, ask: &mut impl Ask) {
    let partners: Vec<mpi::Rank> = others_within(rank.ranks, rank.number, rank.ranks)
        .into_iter()
        .map(|partner| partner as mpi::Rank)
        .collect();
    let sent = vec![vec![0.5; 4000]; partners.len()];
    let mut received = sent.clone();
    let turn = |world: &_| exchange_positions(world, &partners, &sent, &mut received, || ());
    rank.keeps_its_memory("exchange_positions", 4000 * size_of::<f64>(), turn, ask);
}

/// A rank's report before a step.
#[derive(Clone, Copy, Debug)]
struct Word {
    list_has_expired: bool,
    moved: f64,
}

/// Asks whether lists are rebuilt. One rank requires this because of its list, or because a
/// particle has moved half the difference of width and cutoff, or slightly more or less.
pub(crate) fn renewals(random: &mut Random, ask: &mut impl Ask) {
    on_each(ask, "13.6", &[1, 2, 3, 5], random, |rank, random, ask| {
        for _ in 0..60 {
            let width = CUTOFF * [2.0, random.magnitude(1.0, 1e6), 1.0][random.below(3)];
            let words = some_words(random, rank.ranks, width);
            renewal(rank, &words, width, ask);
        }
        // Before the first list there are no ghosts.
        let word = Word { list_has_expired: false, moved: f64::INFINITY };
        renewal(rank, &vec![word; rank.ranks], 0.0, ask);
    });
}

fn some_words(random: &mut Random, ranks: usize, width: f64) -> Vec<Word> {
    let half = 0.5 * (width - CUTOFF);
    let shares = [0.0, 0.5, 1.0 - 1e-12, if width == 2.0 * CUTOFF { 1.0 } else { 0.999 }];
    let mut words: Vec<Word> = (0..ranks)
        .map(|_| Word { list_has_expired: false, moved: half * shares[random.below(4)] })
        .collect();
    let one = &mut words[random.below(ranks)];
    match random.below(3) {
        0 => one.list_has_expired = true,
        1 => {
            let more = [1.0 + 1e-12, random.magnitude(1.001, 1e9)][random.below(2)];
            one.moved = half * more + 1e-300;
        }
        _ => {}
    }
    words
}

/// Asks for the decision of the ranks.
fn renewal(rank: &Rank<'_>, words: &[Word], width: f64, ask: &mut impl Ask) {
    let Word { list_has_expired, moved } = words[rank.number];
    let found = rank.call("must_renew", |world| must_renew(world, list_has_expired, moved, width));
    let name =
        format!("{}, ghosts {width:?} wide. The words of the ranks are {words:?}", rank.name());
    ask.exact(
        &format!("{name}: 1 if all ranks rebuild their lists, 0 if no rank rebuilds its list"),
        || vec![truth(found)],
        || {
            let half = 0.5 * (width - CUTOFF);
            let any = words.iter().any(|word| word.list_has_expired || word.moved > half);
            vec![truth(any)]
        },
    );
    one_reduction(&name, ask);
}

/// Asks whether the last call of the lab's function made a single MPI call, an Allreduce.
pub(crate) fn one_reduction(name: &str, ask: &mut impl Ask) {
    let calls = calls_made();
    let reductions = calls.iter().filter(|call| **call == "MPI_Allreduce").count();
    let question = format!("{name}: (1) number of MPI calls, (2) number of calls of Allreduce");
    ask.exact(&question, || integers([calls.len(), reductions]), || integers([1, 1]));
}
