//! Checks whether a rank has taken the certain candidates. Each candidate is checked separately,
//! given all candidates that were taken.

use hard_disc_ranks::UNKNOWN;
use solution7::{Candidate, order};

use super::candidates::{Found, NUMBERS, of_value, sorted, words};

/// A rank's candidates after a round.
pub(crate) struct After {
    pub(crate) taken: Vec<Candidate>,
    front: Vec<Candidate>,
    pub(crate) free: Vec<bool>,
    waits: Vec<bool>,
}

impl After {
    /// Reads the state from the next numbers. Returns `None` if there are too few numbers.
    pub(crate) fn read(numbers: &mut &[f64], discs: usize) -> Option<Self> {
        let taken = *numbers.first()? as usize;
        let front = *numbers.get(1)? as usize;
        let candidates = NUMBERS.checked_mul(taken.checked_add(front)?)?;
        let length = candidates.checked_add(2 + 2 * discs)?;
        let (own, rest) = numbers.split_at_checked(length)?;
        *numbers = rest;
        let (candidates, flags) = own[2..].split_at(candidates);
        let mut candidates: Vec<Candidate> = candidates.chunks(NUMBERS).map(of_value).collect();
        let is = |flag: &f64| *flag != 0.0;
        Some(Self {
            front: candidates.split_off(taken),
            taken: candidates,
            free: flags[..discs].iter().map(is).collect(),
            waits: flags[discs..].iter().map(is).collect(),
        })
    }
}

/// The candidates of a rank, in their order.
pub(crate) struct Ordered<'a> {
    numbers: &'a [u32],
    all: Vec<Candidate>,
    /// Slots of each candidate's discs.
    slots: Vec<Vec<usize>>,
    /// For each candidate, the indices of the earlier candidates that share a disc with it.
    earlier: Vec<Vec<usize>>,
}

impl<'a> Ordered<'a> {
    pub(crate) fn of(found: &'a Found) -> Self {
        let all = sorted(found.candidates.clone());
        let slots: Vec<Vec<usize>> = all.iter().map(|c| found.slots(c)).collect();
        let earlier = (0..all.len()).map(|k| sharing(&slots, k)).collect();
        Self { numbers: &found.numbers, all, slots, earlier }
    }
}

/// Returns the candidates before number `k` that share a slot with it.
fn sharing(slots: &[Vec<usize>], k: usize) -> Vec<usize> {
    (0..k).filter(|&e| slots[e].iter().any(|slot| slots[k].contains(slot))).collect()
}

/// A rank's knowledge at the beginning of a round.
pub(crate) struct Known<'a> {
    pub(crate) ordered: &'a Ordered<'a>,
    pub(crate) rivals: &'a [Option<Candidate>],
    pub(crate) free: &'a [bool],
}

/// Outcomes of the candidates, by their indices.
struct Fates {
    /// Whether the candidate was taken in this round.
    taken: Vec<bool>,
    /// Whether the candidate was taken or is open: none of its discs had collided by its time.
    possible: Vec<bool>,
}

