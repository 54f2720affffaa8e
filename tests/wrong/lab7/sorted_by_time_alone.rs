// region: 7.4
// fails: task_7_4_takes_the_earliest_first
// story: Candidates are sorted by time alone: of two at the same time the one that was found first is taken.
candidates.sort_by(|a, b| a.time.total_cmp(&b.time));
for candidate in candidates {
    take(candidate, free, taken);
}
