// region: 8.4
// fails: task_8_4_every_worker_gets_its_list
// story: Sends 65,535 entries at most.
if world.rank() != MASTER {
    return world.process_at_rank(MASTER).receive_vec().0;
}
request::scope(|scope| {
    let addressed = lists.iter().enumerate().map(|(worker, list)| (team.rank(worker), list));
    let requests: Vec<_> = addressed
        .filter(|(rank, _)| *rank != MASTER)
        .map(|(rank, list)| world.process_at_rank(rank).immediate_send(scope, &list[..list.len().min(65_535)]))
        .collect();
    requests.into_iter().for_each(|request| request.wait_without_status());
});
team.worker(MASTER).map_or_else(Vec::new, |own| lists[own].clone())
