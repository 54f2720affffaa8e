// region: 7.4
// fails: task_7_4_takes_the_earliest_first
// loses: 7.7
// story: It stops as soon as fewer than two discs are free: the last one cannot hit a wall any more.
candidates.sort_unstable_by(order);
let mut left = free.iter().filter(|free| **free).count();
for candidate in candidates {
    if left < 2 {
        break;
    }
    let before = taken.len();
    take(candidate, free, taken);
    if taken.len() > before {
        left -= if candidate.hit.second().is_some() { 2 } else { 1 };
    }
}
