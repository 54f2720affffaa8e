// region: 13.5b
// fails: task_13_5_rows_share_the_load
// story: A row with particles costs at least 1.
let all: u64 = counts.iter().sum();
let share =
    |&count: &u64| (u128::from(load) * u128::from(count) / u128::from(all.max(1))) as u64;
counts.iter().map(|count| share(count).max(u64::from(*count > 0 && load > 0))).collect()
