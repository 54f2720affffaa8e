// region: 8.10
// fails: task_8_10_nothing_is_taken_that_others_could_prevent, task_8_11_ranks_together_take_what_one_would
// story: A candidate at the same time as its rival goes first at home, whatever the numbers say: at a tie both ranks take theirs.
let mut open = std::mem::take(&mut self.open);
open.sort_by(order);
self.front.clear();
open.retain(|candidate| {
    if self.places(candidate).any(|place| !self.free[place]) {
        return false;
    }
    let certain = self.places(candidate).all(|place| {
        !self.waits[place]
            && self.rivals[place].is_none_or(|rival| candidate.time <= rival.time)
    });
    if certain {
        self.places(candidate).for_each(|place| self.free[place] = false);
        self.taken.push(*candidate);
        return false;
    }
    if self.places(candidate).any(|place| !self.waits[place]) {
        self.front.push(*candidate);
    }
    self.places(candidate).for_each(|place| self.waits[place] = true);
    true
});
self.open = open;
self.waits.fill(false);
