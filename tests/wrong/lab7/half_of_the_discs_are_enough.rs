// region: 7.4
// fails: task_7_4_takes_the_earliest_first
// loses: 7.7
// story: As many candidates as half the discs are taken, since each takes two; but a wall takes one: two discs that each hit a wall.
candidates.sort_unstable_by(order);
for candidate in candidates {
    if taken.len() >= free.len().div_ceil(2) {
        break;
    }
    take(candidate, free, taken);
}
