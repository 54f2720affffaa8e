//! Questions about lists that travel between ranks.

use common_mpi::{Ghost, calls_made};
use lab6::{exchange_all, exchange_beside};
use oracle::{Ask, Random, begins_send, digest, integers, no_other_calls, others_within};
use oracle_mpi::{Rank, on_each};

/// Number of items of a list in a long run.
const LONG: usize = 1000;

/// Draws lists from every rank to every rank, `[from][to]`, some of them empty.
fn letters(random: &mut Random, ranks: usize, most: usize) -> Vec<Vec<Vec<Ghost>>> {
    let to_all = |random: &mut Random| (0..ranks).map(|_| list(random, most)).collect();
    (0..ranks).map(|_| to_all(random)).collect()
}

fn list(random: &mut Random, most: usize) -> Vec<Ghost> {
    let n = random.below(4) * most / 3;
    let mut ghost = |id| Ghost { x: random.between(0.0, 1.0), y: random.between(0.0, 1.0), id };
    (0..n as u64).map(&mut ghost).collect()
}

/// Returns the length of a list and two sums of its items.
fn sums_of(list: &[Ghost]) -> Vec<f64> {
    digest(list.iter().map(|ghost| (ghost.x + 2.0 * ghost.y, ghost.id)))
}

/// Asks about lists to and from other ranks, in any order, neighbours or all ranks. The lists are
/// empty, short, or longer than the library can buffer for a rank that sends before it receives.
pub(crate) fn exchanges(random: &mut Random, ask: &mut impl Ask) {
    on_each(ask, "6.3", &[1, 2, 3, 5], random, |rank, random, ask| {
        for (most, furthest) in [(0, 1), (5, rank.ranks), (1000, 1), (200_000, rank.ranks)] {
            let others = others_within(furthest, rank.number, rank.ranks);
            exchange(rank, &others, &letters(random, rank.ranks, most), most, ask);
        }
        let others = others_within(1, rank.number, rank.ranks);
        let list = vec![Ghost { x: 0.5, y: 0.5, id: 7 }; LONG];
        let outgoing: Vec<_> = others.iter().map(|&to| (to as i32, list.clone())).collect();
        let turn = |world: &_| _ = exchange_beside(world, &outgoing, || ());
        rank.keeps_its_memory("exchange_beside", LONG * size_of::<Ghost>(), turn, ask);
    });
}

/// Asks about one exchange of a rank with these other ranks.
fn exchange(
    rank: &Rank<'_>,
    others: &[usize],
    letters: &[Vec<Vec<Ghost>>],
    most: usize,
    ask: &mut impl Ask,
) {
    let list_to = |to: &usize| (*to as i32, letters[rank.number][*to].clone());
    let outgoing: Vec<_> = others.iter().map(list_to).collect();
    let mut before = Vec::new();
    let (incoming, result) = rank.call("exchange_beside", |world| {
        exchange_beside(world, &outgoing, || {
            before.push(calls_made());
            6 * 7
        })
    });
    let all = calls_made();
    let name = format!(
        "exchange_beside on {}, lists of up to {most} items for ranks {others:?}",
        rank.name()
    );
    let question = format!(
        "{name}: (1) number of calls of `work`, (2) number of sends and receives under way when `work` is called \
         first, (3) number of other MPI calls before `work`, (4) number of MPI calls after `work` that do not wait, \
         (5) the result of `work`"
    );
    // A list without items needs no message, because both sides know its length at this point.
    let travels = |other: &usize| {
        let lists = [&letters[rank.number][*other], &letters[*other][rank.number]];
        lists.iter().filter(|list| !list.is_empty()).count()
    };
    let least = others.iter().map(travels).sum();
    let verdict = |found: &[f64]| overlap(found, least, 2 * others.len());
    ask.judge(&question, || [counted(&before, &all), vec![f64::from(result)]].concat(), verdict);
    ask.exact(
        &format!("{name}: number of lists that arrive. Then for each list: its length, a checksum of its items in \
                  their order, and the sum of its ids"),
        || of_all(&incoming, rank.ranks),
        || of_all(others.iter().map(|&from| &letters[from][rank.number]), rank.ranks),
    );
}

