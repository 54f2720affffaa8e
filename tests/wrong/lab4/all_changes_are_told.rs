// region: 4.4
// fails: task_4_4_each_moves_and_tells_of_its_bin
// story: Every particle is said to change its bin, from its own into its own as well: right, at forty times the locks.
for (particle, a) in particles.iter_mut().zip(accelerations) {
    let from = grid.bin(particle);
    advance(particle, *a, grid.size());
    changed(Change { particle: particle.id, from, to: grid.bin(particle) });
}
