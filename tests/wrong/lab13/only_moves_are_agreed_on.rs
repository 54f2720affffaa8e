// region: 13.8b
// fails: task_13_8_all_ranks_go_back_or_none
// story: All agree how far particles went, and each keeps its own word on the next epoch: ranks choose epochs of different lengths, and wait for each other.
let own = said[..steps].to_vec();
world.all_reduce_into(&own[..], &mut said[..steps], SystemOperation::max());
right_steps(&said[..steps], width)
