// region: 8.10
// fails: task_8_10_later_candidates_wait_for_earlier_ones, task_8_11_ranks_together_take_what_one_would
// loses: 8.13
// story: A candidate that is not certain yet is put aside, and a later one of the same disc, which has no rival, is taken in its place.
self.front.clear();
for local in self.queues.all() {
    let candidate = self.named(local);
    let places = self.places(&candidate);
    if places.clone().any(|place| !self.free[place]) {
        continue;
    }
    let before = |rival: Candidate| order(&candidate, &rival).is_lt();
    if places.clone().all(|place| self.rivals[place].is_none_or(before)) {
        places.for_each(|place| self.free[place] = false);
        self.taken.push(candidate);
    } else {
        self.front.push(candidate);
    }
}
