//! Questions about one worker's parts of a loop, and its candidates in a list: tasks 7.8 and 7.10.

use hard_discs::{Candidate, Hit, LockedCount, SharedCount, Slots};
use lab7::{append_atomic, append_locked, fixed_part, next_part};
use oracle::{Ask, Random, integers};

use super::words::{EACH, number, values};

/// Asks for the fixed parts of loops of any length, including lengths beyond 32 bits.
pub(crate) fn parts(random: &mut Random, ask: &mut impl Ask) {
    for n in random.sizes(70_000).into_iter().chain([49, 61, 1 << 31, (1 << 32) + 7, 1 << 40]) {
        for workers in [1, 2, 3, 7, 8, 9, 33, 49, 256, 257, 1 + random.below(300)] {
            let part = |worker: usize| fixed_part(n, workers, worker);
            let question = format!(
                "{n} iterations in fixed parts for {workers} workers: start and end of each worker's part"
            );
            ask.judge(
                &question,
                || integers((0..workers).map(part).flat_map(|part| [part.start, part.end])),
                |found| are_even_parts(found, n, workers),
            );
        }
    }
}

/// Checks that the numbers are the starts and ends of consecutive parts of `0..n` whose lengths
/// differ by at most 1.
fn are_even_parts(found: &[f64], n: usize, workers: usize) -> Result<(), String> {
    if found.len() != 2 * workers {
        return Err(format!("the answer has {} numbers", found.len()));
    }
    let mut end = 0.0;
    for (worker, part) in found.chunks_exact(2).enumerate() {
        let (begins, ends) = (part[0], part[1]);
        if begins != end {
            return Err(format!(
                "the part of worker {worker} begins at {begins}, but must begin at {end}"
            ));
        }
        let (least, most) = (n / workers, n.div_ceil(workers));
        if ends - begins < least as f64 || ends - begins > most as f64 {
            return Err(format!(
                "the part of worker {worker} is from {begins} to {ends}. It has {} iterations, but must have {least} \
                 or {most}",
                ends - begins
            ));
        }
        end = ends;
    }
    if end == n as f64 {
        Ok(())
    } else {
        Err(format!("the last part ends at {end}, but must end at {n}"))
    }
}

/// Asks for the parts that the queue hands out, and for its answer when no parts are left.
pub(crate) fn queues(random: &mut Random, ask: &mut impl Ask) {
    for n in random.sizes(70_000) {
        for chunk in [1, 2, 7, n.max(1), n + 1, 1 + random.below(n + 1)] {
            let begin = [0, random.below(n + 1)][random.below(2)];
            let found = || {
                let next = SharedCount::default();
                next.fetch_add(begin);
                // Asks for a few parts more than there are, so that parts after the end are
                // noticed.
                let parts = (0..n.div_ceil(chunk) + 2).filter_map(|_| next_part(&next, n, chunk));
                integers(parts.flat_map(|part| [part.start, part.end]))
            };
            let question = format!(
                "{n} iterations from the queue in chunks of {chunk}. {begin} iterations are taken already, and at \
                 least two calls come after the end of the loop: start and end of each part"
            );
            ask.exact(&question, found, || {
                integers((begin..n).step_by(chunk).flat_map(|start| [start, n.min(start + chunk)]))
            });
        }
    }
}

/// Returns the number of used slots and the candidates in them; only a few slots more than
/// candidates.
fn contents(list: &Slots, used: usize, n: usize) -> Vec<f64> {
    let candidates: Vec<Candidate> = list.first(used.min(2 * n)).collect();
    [vec![used as f64], values(&candidates)].concat()
}

/// Asks for the contents of a list with a lock and of a list without, after candidates were
/// appended one by one.
pub(crate) fn appends(random: &mut Random, ask: &mut impl Ask) {
    for n in random.sizes(70_000) {
        let mut candidates = Vec::new();
        for k in 0..n as u32 {
            let hit = Hit::Pair(k, k + 1 + number(random) / 2);
            candidates.push(Candidate { time: random.between(0.0, 1.0), hit });
        }
        let right = || [vec![n as f64], values(&candidates)].concat();
        let name = format!("one worker appends {n} candidates");
        let question = format!("{name} under a lock: number of slots in use, then {EACH}");
        ask.exact(&question, || appended_locked(&candidates), right);
        let question = format!("{name} without a lock: number of slots in use, then {EACH}");
        ask.exact(&question, || appended_atomic(&candidates), right);
    }
}

fn appended_locked(candidates: &[Candidate]) -> Vec<f64> {
    let list = Slots::default();
    let count = LockedCount::default();
    candidates.iter().for_each(|candidate| append_locked(&list, &count, *candidate));
    contents(&list, count.locked(|count| *count), candidates.len())
}

fn appended_atomic(candidates: &[Candidate]) -> Vec<f64> {
    let list = Slots::default();
    let count = SharedCount::default();
    candidates.iter().for_each(|candidate| append_atomic(&list, &count, *candidate));
    contents(&list, count.load(), candidates.len())
}
