// region: 4.3
// fails: task_4_3_particles_change_their_bins, task_4_4_under_one_lock
// story: Both bins lie in one region, and its lock is taken twice: the thread waits for itself.
let (from, old) = regions.cut.find(change.from);
let (to, new) = regions.cut.find(change.to);
let mut lower = meter.lock(&regions.locks[from.min(to)]);
let mut upper = meter.lock(&regions.locks[from.max(to)]);
let (source, target) =
    if from < to { (&mut lower, &mut upper) } else { (&mut upper, &mut lower) };
remove(&mut source[old], change.particle);
target[new].push(change.particle);
