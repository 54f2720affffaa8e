// region: 8.10
// fails: task_8_10_nothing_is_taken_that_others_could_prevent, task_8_11_ranks_together_take_what_one_would
// loses: 8.13
// story: A candidate at the same time as its rival goes first at home, whatever the numbers say: at a tie both ranks take theirs.
self.front.clear();
for local in self.queues.all() {
    let candidate = self.named(local);
    let places = self.places(&candidate);
    if places.clone().any(|place| !self.free[place]) {
        continue;
    }
    let certain = places.clone().all(|place| {
        !self.waits[place] && self.rivals[place].is_none_or(|rival| candidate.time <= rival.time)
    });
    if certain {
        places.for_each(|place| self.free[place] = false);
        self.taken.push(candidate);
        continue;
    }
    if places.clone().any(|place| !self.waits[place]) {
        self.front.push(candidate);
    }
    places.for_each(|place| self.waits[place] = true);
}
self.waits.fill(false);
