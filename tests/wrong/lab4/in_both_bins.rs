// region: 4.3
// fails: task_4_3_particles_change_their_bins, task_4_4_under_one_lock
// story: The particle is put into the new bin and not taken out of the old one: there are two now.
let (from, _) = regions.cut.find(change.from);
let (to, new) = regions.cut.find(change.to);
if from == to {
    meter.lock(&regions.locks[from])[new].push(change.particle);
    return;
}
let mut lower = meter.lock(&regions.locks[from.min(to)]);
let mut upper = meter.lock(&regions.locks[from.max(to)]);
let target = if from < to { &mut upper } else { &mut lower };
target[new].push(change.particle);
