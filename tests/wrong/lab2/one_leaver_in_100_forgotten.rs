// region: 2.5
// fails: task_2_5_incremental_keeps_every_particle_for_1000_steps, task_2_5_incremental_steps
// story: One leaver in a hundred stays in its old bin for a step.
use std::sync::atomic::{AtomicUsize, Ordering};
static LEAVERS: AtomicUsize = AtomicUsize::new(0);
let mut i = 0;
while i < inside.len() {
    let inside_still = grid.bin(&inside[i]) == bin;
    if inside_still || LEAVERS.fetch_add(1, Ordering::Relaxed) % 100 == 99 {
        i += 1;
    } else {
        changed.push(inside.swap_remove(i));
    }
}
