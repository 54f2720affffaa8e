// region: 1.5d
// fails: task_1_5_energies_of_any_number_of_particles
// story: Particles are taken two at a time: of an odd number the last one is forgotten.
let mut sum = Vec2::ZERO;
for pair in particles.chunks_exact(2) {
    sum += MASS * Vec2::new(pair[0].vx + pair[1].vx, pair[0].vy + pair[1].vy);
}
sum
