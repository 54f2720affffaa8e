// region: 7.4
// fails: task_7_4_takes_the_earliest_first
// story: Two candidates are left in the order in which they were found.
if candidates.len() != 2 {
    candidates.sort_unstable_by(order);
}
for candidate in candidates {
    take(candidate, free, taken);
}
