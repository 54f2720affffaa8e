// region: 13.4
// fails: task_13_4_inner_particles_move_while_positions_are_under_way
// story: Every rank sends first and receives afterwards, with operations that block: with many ghosts all ranks wait for each other.
for (rank, positions) in partners.iter().zip(sent) {
    world.process_at_rank(*rank).send(&positions[..]);
}
meanwhile();
for (rank, positions) in partners.iter().zip(received) {
    world.process_at_rank(*rank).receive_into(&mut positions[..]);
}
