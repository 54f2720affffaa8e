// region: 13.8b
// fails: task_13_8_all_ranks_go_back_or_none
// story: Each rank counts the steps that are right by its own moves, and all take the least count. But in one step a particle of one rank goes too far, and in another step one of another rank.
let own = said.to_vec();
let right = right_steps(&own[..steps], width) as u64;
let mut least = 0;
world.all_reduce_into(&right, &mut least, SystemOperation::min());
world.all_reduce_into(&own[..], said, SystemOperation::max());
least as usize
