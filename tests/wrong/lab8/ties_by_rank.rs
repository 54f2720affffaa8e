// region: 8.10
// fails: task_8_10_what_is_certain_is_taken, task_8_11_ranks_together_take_what_one_would
// loses: 8.13
// story: A candidate at the same time as its rival goes first at home, whatever the numbers say: at a tie both ranks take their own.
decisions.front.clear();
for local in decisions.queues.all() {
    let candidate = decisions.named(local);
    let slots = decisions.slots(&candidate);
    if slots.clone().any(|slot| !decisions.free[slot]) {
        continue;
    }
    let certain = slots.clone().all(|slot| {
        !decisions.waits[slot] && decisions.rivals[slot].is_none_or(|rival| candidate.time <= rival.time)
    });
    if certain {
        slots.for_each(|slot| decisions.free[slot] = false);
        decisions.taken.push(candidate);
        continue;
    }
    if slots.clone().any(|slot| !decisions.waits[slot]) {
        decisions.front.push(candidate);
    }
    slots.for_each(|slot| decisions.waits[slot] = true);
}
decisions.waits.fill(false);
