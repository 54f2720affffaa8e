// region: 8.5
// fails: task_8_5_the_master_gets_all_lists_in_the_order_of_workers
// story: The master takes what arrives first. The collisions come out the same, but the list is another in every run; and of two messages of one fast worker both may be taken for the same step.
if world.rank() != MASTER {
    world.process_at_rank(MASTER).send(own);
    return Vec::new();
}
let mut all = if team.master_works { own.to_vec() } else { Vec::new() };
for _ in usize::from(team.master_works)..team.workers {
    all.extend(world.any_process().receive_vec::<T>().0);
}
all
