//! Given: rayon's threads.

use rayon::{ThreadPool, ThreadPoolBuilder};

/// Makes a pool of exactly `threads` threads.
///
/// The threads start now, and sleep until [`install`](ThreadPool::install) gives them work.
///
/// # Panics
/// If the system cannot start so many threads.
pub fn pool(threads: usize) -> ThreadPool {
    ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .unwrap_or_else(|e| panic!("cannot start {threads} threads: {e}"))
}
