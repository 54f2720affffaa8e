//! How fast the machine can stream particles: no program that touches all of them can be faster.

use std::hint::black_box;
use std::sync::Barrier;
use std::thread;
use std::time::{Duration, Instant};

use common::soft::DT;

/// The least time of a take: else the clock and the threads' start would show.
const LEAST: Duration = Duration::from_millis(10);

/// The particles of one thread as four arrays.
struct Share {
    x: Vec<f64>,
    y: Vec<f64>,
    vx: Vec<f64>,
    vy: Vec<f64>,
}

impl Share {
    fn new(n: usize) -> Self {
        let line = |step: f64| (0..n).map(|i| i as f64 * step).collect();
        Self { x: line(1e-3), y: line(2e-3), vx: line(3e-3), vy: line(5e-3) }
    }

    /// Reads and writes every number once: moves, and turns the velocity round so that the
    /// numbers stay where they are however long this goes on.
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
            // The compiler must believe that the arrays are read after each sweep.
            black_box(&mut *self).sweep();
        }
    }
}

/// Nanoseconds that `work` takes for each of `count` things: the median of nine takes.
pub fn nanoseconds_each(count: usize, mut work: impl FnMut()) -> f64 {
    let time = |_| {
        let start = Instant::now();
        work();
        start.elapsed()
    };
    let mut times: Vec<_> = (0..9).map(time).collect();
    times.sort_unstable();
    times[4].as_nanos() as f64 / count as f64
}

/// Nanoseconds per particle to read and write x, y, vx and vy of `n` particles in place, with
/// `threads` threads that each have their own share: one take.
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

/// The time until all threads have swept their shares `count` times, from when all are ready.
fn together(shares: &mut [Share], count: u32) -> Duration {
    let ready = Barrier::new(shares.len());
    let timed = |share: &mut Share| {
        ready.wait();
        let start = Instant::now();
        share.sweeps(count);
        (start, Instant::now())
    };
    let times: Vec<_> = thread::scope(|scope| {
        let handles: Vec<_> =
            shares.iter_mut().map(|share| scope.spawn(move || timed(share))).collect();
        handles.into_iter().map(|h| h.join().expect("a sweep does not panic")).collect()
    });
    let first = times.iter().map(|t| t.0).min();
    let last = times.iter().map(|t| t.1).max();
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
