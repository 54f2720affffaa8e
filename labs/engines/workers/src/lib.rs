//! Threads that wait for work, for all engines with threads.
//!
//! Results are in the order of the pieces of work. If the pieces do not depend on the number of
//! threads, the results do not depend on it either.
//!
//! ```
//! use workers::Workers;
//!
//! let pieces = vec![0..3, 3..7, 7..10];
//! let sums = Workers::new(2)?.map(pieces.clone(), |piece: std::ops::Range<u32>| piece.sum::<u32>());
//! assert_eq!(sums, [3, 18, 24]);
//! assert_eq!(sums, Workers::One.map(pieces, |piece| piece.sum::<u32>()));
//! # Ok::<(), common::BuildError>(())
//! ```
//!
//! # Errors
//!
//! The system may refuse to start threads. If a piece of work panics, the caller panics.

use std::cmp::Ordering;
use std::sync::Arc;

use common::BuildError;
use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

/// One thread, or a pool of several that wait for work.
#[derive(Clone, Default)]
pub enum Workers {
    /// The calling thread.
    #[default]
    One,
    /// A pool of threads.
    Many(Arc<ThreadPool>),
}

impl Workers {
    /// Starts `threads` threads. A single thread is the calling thread.
    ///
    /// # Errors
    /// The system refuses to start the threads.
    pub fn new(threads: usize) -> Result<Self, BuildError> {
        if threads <= 1 {
            return Ok(Self::One);
        }
        let pool = ThreadPoolBuilder::new().num_threads(threads).build();
        pool.map(|pool| Self::Many(Arc::new(pool)))
            .map_err(|e| BuildError(format!("cannot start {threads} threads: {e}")))
    }

    /// Starts `threads` threads. If the system refuses, the caller works alone, with the same
    /// results.
    pub fn if_possible(threads: usize) -> Self {
        Self::new(threads).unwrap_or_default()
    }

    /// Returns the number of threads.
    pub fn count(&self) -> usize {
        match self {
            Self::One => 1,
            Self::Many(pool) => pool.current_num_threads(),
        }
    }

    /// Calls `work` on one of the threads.
    ///
    /// Work that this thread shares out costs less than work from outside the pool, because no
    /// thread is woken without need.
    pub fn within<R: Send>(&self, work: impl FnOnce() -> R + Send) -> R {
        match self {
            Self::One => work(),
            Self::Many(pool) => pool.install(work),
        }
    }

    /// Calls `work` with every piece, and returns the results in the order of the pieces.
    pub fn map<T: Send, R: Send>(
        &self,
        pieces: Vec<T>,
        work: impl Fn(T) -> R + Send + Sync,
    ) -> Vec<R> {
        match self {
            Self::Many(pool) if pieces.len() > 1 => {
                pool.install(|| pieces.into_par_iter().with_max_len(1).map(work).collect())
            }
            _ => pieces.into_iter().map(work).collect(),
        }
    }

    /// Calls `act` once on every thread, with the thread's number, and waits for all calls: a fork
    /// and a join.
    pub fn on_each(&self, act: impl Fn(usize) + Sync) {
        match self {
            Self::One => act(0),
            Self::Many(pool) => {
                pool.broadcast(|context| act(context.index()));
            }
        }
    }

    /// Sorts items by a total order.
    pub fn sort<T: Send>(&self, items: &mut [T], order: impl Fn(&T, &T) -> Ordering + Send + Sync) {
        match self {
            Self::One => items.sort_unstable_by(order),
            Self::Many(pool) => pool.install(|| items.par_sort_unstable_by(order)),
        }
    }
}
