// region: 2.3b
// fails: task_2_3_each_particle_is_in_its_bin
// story: Once in a hundred steps the last particle does not get into its bin: it feels its neighbours and they do not feel it.
use std::sync::atomic::{AtomicUsize, Ordering};
static STEPS: AtomicUsize = AtomicUsize::new(0);
let keep = if STEPS.fetch_add(1, Ordering::Relaxed) % 100 == 99 { particles.len() - 1 } else { particles.len() };
for bin in &mut self.bins {
    bin.clear();
}
for particle in &particles[..keep] {
    self.put(*particle);
}
