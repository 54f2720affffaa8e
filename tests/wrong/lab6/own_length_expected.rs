// region: 6.3
// fails: task_6_3_lists_reach_the_neighbours_while_work_is_done
// loses: 6.7
// story: Each rank expects as many items as it sends itself.
let mut incoming: Vec<Vec<T>> =
    outgoing.iter().map(|(_, list)| vec![T::default(); list.len()]).collect();
let result = request::scope(|scope| {
    let mut requests = Vec::new();
    for ((rank, list), buffer) in outgoing.iter().zip(&mut incoming) {
        let other = world.process_at_rank(*rank);
        requests.push(other.immediate_receive_into(scope, &mut buffer[..]));
        requests.push(other.immediate_send(scope, &list[..]));
    }
    let result = work();
    requests.into_iter().for_each(|request| request.wait_without_status());
    result
});
(incoming, result)
