// region: 13.5b
// fails: task_13_5_rows_share_the_load
// story: Shares in floating point.
let all: u64 = counts.iter().sum();
counts.iter().map(|&count| (load as f64 * count as f64 / all.max(1) as f64) as u64).collect()
