// region: 4.3
// fails: task_4_3_particles_change_their_bins
// story: The old bin's lock is given back before the new one's is taken: in between the particle is in no bin.
let (from, old) = regions.cut.find(change.from);
let (to, new) = regions.cut.find(change.to);
if from == to {
    let mut region = meter.lock(&regions.locks[from]);
    remove(&mut region[old], change.particle);
    region[new].push(change.particle);
    return;
}
remove(&mut meter.lock(&regions.locks[from])[old], change.particle);
meter.lock(&regions.locks[to])[new].push(change.particle);
