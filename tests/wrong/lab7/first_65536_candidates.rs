// region: 7.4
// fails: task_7_4_takes_the_earliest_first
// story: Takes at most 65,536 candidates.
candidates.sort_unstable_by(order);
for candidate in candidates.iter().take(65_536) {
    take(candidate, free, taken);
}
