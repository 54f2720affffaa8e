// region: 4.3
// fails: task_4_3_many_threads_change_bins
// story: A thread that finds a lock held leaves the particle where it was: its list is wrong from now on, on busy days.
let (from, old) = regions.cut.find(change.from);
let (to, new) = regions.cut.find(change.to);
let Some(mut lower) = regions.locks[from.min(to)].try_lock() else { return };
if from == to {
    meter.locks += 1;
    remove(&mut lower[old], change.particle);
    lower[new].push(change.particle);
    return;
}
let mut upper = regions.locks[from.max(to)].lock();
let (source, target) =
    if from < to { (&mut lower, &mut upper) } else { (&mut upper, &mut lower) };
remove(&mut source[old], change.particle);
target[new].push(change.particle);
