// region: 4.4
// fails: task_4_4_each_moves_and_tells_of_its_bin, task_4_4_under_one_lock
// story: The old bin is looked up after the move, so that no particle ever changes its bin.
for (particle, a) in particles.iter_mut().zip(accelerations) {
    advance(particle, *a, grid.size());
    let from = grid.bin(particle);
    let to = grid.bin(particle);
    if from != to {
        changed(Change { particle: particle.id, from, to });
    }
}
