// region: 7.3
// fails: task_7_3_the_order_of_candidates
// story: total_cmp puts −0.0 before 0.0, and a wall that is hit at once, at −0.0, comes before or after a pair by the sign of a velocity.
a.time.total_cmp(&b.time).then(a.hit.cmp(&b.hit))
