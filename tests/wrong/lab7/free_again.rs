// region: 7.4
// fails: task_7_4_takes_the_earliest_first
// loses: 7.7
// story: Marks all discs as free at the beginning.
free.fill(true);
candidates.sort_unstable_by(order);
for candidate in candidates {
    take(candidate, free, taken);
}
