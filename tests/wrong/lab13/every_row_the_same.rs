// region: 13.5b
// fails: task_13_5_rows_share_the_load
// story: The load is dealt out evenly to the rows that have particles, however many they have.
let rows = counts.iter().filter(|count| **count > 0).count().max(1) as u64;
counts.iter().map(|count| if *count > 0 { load / rows } else { 0 }).collect()
