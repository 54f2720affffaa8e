// region: 6.3
// fails: task_6_3_lists_reach_the_neighbours_while_work_is_done
// story: Only the first two lists travel, as if all ranks had two neighbours and no more.
let lengths: Vec<u64> = outgoing.iter().map(|(_, list)| list.len() as u64).collect();
let mut counts = vec![0_u64; outgoing.len()];
request::scope(|scope| {
    let mut requests = Vec::new();
    for (((rank, _), length), count) in outgoing.iter().take(2).zip(&lengths).zip(&mut counts) {
        let other = world.process_at_rank(*rank);
        requests.push(other.immediate_receive_into(scope, count));
        requests.push(other.immediate_send(scope, length));
    }
    requests.into_iter().for_each(|request| request.wait_without_status());
});
let mut incoming: Vec<Vec<T>> =
    counts.iter().map(|&count| vec![T::default(); count as usize]).collect();
let result = request::scope(|scope| {
    let mut requests = Vec::new();
    for ((rank, list), buffer) in outgoing.iter().take(2).zip(&mut incoming) {
        let other = world.process_at_rank(*rank);
        requests.push(other.immediate_receive_into(scope, &mut buffer[..]));
        requests.push(other.immediate_send(scope, &list[..]));
    }
    let result = work();
    requests.into_iter().for_each(|request| request.wait_without_status());
    result
});
(incoming, result)
