//! Questions about the order of two candidates, and about the candidates that happen: tasks 7.3 and
//! 7.4.

use std::cell::LazyCell;

use hard_discs::{Candidate, Hit};
use lab7::{order, take, take_in_order};
use oracle::{Ask, Random, flags, truth, within};

use super::words::{EACH, event, number, values};

/// Asks for the order of every two of some candidates. Their times coincide often, they are of all
/// kinds, and their disc numbers are at the ends of bit ranges.
pub(crate) fn orders(random: &mut Random, ask: &mut impl Ask) {
    for _ in 0..40 {
        let time = random.magnitude(1e-300, 1.0);
        let times = [0.0, -0.0, time, time.next_up(), time.next_down(), 1.0];
        let mut draw = || {
            let (a, b) = (number(random), number(random));
            let pair = Hit::Pair(a.min(b), a.max(b));
            let hit = [Hit::Corner(a), Hit::WallX(a), Hit::WallY(a), pair, pair][random.below(5)];
            Candidate { time: times[random.below(6)], hit }
        };
        let all: Vec<Candidate> = (0..24).map(|_| draw()).collect();
        for (a, b) in all.iter().flat_map(|a| all.iter().map(move |b| (a, b))) {
            let question = format!(
                "first candidate: {}. Second candidate: {}. Answer: -1 if the first is taken before the second, 1 if \
                 after the second, 0 if the two are the same",
                event(a),
                event(b)
            );
            ask.exact(&question, || vec![f64::from(order(a, b) as i8)], || vec![comes(a, b)]);
        }
    }
}

/// Returns −1 if the first candidate is taken before the second, 1 if after it, 0 if they are the
/// same.
fn comes(a: &Candidate, b: &Candidate) -> f64 {
    if a.time < b.time || a.time == b.time && a.hit < b.hit {
        return -1.0;
    }
    truth(a.time != b.time || a.hit != b.hit)
}

/// Free discs, and the candidates that were taken.
#[derive(Clone)]
struct Taken {
    free: Vec<bool>,
    taken: Vec<Candidate>,
}

impl Taken {
    /// Draws which of `discs` discs are free. One candidate has been taken already.
    fn drawn(random: &mut Random, discs: usize) -> Self {
        let free = (0..discs).map(|_| random.below(8) > 0).collect();
        Self { free, taken: vec![Candidate { time: 0.5, hit: Hit::WallY(1) }] }
    }

    /// Takes a candidate if its discs are free, as the rule demands.
    fn take(&mut self, candidate: &Candidate) {
        let discs = [Some(candidate.hit.first()), candidate.hit.second()].into_iter().flatten();
        if discs.clone().all(|disc| self.free[disc as usize]) {
            discs.for_each(|disc| self.free[disc as usize] = false);
            self.taken.push(*candidate);
        }
    }
}

/// Asks which candidates are taken, and which discs are free afterwards.
fn ask_both(
    ask: &mut impl Ask,
    case: &str,
    found: impl FnOnce() -> Taken,
    right: impl FnOnce() -> Taken,
) {
    let (found, right) = (LazyCell::new(found), LazyCell::new(right));
    let question = format!("{case}: {EACH} taken afterwards, in their order");
    ask.exact(&question, || values(&found.taken), || values(&right.taken));
    let question = format!(
        "{case}: for each disc, from disc 0 on, 1 if it is still free afterwards, 0 if not"
    );
    ask.exact(&question, || flags(&found.free), || flags(&right.free));
}

/// Asks whether a candidate of any kind is taken when some discs are no longer free.
pub(crate) fn single_takes(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..6000 {
        let discs = 2 + random.size(40.min(case / 20));
        let before = Taken::drawn(random, discs);
        let [a, b] = [(); 2].map(|()| random.below(discs) as u32);
        let pair = if a == b { Hit::WallY(a) } else { Hit::Pair(a.min(b), a.max(b)) };
        let hit = [pair, pair, Hit::Corner(a), Hit::WallX(a)][random.below(4)];
        let candidate = Candidate { time: random.between(0.0, 1.0), hit };
        let gone: Vec<usize> = (0..discs).filter(|&disc| !before.free[disc]).collect();
        let case = format!(
            "{}. There are {discs} discs, of which {gone:?} are not free, and one candidate is taken already",
            event(&candidate)
        );
        let found = || {
            let mut after = before.clone();
            take(&candidate, &mut after.free, &mut after.taken);
            after
        };
        ask_both(ask, &case, found, || {
            let mut after = before.clone();
            after.take(&candidate);
            after
        });
    }
}

