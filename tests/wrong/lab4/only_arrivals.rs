// region: 4.6b
// fails: task_4_6_every_thread_its_own_bins, task_4_6_buffers_emptied_by_all
// loses: 4.7, 4.8
// story: The arrivals are put into the own bins, and what left them is still there.
for change in changes {
    let (region, index) = cut.find(change.to);
    if region == own {
        bins[index].push(change.particle);
    }
}
