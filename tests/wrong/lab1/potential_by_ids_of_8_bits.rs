// region: 1.5b
// fails: task_1_5_energies_of_any_number_of_particles
// story: Each pair is met once by comparing ids, of which only 8 bits are looked at.
particles
    .iter()
    .flat_map(|p| {
        particles
            .iter()
            .filter(|q| (q.id as u8) > (p.id as u8))
            .map(|q| pair_potential(p.to(q)))
    })
    .sum()
