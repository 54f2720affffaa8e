// region: 8.4
// fails: task_8_4_every_worker_gets_its_list
// loses: 8.7
// story: List k goes to rank k: under a master that does not work every worker gets the list of the next one, and the last waits for ever.
if world.rank() != MASTER {
    return world.process_at_rank(MASTER).receive_vec().0;
}
for (rank, list) in lists.iter().enumerate().skip(1) {
    world.process_at_rank(rank as i32).send(&list[..]);
}
if team.master_works { lists[0].clone() } else { Vec::new() }