/// Returns counts of the work, of the travelling messages, and of other calls before and after the
/// work. Calls after the work are counted unless they are waits. `before` contains the calls before
/// each work.
fn counted(before: &[Vec<&str>], all: &[&str]) -> Vec<f64> {
    let first = before.first().map_or(&[][..], |calls| calls);
    let under_way = first.iter().rev().take_while(|call| begins(call)).count();
    let others = first.iter().filter(|call| !begins(call) && !waits(call)).count();
    let later = all[first.len()..].iter().filter(|call| !waits(call)).count();
    integers([before.len(), under_way, others, later])
}

fn begins(call: &str) -> bool {
    begins_send(call) || call == "MPI_Irecv"
}

fn waits(call: &str) -> bool {
    call.starts_with("MPI_Wait")
}

/// Checks that the lists travel while the work is done: at `least` and at `most` this number of
/// messages.
fn overlap(found: &[f64], least: usize, most: usize) -> Result<(), String> {
    let &[works, under_way, others, later, result] = found else {
        return Err("the answer is not complete".into());
    };
    let words = if works != 1.0 || result != 42.0 {
        format!(
            "`work` is called {works} times, and its result is returned as {result}. It must be called once, and its \
             result is 42"
        )
    } else if others > 0.0 {
        format!(
            "{others} MPI calls before `work` neither begin a message nor wait for a message. Use only immediate \
             sends and receives"
        )
    } else if later > 0.0 {
        format!(
            "{later} MPI calls after `work` do not wait for messages. Start all messages before `work`: it must \
             overlap with the messages that carry the items, and not only with the messages that carry their lengths. \
             Then wait for each message, and do not ask in a loop whether a message has arrived"
        )
    } else if under_way < least as f64 {
        format!(
            "{under_way} sends and receives are under way when `work` is called, but {least} lists contain items. \
             Start the messages of all these lists before `work`, and wait for the messages after it"
        )
    } else if under_way > most as f64 {
        format!(
            "{under_way} sends and receives are under way when `work` is called, but there are only {most} lists. Wait \
             for the lengths first"
        )
    } else {
        return Ok(());
    };
    Err(words)
}

/// Returns the number of lists, and the sums of each.
fn of_all<'a>(lists: impl IntoIterator<Item = &'a Vec<Ghost>>, ranks: usize) -> Vec<f64> {
    let sums: Vec<Vec<f64>> = lists.into_iter().map(|list| sums_of(list)).collect();
    let mut all = vec![sums.len() as f64];
    all.extend(sums.concat());
    all.resize(1 + 3 * ranks, 0.0);
    all
}

/// Asks about lists from all ranks to all ranks. The lists are empty, then they have a few items,
/// then more items than 16 bits can count, and finally fewer.
pub(crate) fn lists_of_all(random: &mut Random, ask: &mut impl Ask) {
    on_each(ask, "6.4", &[1, 2, 3, 5], random, |rank, random, ask| {
        for most in [0, 5, 70_000, 5] {
            let letters = letters(random, rank.ranks, most);
            let own = &letters[rank.number];
            let found = rank.call("exchange_all", |world| exchange_all(world, own));
            let made = calls_made();
            let question = format!(
                "exchange_all on {}, lists of up to {most} items: (1) number of items that arrive, (2) a checksum of \
                 these items in their order, (3) the sum of their ids",
                rank.name()
            );
            ask.exact(
                &question,
                || sums_of(&found),
                || {
                    let all = letters.iter().map(|from| &from[rank.number][..]);
                    sums_of(&all.collect::<Vec<_>>().concat())
                },
            );
            let name = format!("exchange_all on {}", rank.name());
            no_other_calls(&made, &["MPI_Alltoall", "MPI_Alltoallv"], &name, ask);
        }
        let lists = vec![vec![Ghost { x: 0.5, y: 0.5, id: 7 }; LONG]; rank.ranks];
        let turn = |world: &_| _ = exchange_all(world, &lists);
        rank.keeps_its_memory("exchange_all", LONG * size_of::<Ghost>(), turn, ask);
    });
}
