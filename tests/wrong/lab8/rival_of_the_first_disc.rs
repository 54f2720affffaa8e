// region: 8.10
// fails: task_8_10_what_is_certain_is_taken
// loses: 8.13
// story: Only the rival of the first disc counts.
decisions.front.clear();
let free = (0..decisions.numbers.len()).filter(|&slot| decisions.free[slot]);
let firsts = free.filter_map(|slot| decisions.queues.first(slot));
let mut next: BinaryHeap<Reverse<u32>> = firsts.map(Reverse).collect();
while let Some(Reverse(index)) = next.pop() {
    let local = decisions.queues.candidate(index);
    let (candidate, slots) = (decisions.named(&local), slots_of(&local));
    if slots.clone().any(|slot| !decisions.free[slot]) {
        for slot in slots.filter(|&slot| decisions.free[slot]) {
            if decisions.queues.first(slot) == Some(index) {
                next.extend(decisions.queues.advance(slot).map(Reverse));
            }
        }
        continue;
    }
    let first = slots.clone().next();
    let certain = slots.clone().all(|slot| {
        !decisions.waits[slot]
            && decisions.rivals[slot].filter(|_| Some(slot) == first).is_none_or(|rival| order(&candidate, &rival).is_lt())
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
