//! Questions about one list for all workers: task 7.10.

use hard_discs::{Candidate, Hit, LockedCount, SharedCount, Slots};
use lab7::{append_atomic, append_locked};
use oracle::{Ask, Random};

use super::words::{EACH, number, values};

/// How many slots are used, and the candidates in them; not many more than there are candidates.
fn contents(list: &Slots, used: usize, n: usize) -> Vec<f64> {
    let candidates: Vec<Candidate> = list.first(used.min(2 * n)).collect();
    [vec![used as f64], values(&candidates)].concat()
}

/// As many candidates as there are, one after the other, into a list behind a lock and into one without.
pub(crate) fn appends(random: &mut Random, ask: &mut impl Ask) {
    for n in random.sizes(70_000) {
        let mut candidates = Vec::new();
        for k in 0..n as u32 {
            let hit = Hit::Pair(k, k + 1 + number(random) / 2);
            candidates.push(Candidate { time: random.between(0.0, 1.0), hit });
        }
        let right = || [vec![n as f64], values(&candidates)].concat();
        let name = format!("one worker appends {n} candidates");
        let question = format!("{name} under a lock: how many slots are used; {EACH}");
        ask.exact(&question, || appended_locked(&candidates), right);
        let question = format!("{name} without a lock: how many slots are used; {EACH}");
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
