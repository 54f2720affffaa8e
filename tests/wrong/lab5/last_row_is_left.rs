// region: 5.2
// fails: task_5_2_particles_outside_the_block_are_remote, task_5_8_particles_that_cross_several_ranks_in_a_step
// loses: 5.8
// story: The row after the last counts as part of the block: a particle that moves there is kept among the ghosts, and cleared with them.
changed.retain(|particle| {
    let row = grid.row(particle.y);
    let stays = block.start <= row && row <= block.end;
    if !stays {
        remote.push(*particle);
    }
    stays
});
