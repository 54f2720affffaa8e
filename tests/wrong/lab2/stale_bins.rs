// region: 2.3b
// fails: task_2_3_each_particle_is_in_its_bin
// story: The bins are filled again in every second step only: in between, neighbours push from where they were.
use std::sync::atomic::{AtomicUsize, Ordering};
static STEPS: AtomicUsize = AtomicUsize::new(0);
if STEPS.fetch_add(1, Ordering::Relaxed) % 2 == 0 || self.bins.iter().all(Vec::is_empty) {
    for bin in &mut self.bins {
        bin.clear();
    }
    for particle in particles {
        self.put(*particle);
    }
}
