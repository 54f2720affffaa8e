// region: 4.9
// fails: task_4_9_owners_claim_each_particle_once, task_4_9_owners_of_shared_bins
// story: The own bins are not emptied before they are filled.
for particle in particles {
    let (region, index) = cut.find(grid.bin(particle));
    if region == own {
        bins[index].push(particle.id);
    }
}
