// region: 4.4
// fails: task_4_4_leavers_go_into_their_bins, task_4_4_under_many_locks, task_4_4_under_one_lock
// story: A thread keeps the lock of the last particle's region until it has the next one. Another does the same the other way round, and both wait for ever.
let mut held = None;
for particle in leavers {
    let (region, place) = regions.find(grid.bin(particle));
    let mut guard = meter.lock(region);
    guard[place].push(*particle);
    held.replace(guard);
}
