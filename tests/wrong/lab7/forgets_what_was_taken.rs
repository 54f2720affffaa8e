// region: 7.4
// fails: task_7_4_takes_the_earliest_first
// loses: 7.7
// story: What earlier windows took is forgotten.
taken.clear();
candidates.sort_unstable_by(order);
for candidate in candidates {
    take(candidate, free, taken);
}
