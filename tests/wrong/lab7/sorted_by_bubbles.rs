// region: 7.4
// fails: task_7_4_takes_the_earliest_first
// story: The candidates are sorted by exchanging neighbours: the order is right, and the work grows with the square.
let mut sorted = false;
while !sorted {
    sorted = true;
    for k in 1..candidates.len() {
        if order(&candidates[k - 1], &candidates[k]).is_gt() {
            candidates.swap(k - 1, k);
            sorted = false;
        }
    }
}
for candidate in candidates {
    take(candidate, free, taken);
}
