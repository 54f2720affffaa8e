// region: 8.4
// fails: task_8_4_every_worker_gets_its_list
// story: Sends and waits, one worker after the other.
if world.rank() != MASTER {
    return world.process_at_rank(MASTER).receive_vec().0;
}
for (worker, list) in lists.iter().enumerate() {
    if team.rank(worker) != MASTER {
        world.process_at_rank(team.rank(worker)).synchronous_send(&list[..]);
    }
}
team.worker(MASTER).map_or_else(Vec::new, |own| lists[own].clone())
