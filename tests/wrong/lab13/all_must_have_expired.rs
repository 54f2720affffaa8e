// region: 13.6
// fails: task_13_6_one_rank_decides_for_all
// story: Lists are rebuilt when those of all ranks have expired: the rank with the fastest particles goes on with a list that lacks pairs.
let expired = list_has_expired || 2.0 * moved > width - CUTOFF;
let mut all = 0;
world.all_reduce_into(&i32::from(expired), &mut all, SystemOperation::min());
all > 0
