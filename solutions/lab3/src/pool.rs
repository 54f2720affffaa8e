//! Given: rayon's threads.

use rayon::{ThreadPool, ThreadPoolBuilder};

/// A pool of exactly `threads` threads. They start now and sleep until
/// [`install`](ThreadPool::install) brings them work.
///
/// # Panics
/// The system refuses that number of threads.
// ANCHOR: pool
pub fn pool(threads: usize) -> ThreadPool {
    ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .unwrap_or_else(|e| panic!("cannot start {threads} threads: {e}"))
}
// ANCHOR_END: pool