/// Draws candidates in the order in which they must be taken. Of two candidates, the earlier has
/// the lower number, and walls have the lowest numbers. Some candidates have the time of their
/// predecessor.
fn in_order(random: &mut Random, n: usize, discs: usize) -> Vec<Candidate> {
    let mut hits = Vec::new();
    for _ in 0..n {
        let [a, b] = [(); 2].map(|()| random.below(discs) as u32);
        let is_wall = a == b || a < discs as u32 / 9;
        hits.push(if is_wall { Hit::WallX(a) } else { Hit::Pair(a.min(b), a.max(b)) });
    }
    hits.sort_unstable();
    hits.dedup();
    let gap = 0.9 / (hits.len() + 1) as f64;
    let mut time = 0.0;
    let mut candidates = Vec::new();
    for (k, hit) in hits.into_iter().enumerate() {
        if random.below(4) > 0 {
            time = (k as f64 + random.between(0.1, 0.9)) * gap;
        }
        candidates.push(Candidate { time, hit });
    }
    candidates
}

/// Asks which of few and many candidates in any order are taken, after a candidate of an earlier
/// window.
pub(crate) fn takes(random: &mut Random, ask: &mut impl Ask) {
    let sizes = [vec![2; 10], random.sizes(4097), random.sizes(4097), vec![70_000]].concat();
    for n in sizes {
        let discs = [n + 2, 20 * n + 2][random.below(2)];
        let before = Taken::drawn(random, discs);
        let sorted = in_order(random, n, discs);
        let mut given = sorted.clone();
        random.shuffle(&mut given);
        let case = format!(
            "{} candidates of {discs} discs, and one more candidate that is taken already",
            given.len()
        );
        let found = || {
            let mut after = before.clone();
            take_in_order(&mut given, &mut after.free, &mut after.taken);
            after
        };
        ask_both(ask, &case, found, || {
            let mut after = before.clone();
            sorted.iter().for_each(|candidate| after.take(candidate));
            after
        });
    }
}

/// Returns the wall collision of a disc. Lower numbers hit earlier.
fn wall(disc: usize) -> Candidate {
    Candidate { time: disc as f64 / 4.0, hit: Hit::WallX(disc as u32) }
}

/// Asks about a few discs that each hit a wall, so that no candidate excludes another.
pub(crate) fn takes_of_walls(_: &mut Random, ask: &mut impl Ask) {
    for discs in 1..=3 {
        let found = || {
            let mut walls: Vec<Candidate> = (0..discs).rev().map(wall).collect();
            let mut taken = Vec::new();
            take_in_order(&mut walls, &mut vec![true; discs], &mut taken);
            values(&taken)
        };
        let question = format!("{discs} free discs that each hit a wall: {EACH} taken");
        ask.exact(&question, found, || values(&(0..discs).map(wall).collect::<Vec<_>>()));
    }
}

/// The number of discs in the question about many candidates. Each disc has one candidate.
const MANY: usize = 1_000_000;

/// Asks about a million candidates that do not exclude each other. A program that compares every
/// two candidates does not finish.
pub(crate) fn many_takes(random: &mut Random, ask: &mut impl Ask) {
    let times: Vec<f64> = (0..MANY).map(|_| random.between(0.0, 1.0)).collect();
    let question = "a million candidates of a million discs: (1) number of candidates taken, (2) 1 if they are in the \
                    order of time, 0 if not";
    let found = || within("7.4", 60, move || taken_of_many(&times));
    ask.exact(question, found, || vec![MANY as f64, 1.0]);
}

fn taken_of_many(times: &[f64]) -> Vec<f64> {
    let numbered = (0..).zip(times);
    let mut candidates: Vec<Candidate> =
        numbered.map(|(a, &time)| Candidate { time, hit: Hit::WallX(a) }).collect();
    let mut taken = Vec::new();
    take_in_order(&mut candidates, &mut vec![true; times.len()], &mut taken);
    let is_sorted = taken.is_sorted_by_key(|candidate| candidate.time);
    vec![taken.len() as f64, truth(is_sorted)]
}
