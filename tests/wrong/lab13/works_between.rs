// region: 13.4
// fails: task_13_4_inner_particles_move_while_positions_are_under_way
// story: The work is done between receives and sends.
request::scope(|scope| {
    let mut requests = Vec::new();
    for (rank, positions) in partners.iter().zip(received) {
        let partner = world.process_at_rank(*rank);
        requests.push(partner.immediate_receive_into(scope, &mut positions[..]));
    }
    meanwhile();
    for (rank, positions) in partners.iter().zip(sent) {
        let partner = world.process_at_rank(*rank);
        requests.push(partner.immediate_send(scope, &positions[..]));
    }
    requests.into_iter().for_each(|request| request.wait_without_status());
});
