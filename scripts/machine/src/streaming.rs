//! The streaming bound: a program that reads and writes all particles cannot be faster.

use std::hint::black_box;
use std::sync::Barrier;
use std::thread;
use std::time::{Duration, Instant};

/// Time step of the sweep. Its value does not matter.
const DT: f64 = 0.0005;

/// Least time of one timing (a take). The clock and the start of threads would distort a shorter
/// take.
const LEAST: Duration = Duration::from_millis(10);

/// The particles of one thread, as four arrays.
struct Share {
    x: Vec<f64>,
    y: Vec<f64>,
    vx: Vec<f64>,
    vy: Vec<f64>,
}

impl Share {
    fn new(n: usize) -> Self {
        Self { x: line(n, 1e-3), y: line(n, 2e-3), vx: line(n, 3e-3), vy: line(n, 5e-3) }
    }

    /// Reads and writes every number once.
    ///
    /// It moves the particles and reverses their velocities, so that the numbers stay the same
    /// after any number of sweeps.
    fn sweep(&mut self) {
        let velocities = self.vx.iter_mut().zip(&mut self.vy);
        for ((x, y), (vx, vy)) in self.x.iter_mut().zip(&mut self.y).zip(velocities) {
            *x += *vx * DT;
            *y += *vy * DT;
            *vx = -*vx;
            *vy = -*vy;
        }
    }

    fn sweeps(&mut self, count: u32) {
        for _ in 0..count {
            // The compiler must assume that the arrays are read after each sweep.
            black_box(&mut *self).sweep();
        }
    }
}

/// Returns the `n` numbers 0, `step`, 2 `step`, …
fn line(n: usize, step: f64) -> Vec<f64> {
    (0..n).map(|i| i as f64 * step).collect()
}

/// Times once how long reading and writing x, y, vx and vy in place takes, in nanoseconds per
/// particle.
///
/// All threads together have `n` particles.
///
/// Each of the `threads` threads has an equal share of the particles.
pub fn nanoseconds(n: usize, threads: usize) -> f64 {
    let mut shares: Vec<_> =
        (0..threads).map(|t| Share::new(n * (t + 1) / threads - n * t / threads)).collect();
    let mut count = 1;
    loop {
        let took = together(&mut shares, count);
        if took >= LEAST {
            return took.as_secs_f64() * 1e9 / (f64::from(count) * n as f64);
        }
        let missing = LEAST.as_secs_f64() / took.as_secs_f64().max(1e-6);
        count = (f64::from(count) * missing * 1.2).ceil() as u32;
    }
}

/// Measures the time until all threads have swept their shares `count` times, after all of them are
/// ready.
fn together(shares: &mut [Share], count: u32) -> Duration {
    let ready = Barrier::new(shares.len());
    let times: Vec<_> = thread::scope(|scope| {
        let mut handles = Vec::new();
        for share in shares {
            handles.push(scope.spawn(|| {
                ready.wait();
                let start = Instant::now();
                share.sweeps(count);
                (start, Instant::now())
            }));
        }
        handles.into_iter().map(|h| h.join().expect("a sweep does not panic")).collect()
    });
    let first = times.iter().map(|take| take.0).min();
    let last = times.iter().map(|take| take.1).max();
    first.zip(last).map_or(Duration::ZERO, |(first, last)| last - first)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sweep_touches_every_number() {
        let mut share = Share::new(5);
        let before = Share::new(5);
        share.sweep();
        for i in 1..5 {
            assert_eq!(share.x[i], before.x[i] + before.vx[i] * DT);
            assert_eq!(share.y[i], before.y[i] + before.vy[i] * DT);
            assert_eq!((share.vx[i], share.vy[i]), (-before.vx[i], -before.vy[i]));
        }
    }

    #[test]
    fn more_threads_than_particles_are_no_problem() {
        assert!(nanoseconds(2, 4).is_finite());
    }
}
