// region: 8.10
// fails: task_8_10_nothing_is_taken_that_another_rank_could_prevent, task_8_11_ranks_together_take_what_one_would
// loses: 8.13
// story: A candidate at the same time as its rival goes first at home, whatever the numbers say: at a tie both ranks take their own.
self.front.clear();
for local in self.queues.all() {
    let candidate = self.named(local);
    let slots = self.slots(&candidate);
    if slots.clone().any(|slot| !self.free[slot]) {
        continue;
    }
    let certain = slots.clone().all(|slot| {
        !self.waits[slot] && self.rivals[slot].is_none_or(|rival| candidate.time <= rival.time)
    });
    if certain {
        slots.for_each(|slot| self.free[slot] = false);
        self.taken.push(candidate);
        continue;
    }
    if slots.clone().any(|slot| !self.waits[slot]) {
        self.front.push(candidate);
    }
    slots.for_each(|slot| self.waits[slot] = true);
}
self.waits.fill(false);
