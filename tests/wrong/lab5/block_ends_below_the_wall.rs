// region: 5.2
// fails: task_5_2_particles_outside_the_block_are_remote
// story: The block by heights and not by rows: a particle exactly on the upper wall is outside of all blocks.
let side = grid.bin_side();
let (lower, upper) = (block.start as f64 * side, block.end as f64 * side);
changed.retain(|particle| {
    let stays = lower <= particle.y && particle.y < upper;
    if !stays {
        remote.push(*particle);
    }
    stays
});
