//! Questions about the two loops over all pairs, of which one or both are shared out: task 7.9.

use std::ops::Range;
use std::sync::Mutex;

use hard_discs::{Schedule, Team};
use lab7::{fixed_part, inner, nested, outer};
use oracle::{Ask, Random, integers};

/// A way of sharing out the loops over all pairs.
pub(crate) type Loop = fn(usize, Team, Schedule, &(dyn Fn(usize, usize, Range<usize>) + Sync));

/// Names and functions of the ways in which the loops are shared out.
pub(crate) const SHARES: [(&str, Loop); 3] = [
    ("the outer loop", |n, team, schedule, look| outer(n, team, schedule, look)),
    ("the inner loop", |n, team, schedule, look| inner(n, team, schedule, look)),
    ("both loops", |n, team, schedule, look| nested(n, team, schedule, look)),
];
pub(crate) const OUTER: usize = 0;
pub(crate) const INNER: usize = 1;
pub(crate) const NESTED: usize = 2;

/// Returns the pair tests of one way, as a sorted list of three numbers each.
fn looks(
    n: usize,
    team: Team,
    schedule: Schedule,
    share: Loop,
    numbers: impl Fn(usize, usize, Range<usize>) -> Vec<[usize; 3]> + Sync,
) -> Vec<usize> {
    let looks = Mutex::new(Vec::new());
    share(n, team, schedule, &|list, a, partners| {
        looks
            .lock()
            .expect("no thread panics while it holds this lock")
            .extend(numbers(list, a, partners));
    });
    let mut looks = looks.into_inner().expect("as above");
    looks.sort_unstable();
    looks.concat()
}

/// Returns the lab's fixed parts of all loops of up to `n` iterations: start and end of each
/// worker's part. Another task checks whether these parts are correct.
fn own_parts(n: usize, workers: usize) -> Vec<usize> {
    let all = (0..=n).flat_map(|n| (0..workers).map(move |worker| fixed_part(n, workers, worker)));
    all.flat_map(|part| [part.start, part.end]).collect()
}

/// Fixed parts of loops, as [`own_parts`] recorded them.
struct Parts<'a> {
    ends: &'a [f64],
    workers: usize,
}

impl<'a> Parts<'a> {
    /// Splits `found` into the parts of all loops of up to `n` iterations and the numbers after
    /// them.
    fn split(found: &'a [f64], n: usize, workers: usize) -> Result<(Self, &'a [f64]), String> {
        let split = found.split_at_checked(2 * (n + 1) * workers);
        let (ends, rest) = split.ok_or("the answer is not complete")?;
        Ok((Self { ends, workers }, rest))
    }

    fn part(&self, n: usize, worker: usize) -> Range<usize> {
        let at = 2 * (n * self.workers + worker);
        self.ends[at] as usize..self.ends[at + 1] as usize
    }

    /// Returns the worker whose part contains iteration `k` of a loop over `0..n`.
    fn owner(&self, n: usize, k: usize) -> usize {
        (0..self.workers).find(|&worker| self.part(n, worker).contains(&k)).unwrap_or(0)
    }

    /// Returns the list that receives each pair of `n` discs, in the order of pairs.
    fn lists(&self, which: usize, n: usize) -> Vec<[usize; 3]> {
        let mut right = Vec::new();
        for a in 0..n {
            for b in a + 1..n {
                let row = self.owner(n, a);
                let column = self.owner(n - a - 1, b - a - 1);
                right.push([a, b, [row, column, row * self.workers + column][which]]);
            }
        }
        right
    }
}

/// Compares pair tests of three numbers each. `third` describes the third number.
fn compare_looks(found: &[f64], right: &[[usize; 3]], third: &str) -> Result<(), String> {
    let words = |look: Option<[usize; 3]>| match look {
        Some([a, b, number]) => format!("disc {a}, {b}, {third} {number}"),
        None => "none".into(),
    };
    let found: Vec<[usize; 3]> =
        found.as_chunks::<3>().0.iter().map(|look| look.map(|number| number as usize)).collect();
    let most = found.len().max(right.len());
    match (0..most).find(|&k| found.get(k) != right.get(k)) {
        Some(k) => Err(format!(
            "entry {k} of {most} in the list of pairs or parts, in ascending order\n     found: {}\n  expected: {}",
            words(found.get(k).copied()),
            words(right.get(k).copied())
        )),
        None => Ok(()),
    }
}

/// Asks which list receives each pair if the parts are fixed.
pub(crate) fn fixed_loops(random: &mut Random, ask: &mut impl Ask) {
    for (which, (name, share)) in SHARES.into_iter().enumerate() {
        // A sandbox has no room for 17 teams of 17 threads.
        let most = [17, 17, 9][which];
        for n in random.sizes(33) {
            for workers in [1, 2, 3, 8, most] {
                let found = || {
                    let team = Team::Fresh(workers);
                    let looks = looks(n, team, Schedule::Static, share, |list, a, partners| {
                        partners.take(100).map(|b| [a, b, list]).collect()
                    });
                    integers([own_parts(n, workers), looks].concat())
                };
                let question = format!(
                    "{name} of {n} discs, {workers} workers, fixed parts: (1) in loops of 0 to {n} iterations, the \
                     start and end of the part that the lab's own function gives to each worker, (2) for each pair, \
                     both discs and the list that receives the pair"
                );
                ask.judge(&question, found, |found| {
                    let (parts, looks) = Parts::split(found, n, workers)?;
                    compare_looks(looks, &parts.lists(which, n), "list")
                });
            }
        }
    }
}

/// Returns the parts of rows if a queue shares out the loop: a disc, the first partner of a part,
/// and the part's end.
fn parts_of_rows(parts: &Parts, which: usize, n: usize, chunk: usize) -> Vec<[usize; 3]> {
    let mut right = Vec::new();
    for a in 0..n {
        let row = n - a - 1;
        let step = if which == OUTER { 1 } else { chunk };
        let cut: Vec<Range<usize>> = match which {
            NESTED => (0..parts.workers).map(|member| parts.part(row, member)).collect(),
            _ => (0..row).step_by(step).map(|k| k..row.min(k + step)).collect(),
        };
        let parts = cut.into_iter().filter(|part| !part.is_empty());
        right.extend(parts.map(|part| [a, a + 1 + part.start, a + 1 + part.end]));
    }
    right
}

/// Asks for the pair tests from a queue. Each pair is tested once.
pub(crate) fn queued_loops(random: &mut Random, ask: &mut impl Ask) {
    for (which, (name, share)) in SHARES.into_iter().enumerate() {
        for n in random.sizes(33) {
            let workers = 1 + random.below(4);
            let chunk = 1 + random.below(5);
            let found = || {
                let queue = Schedule::Dynamic { chunk };
                let looks = looks(n, Team::Fresh(workers), queue, share, |_, a, partners| {
                    // A row's worker may test the row in any number of parts.
                    let step = if which == OUTER { 1 } else { partners.len().max(1) };
                    partners.step_by(step).map(|b| [a, b, b + step]).collect()
                });
                integers([own_parts(n, workers), looks].concat())
            };
            let question = format!(
                "{name} of {n} discs, {workers} workers, chunks of {chunk}: (1) in loops of 0 to {n} iterations, \
                 the start and end of the part that the lab's own function gives to each worker, (2) for each part of \
                 a row, the disc, the first partner and the end of the part"
            );
            ask.judge(&question, found, |found| {
                let (parts, looks) = Parts::split(found, n, workers)?;
                compare_looks(looks, &parts_of_rows(&parts, which, n, chunk), "up to")
            });
        }
    }
}
