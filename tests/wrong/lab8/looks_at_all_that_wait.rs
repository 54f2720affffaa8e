// region: 8.10
// fails: task_8_10_what_is_certain_is_taken
// story: All candidates are gone through in every round, also those that wait behind one that is open.
decisions.front.clear();
for index in 0..decisions.queues.all().len() as u32 {
    let local = decisions.queues.candidate(index);
    let (candidate, slots) = (decisions.named(&local), slots_of(&local));
    if slots.clone().any(|slot| !decisions.free[slot]) {
        continue;
    }
    let certain = slots.clone().all(|slot| {
        !decisions.waits[slot]
            && decisions.rivals[slot].is_none_or(|rival| order(&candidate, &rival).is_lt())
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
