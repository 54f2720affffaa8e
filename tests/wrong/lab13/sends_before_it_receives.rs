// region: 13.4
// fails: task_13_4_long_lists_do_not_wait_for_each_other
// story: Every rank sends first and receives afterwards, with operations that block: with many ghosts all ranks wait for each other.
for (rank, positions) in partners.iter().zip(sent) {
    world.process_at_rank(*rank).send(&positions[..]);
}
meanwhile();
for (rank, positions) in partners.iter().zip(received) {
    world.process_at_rank(*rank).receive_into(&mut positions[..]);
}
