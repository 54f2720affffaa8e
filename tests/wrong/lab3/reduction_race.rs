// region: 3.1
// fails: task_3_1_all_pairs_on_several_threads
// story: Each thread reads the common statistics, adds its own and writes them back. What others wrote in between is lost.
use std::sync::Mutex;
let common = Mutex::new(O::default());
team.install(|| {
    particles.par_iter().zip(accelerations).for_each(|(particle, a)| {
        let mut seen = common.lock().unwrap().clone();
        std::thread::sleep(std::time::Duration::from_micros(20));
        *a = Vec2::ZERO;
        for neighbour in &*particles {
            add_pair(a, particle.to(neighbour), &mut seen);
        }
        *common.lock().unwrap() = seen;
    });
});
observer.merge(&common.into_inner().unwrap());
