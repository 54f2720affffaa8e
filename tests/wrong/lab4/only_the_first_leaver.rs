// region: 4.4
// fails: task_4_4_leavers_go_into_their_bins, task_4_4_under_one_lock, task_4_4_under_many_locks
// story: A free lock is taken, and who finds a lock held gives up: the particle is lost.
let mut taken = false;
for particle in leavers {
    let (region, place) = regions.find(grid.bin(particle));
    if taken {
        continue;
    }
    taken = true;
    meter.lock(region)[place].push(*particle);
}
