// region: 4.6b
// fails: task_4_6_every_thread_its_own_bins
// story: Regions are compared in 8 bits: region 256 is taken for region 0.
for change in changes {
    let (region, index) = cut.find(change.from);
    if region as u8 == own as u8 {
        remove(&mut bins[index], change.particle);
    }
    let (region, index) = cut.find(change.to);
    if region as u8 == own as u8 {
        bins[index].push(change.particle);
    }
}
