// region: 13.5
// fails: task_13_5_rows_share_the_load
// story: In 32 bits.
u64::from((MOVED * particles as f64 + LISTED * pairs as f64).ceil() as u32)
