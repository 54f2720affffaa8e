// region: 4.9
// fails: task_4_9_owners_claim_each_particle_once
// story: Where there are no particles bins keep what they had.
if particles.is_empty() {
    return;
}
bins.iter_mut().for_each(Bin::clear);
for particle in particles {
    let (region, index) = cut.find(grid.bin(particle));
    if region == own {
        bins[index].push(particle.id);
    }
}
