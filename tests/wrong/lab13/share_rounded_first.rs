// region: 13.5b
// fails: task_13_5_rows_share_the_load
// story: The share is rounded before it is multiplied: a load smaller than the number of particles vanishes.
let all: u64 = counts.iter().sum();
counts.iter().map(|count| load / all.max(1) * count).collect()
