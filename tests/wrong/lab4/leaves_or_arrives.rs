// region: 4.6b
// fails: task_4_6_buffers_emptied_by_all, task_4_6_every_thread_its_own_bins
// loses: 4.7, 4.8
// story: A particle that leaves an own bin is not looked at again: if it arrives in another own bin, it is in none.
for change in changes {
    let (from, old) = cut.find(change.from);
    let (to, new) = cut.find(change.to);
    if from == own {
        remove(&mut bins[old], change.particle);
    } else if to == own {
        bins[new].push(change.particle);
    }
}
