// region: 2.5
// fails: task_2_5_incremental_keeps_every_particle_for_1000_steps, task_2_5_incremental_steps, task_2_5_incremental_the_official_run
// story: One leaver in a hundred falls between two bins and is gone.
use std::sync::atomic::{AtomicUsize, Ordering};
static LEAVERS: AtomicUsize = AtomicUsize::new(0);
let mut i = 0;
while i < inside.len() {
    if grid.bin(&inside[i]) == bin {
        i += 1;
        continue;
    }
    let leaver = inside.swap_remove(i);
    if LEAVERS.fetch_add(1, Ordering::Relaxed) % 100 != 99 {
        changed.push(leaver);
    }
}
