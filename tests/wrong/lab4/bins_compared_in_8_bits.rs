// region: 4.4
// fails: task_4_4_each_moves_and_tells_of_its_bin
// story: Bins are compared in 8 bits: in 256 columns a particle that goes up a row has stayed.
for (particle, a) in particles.iter_mut().zip(accelerations) {
    let from = grid.bin(particle);
    advance(particle, *a, grid.size());
    let to = grid.bin(particle);
    if from as u8 != to as u8 {
        changed(Change { particle: particle.id, from, to });
    }
}
