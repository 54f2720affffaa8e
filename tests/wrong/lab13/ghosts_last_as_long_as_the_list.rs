// region: 13.6
// fails: task_13_6_one_rank_decides_for_all, task_13_6_particles_that_become_fast
// story: Only the lists of own particles are asked. They have their own way with particles that become fast, ghosts have not.
let expired = list_has_expired || width < CUTOFF || moved.is_infinite();
let mut any = 0;
world.all_reduce_into(&i32::from(expired), &mut any, SystemOperation::max());
any > 0
