// region: 1.5b
// fails: task_1_5_energies_of_any_number_of_particles
// story: Every ordered pair holds the whole energy, so that each counts twice.
particles
    .iter()
    .flat_map(|p| particles.iter().filter(|q| q.id != p.id).map(|q| pair_potential(p.to(q))))
    .sum()
