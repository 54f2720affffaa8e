// region: 4.3
// fails: task_4_3_particles_change_their_bins, task_4_3_many_threads_change_bins, task_4_4_under_many_locks
// story: The lock of the old bin first, that of the new one second: two particles that change bins with each other are two threads that wait for each other for ever.
let (from, old) = regions.cut.find(change.from);
let (to, new) = regions.cut.find(change.to);
let mut source = meter.lock(&regions.locks[from]);
if from == to {
    remove(&mut source[old], change.particle);
    source[new].push(change.particle);
    return;
}
let mut target = meter.lock(&regions.locks[to]);
remove(&mut source[old], change.particle);
target[new].push(change.particle);
