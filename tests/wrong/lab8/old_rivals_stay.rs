// region: 8.11b
// fails: task_8_11_partners_hear_what_concerns_them, task_8_11_ranks_together_take_what_one_would
// loses: 8.13
// story: What was heard is never forgotten. A rival that has long been dropped still stands in the way, and the ranks wait for each other for ever.
for wire in news {
    let candidate = Candidate::from(wire);
    for slot in decisions.slots(&candidate) {
        if wire.is_taken() {
            decisions.free[slot] = false;
        } else if decisions.rivals[slot].is_none_or(|old| order(&candidate, &old).is_lt()) {
            decisions.rivals[slot] = Some(candidate);
        }
    }
}
