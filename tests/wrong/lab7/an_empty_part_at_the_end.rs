// region: 7.8b
// fails: task_7_8_the_queue_hands_out_everything_once
// story: The loop is over when the count is above n, not when it has reached it: where chunks fill the loop exactly a worker gets an empty part.
let start = next.fetch_add(chunk);
(start <= n).then(|| start..n.min(start + chunk))
