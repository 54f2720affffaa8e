// region: 8.10
// fails: task_8_10_what_is_certain_is_taken, task_8_11_ranks_together_take_what_one_would
// loses: 8.13
// story: A candidate that is not certain yet is put aside, and a later one of the same disc, which has no rival, is taken instead.
decisions.front.clear();
for local in decisions.queues.all() {
    let candidate = decisions.named(local);
    let slots = decisions.slots(&candidate);
    if slots.clone().any(|slot| !decisions.free[slot]) {
        continue;
    }
    let before = |rival: solution7::Candidate| order(&candidate, &rival).is_lt();
    if slots.clone().all(|slot| decisions.rivals[slot].is_none_or(before)) {
        slots.for_each(|slot| decisions.free[slot] = false);
        decisions.taken.push(candidate);
    } else {
        decisions.front.push(candidate);
    }
}
