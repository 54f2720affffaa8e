// region: 5.2
// fails: task_5_2_particles_outside_the_block_are_remote
// loses: 5.8
// story: The course report's slip, x <= start_bin where >= was meant: nearly every particle counts as remote and travels through the root in every step; a particle that leaves for a lower row counts as local, and is lost.
changed.retain(|particle| {
    let row = grid.row(particle.y);
    let stays = row <= block.start && row < block.end;
    if !stays {
        remote.push(*particle);
    }
    stays
});
