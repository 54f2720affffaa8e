//! The properties of this machine, for the commands and for the tests' oracle.
//!
//! They are its MPI launcher ([`Mpiexec`]), the time in which it [streams](streaming) particles,
//! and the [costs of one core](core_costs).

pub mod core_costs;
mod mpiexec;
pub mod streaming;

pub use mpiexec::{Mpiexec, NoMpiexec};

use std::time::Instant;

/// Measures how many nanoseconds `work` takes per item. Returns the median of nine timings.
pub fn nanoseconds_each(count: usize, mut work: impl FnMut()) -> f64 {
    let mut takes = [0; 9].map(|_| {
        let start = Instant::now();
        work();
        start.elapsed()
    });
    takes.sort_unstable();
    takes[4].as_nanos() as f64 / count as f64
}
