// region: 13.4
// fails: task_13_4_inner_particles_move_while_positions_are_under_way
// story: Each send waits for its receive.
request::scope(|scope| {
    let mut requests = Vec::new();
    for (rank, positions) in partners.iter().zip(received) {
        let partner = world.process_at_rank(*rank);
        requests.push(partner.immediate_receive_into(scope, &mut positions[..]));
    }
    for (rank, positions) in partners.iter().zip(sent) {
        let partner = world.process_at_rank(*rank);
        partner.immediate_send(scope, &positions[..]).wait_without_status();
    }
    meanwhile();
    requests.into_iter().for_each(|request| request.wait_without_status());
});
