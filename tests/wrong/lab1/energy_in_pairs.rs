// region: 1.5c
// fails: task_1_5_energies_of_any_number_of_particles
// story: Particles are taken two at a time: of an odd number the last one is forgotten.
particles.chunks_exact(2).flatten().map(|p| MASS * (p.vx * p.vx + p.vy * p.vy) / 2.0).sum()
