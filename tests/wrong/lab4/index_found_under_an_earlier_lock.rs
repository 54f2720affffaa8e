// region: 4.3
// fails: task_4_3_another_thread_between_two_requests, task_4_3_many_threads_change_bins
// story: The particle's index in the list is looked up under the lock, which is given back and taken again: by then the list is another one.
let (from, old) = regions.cut.find(change.from);
let (to, new) = regions.cut.find(change.to);
let inside = |bin: &Bin| bin.iter().position(|p| *p == change.particle).expect("it is there");
let index = inside(&meter.lock(&regions.locks[from])[old]);
let mut lower = meter.lock(&regions.locks[from.min(to)]);
if from == to {
    lower[old].swap_remove(index);
    lower[new].push(change.particle);
    return;
}
let mut upper = meter.lock(&regions.locks[from.max(to)]);
let (source, target) =
    if from < to { (&mut lower, &mut upper) } else { (&mut upper, &mut lower) };
source[old].swap_remove(index);
target[new].push(change.particle);