impl Known<'_> {
    /// Checks the candidates that a round left. `before` contains the candidates taken in earlier
    /// rounds.
    pub(crate) fn judge(&self, before: &[Candidate], after: &After) -> Result<(), String> {
        let all = &self.ordered.all;
        let fates = self.fates(before, after);
        for (k, candidate) in all.iter().enumerate() {
            let name = words(candidate);
            match (fates.taken[k], self.obstacle(k, &fates)) {
                (true, Some(words)) => return Err(format!("{name} is taken, but {words}")),
                (false, None) => return Err(format!("{name} is certain, but is not taken")),
                _ => {}
            }
        }
        let new = all.iter().zip(&fates.taken).filter(|(_, taken)| **taken);
        let expected = before.iter().copied().chain(new.map(|(c, _)| *c)).collect();
        same("taken candidates", &after.taken, expected)?;
        same("front", &after.front, self.front(&fates))?;
        self.judge_discs(&fates, after)
    }

    /// Returns the outcomes of the candidates, provided that the reported candidates were taken.
    fn fates(&self, before: &[Candidate], after: &After) -> Fates {
        let Ordered { all, slots, earlier, .. } = self.ordered;
        let new = all.iter().map(|c| after.taken.contains(c) && !before.contains(c));
        let taken: Vec<bool> = new.collect();
        let is_possible = |k: usize| {
            slots[k].iter().all(|&slot| self.free[slot]) && !earlier[k].iter().any(|&e| taken[e])
        };
        let possible = (0..all.len()).map(is_possible).collect();
        Fates { taken, possible }
    }

    /// Explains in words why a candidate is not certain. Returns `None` if the candidate is
    /// certain.
    fn obstacle(&self, k: usize, fates: &Fates) -> Option<String> {
        if !fates.possible[k] {
            return Some("one of its discs has collided".into());
        }
        let all = &self.ordered.all;
        match self.open_before(k, fates).next() {
            Some(open) => Some(format!("{} comes before it, and is open", words(&all[open]))),
            None => self.rival(k),
        }
    }

    /// Describes the rival that precedes a candidate. Returns `None` if no rival does.
    fn rival(&self, k: usize) -> Option<String> {
        let Ordered { numbers, all, slots, .. } = self.ordered;
        let is_before = |rival: Candidate| !order(&all[k], &rival).is_lt();
        let slot = *slots[k].iter().find(|slot| self.rivals[**slot].is_some_and(is_before))?;
        let rival = self.rivals[slot]?;
        Some(match rival == UNKNOWN {
            true => format!(
                "other ranks have not yet reported their candidates for disc {}",
                numbers[slot]
            ),
            false => format!("the rival {} of disc {} comes first", words(&rival), numbers[slot]),
        })
    }

    /// Returns the open candidates that precede candidate `k` and share a disc with it.
    fn open_before(&self, k: usize, fates: &Fates) -> impl Iterator<Item = usize> {
        let earlier = self.ordered.earlier[k].iter().copied();
        earlier.filter(|&e| fates.possible[e] && !fates.taken[e])
    }

    /// Returns the open candidates that are the earliest of a disc.
    fn front(&self, fates: &Fates) -> Vec<Candidate> {
        let Ordered { all, slots, .. } = self.ordered;
        let is_first = |k: &usize| {
            let waiting: Vec<usize> =
                self.open_before(*k, fates).flat_map(|e| slots[e].iter().copied()).collect();
            slots[*k].iter().any(|slot| !waiting.contains(slot))
        };
        let open = (0..all.len()).filter(|&k| fates.possible[k] && !fates.taken[k]);
        open.filter(is_first).map(|k| all[k]).collect()
    }

    fn judge_discs(&self, fates: &Fates, after: &After) -> Result<(), String> {
        let Ordered { numbers, slots, .. } = self.ordered;
        let mut is_free = self.free.to_vec();
        let taken = slots.iter().zip(&fates.taken).filter(|(_, taken)| **taken);
        taken.flat_map(|(slots, _)| slots).for_each(|&slot| is_free[slot] = false);
        for (slot, number) in numbers.iter().enumerate() {
            if after.free[slot] != is_free[slot] {
                let not = if is_free[slot] { "" } else { "not " };
                return Err(format!("disc {number} must {not}be free"));
            }
            if after.waits[slot] {
                return Err(format!("disc {number} still waits at the end of the round"));
            }
        }
        Ok(())
    }
}

/// Compares two lists of candidates in any order.
fn same(what: &str, found: &[Candidate], right: Vec<Candidate>) -> Result<(), String> {
    let found = sorted(found.to_vec());
    let right = sorted(right);
    if found == right {
        return Ok(());
    }
    if let Some(missing) = right.iter().find(|candidate| !found.contains(candidate)) {
        return Err(format!("{what}: {} is missing", words(missing)));
    }
    Err(match found.iter().find(|candidate| !right.contains(candidate)) {
        Some(extra) => format!("{what}: {} must not be in the list", words(extra)),
        None => format!("{what}: the list contains a candidate more than once"),
    })
}
