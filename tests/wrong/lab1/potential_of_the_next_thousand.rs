// region: 1.5b
// fails: task_1_5_energies_of_any_number_of_particles
// story: A particle looks at the thousand behind it only.
let pairs = particles.iter().enumerate().flat_map(|(i, particle)| {
    particles[i + 1..].iter().take(1000).map(move |other| particle.to(other))
});
pairs.map(pair_potential).sum()
