// region: 8.10
// fails: task_8_10_later_candidates_wait_for_earlier_ones, task_8_11_ranks_together_take_what_one_would
// story: A candidate that is not certain yet is put aside, and a later one of the same disc, which has no rival, is taken in its place.
let mut open = std::mem::take(&mut self.open);
open.sort_by(order);
self.front.clear();
open.retain(|candidate| {
    if self.places(candidate).any(|place| !self.free[place]) {
        return false;
    }
    let before = |rival: Candidate| order(candidate, &rival).is_lt();
    if self.places(candidate).all(|place| self.rivals[place].is_none_or(before)) {
        self.places(candidate).for_each(|place| self.free[place] = false);
        self.taken.push(*candidate);
        return false;
    }
    self.front.push(*candidate);
    true
});
self.open = open;
