// region: 6.3
// fails: task_6_3_lists_reach_the_neighbours_while_work_is_done
// story: Receives are posted, and then each send blocks: no rank waits for ever, and the work waits for long lists.
let lengths: Vec<u64> = outgoing.iter().map(|(_, list)| list.len() as u64).collect();
let mut counts = vec![0_u64; outgoing.len()];
request::scope(|scope| {
    let mut requests = Vec::new();
    for ((rank, _), count) in outgoing.iter().zip(&mut counts) {
        requests.push(world.process_at_rank(*rank).immediate_receive_into(scope, count));
    }
    for ((rank, _), length) in outgoing.iter().zip(&lengths) {
        world.process_at_rank(*rank).send(length);
    }
    requests.into_iter().for_each(|request| request.wait_without_status());
});
let mut incoming: Vec<Vec<T>> =
    counts.iter().map(|&count| vec![T::default(); count as usize]).collect();
let result = request::scope(|scope| {
    let mut requests = Vec::new();
    for ((rank, _), buffer) in outgoing.iter().zip(&mut incoming) {
        let other = world.process_at_rank(*rank);
        requests.push(other.immediate_receive_into(scope, &mut buffer[..]));
    }
    for (rank, list) in outgoing {
        world.process_at_rank(*rank).send(&list[..]);
    }
    let result = work();
    requests.into_iter().for_each(|request| request.wait_without_status());
    result
});
(incoming, result)
