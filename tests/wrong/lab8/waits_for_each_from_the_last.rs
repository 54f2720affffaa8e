// region: 8.4
// fails: task_8_4_every_worker_gets_its_list
// story: The last worker's list goes first, and each send is waited for before the next begins.
if world.rank() != MASTER {
    return world.process_at_rank(MASTER).receive_vec().0;
}
for (worker, list) in lists.iter().enumerate().rev() {
    if team.rank(worker) != MASTER {
        request::scope(|scope| {
            let to = world.process_at_rank(team.rank(worker));
            to.immediate_send(scope, &list[..]).wait_without_status();
        });
    }
}
team.worker(MASTER).map_or_else(Vec::new, |own| lists[own].clone())
