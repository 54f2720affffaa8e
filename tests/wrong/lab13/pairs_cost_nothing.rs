// region: 13.5
// fails: task_13_5_rows_share_the_load
// story: Only particles are counted: where they stand close, a rank has as many as its neighbours and several times the work.
let _ = (pairs, LISTED);
(MOVED * particles as f64).ceil() as u64
