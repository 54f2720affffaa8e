// region: 13.4
// fails: task_13_4_inner_particles_move_while_positions_are_under_way
// story: Only two partners are served, as if they were the neighbours below and above. A rank of a narrow strip has more.
request::scope(|scope| {
    let mut requests = Vec::new();
    for (rank, positions) in partners.iter().zip(received).take(2) {
        let partner = world.process_at_rank(*rank);
        requests.push(partner.immediate_receive_into(scope, &mut positions[..]));
    }
    for (rank, positions) in partners.iter().zip(sent).take(2) {
        let partner = world.process_at_rank(*rank);
        requests.push(partner.immediate_send(scope, &positions[..]));
    }
    meanwhile();
    requests.into_iter().for_each(|request| request.wait_without_status());
});
