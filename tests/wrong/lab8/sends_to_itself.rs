// region: 8.4
// fails: task_8_4_every_worker_gets_its_list
// loses: 8.7
// story: A master that works sends its own list to itself as well, and receives it then. A short list is copied aside by the library; a long one waits for the receive that comes after it.
if world.rank() != MASTER {
    return world.process_at_rank(MASTER).receive_vec().0;
}
for (worker, list) in lists.iter().enumerate() {
    world.process_at_rank(team.rank(worker)).send(&list[..]);
}
if team.master_works { world.process_at_rank(MASTER).receive_vec().0 } else { Vec::new() }
