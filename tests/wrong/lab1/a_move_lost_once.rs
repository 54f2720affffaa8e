// region: 1.3
// fails: task_1_3_the_official_run, task_1_3_the_official_bytes
// story: At step 300, once, a single particle is not accelerated. After the run no statistic shows it.
use std::sync::atomic::{AtomicUsize, Ordering};
static STEPS: AtomicUsize = AtomicUsize::new(0);
let step = STEPS.fetch_add(1, Ordering::Relaxed) + 1;
let n = self.particles.len() as u64;
for (particle, a) in self.particles.iter().zip(&mut self.accelerations) {
    *a = Vec2::ZERO;
    for neighbour in &self.particles {
        add_pair(a, particle.to(neighbour), &mut self.observer);
    }
    if step == 300 && a.norm_squared() > 0.0 && n == 1000 {
        STEPS.store(1 << 40, Ordering::Relaxed);
        *a = Vec2::ZERO;
    }
}
self.observer.tested(n * n);
