//! How many time steps to run, so that a measurement takes about as long as it should.

use anyhow::Result;

use super::job::{Job, Runner};

/// The course reports ran 1,000 steps; more show nothing new.
pub const MOST: u64 = 1000;

/// The number of steps, 1 to [`MOST`], in which `job` runs for about `seconds`. Tries it out.
pub fn that_take(runner: &Runner, job: &Job, seconds: f64) -> Result<u64> {
    let mut steps = 1;
    loop {
        let took = runner.run(&Job { steps, ..job.clone() })?.seconds.max(1e-9);
        let fitting = (steps as f64 * seconds / took) as u64;
        // A try of a few milliseconds says little: the first steps find cold caches.
        if took > 0.2 * seconds || steps == MOST {
            return Ok(fitting.clamp(1, MOST));
        }
        steps = fitting.clamp(steps + 1, 8 * steps).min(MOST);
    }
}
