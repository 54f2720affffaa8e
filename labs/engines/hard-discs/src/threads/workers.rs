//! Threads that wait for work, and the simple loops that they share.

use std::cmp::Ordering;
use std::sync::Arc;

use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

use common::BuildError;

/// Discs in a piece of a loop over discs.
const PIECE: usize = 4096;

/// One thread, or a pool of several that wait for work.
///
/// The loops over discs (does it hit a wall, where does it go) are the ones that «do not allow
/// much difference», as the CS3210 report says: cut into pieces of equal length they are even.
#[derive(Clone)]
pub enum Workers {
    /// The calling thread.
    One,
    /// A pool.
    Many(Arc<ThreadPool>),
}

impl Workers {
    /// This number of threads.
    ///
    /// # Errors
    /// The system refuses to start them.
    pub fn new(threads: usize) -> Result<Self, BuildError> {
        if threads == 1 {
            return Ok(Self::One);
        }
        let pool = ThreadPoolBuilder::new().num_threads(threads).build();
        pool.map(|pool| Self::Many(Arc::new(pool)))
            .map_err(|e| BuildError(format!("cannot start {threads} threads: {e}")))
    }

    /// How many threads.
    pub fn count(&self) -> usize {
        match self {
            Self::One => 1,
            Self::Many(pool) => pool.current_num_threads(),
        }
    }

    /// Does `work` on one of the threads.
    pub fn within<R: Send>(&self, work: impl FnOnce() -> R + Send) -> R {
        match self {
            Self::One => work(),
            Self::Many(pool) => pool.install(work),
        }
    }

    /// Calls `act` with every item and its index.
    pub fn for_each<T: Send>(&self, items: &mut [T], act: impl Fn(usize, &mut T) + Sync) {
        let piece = |(k, piece): (usize, &mut [T])| {
            for (i, item) in (k * PIECE..).zip(piece) {
                act(i, item);
            }
        };
        match self {
            Self::Many(pool) if items.len() > PIECE => {
                pool.install(|| items.par_chunks_mut(PIECE).enumerate().for_each(piece));
            }
            _ => items.chunks_mut(PIECE).enumerate().for_each(piece),
        }
    }

    /// Calls `act` with every one of a few items that are worth a thread each.
    pub fn for_few<T: Send>(&self, items: &mut [T], act: impl Fn(usize, &mut T) + Sync) {
        match self {
            Self::Many(pool) if items.len() > 1 => {
                pool.install(|| items.par_iter_mut().enumerate().for_each(|(i, t)| act(i, t)));
            }
            _ => items.iter_mut().enumerate().for_each(|(i, t)| act(i, t)),
        }
    }

    /// Appends to `out`, in order, what `find` makes of every item and its index.
    pub fn collect<T: Sync, U: Send>(
        &self,
        items: &[T],
        out: &mut Vec<U>,
        find: impl Fn(usize, &T) -> Option<U> + Sync,
    ) {
        let found = |first: usize, piece: &[T]| -> Vec<U> {
            (first..).zip(piece).filter_map(|(i, item)| find(i, item)).collect()
        };
        match self {
            Self::Many(_) => out.extend(self.map_pieces(items, found).into_iter().flatten()),
            Self::One => out.extend(items.iter().enumerate().filter_map(|(i, item)| find(i, item))),
        }
    }

    /// What `work` makes of each piece of the items and the index of its first one. The pieces are the same for
    /// any number of threads.
    pub fn map_pieces<T: Sync, U: Send>(
        &self,
        items: &[T],
        work: impl Fn(usize, &[T]) -> U + Sync,
    ) -> Vec<U> {
        let work = |(k, piece): (usize, &[T])| work(k * PIECE, piece);
        match self {
            Self::Many(pool) if items.len() > PIECE => {
                pool.install(|| items.par_chunks(PIECE).enumerate().map(work).collect())
            }
            _ => items.chunks(PIECE).enumerate().map(work).collect(),
        }
    }

    /// Sorts items by a total order.
    pub fn sort<T: Send>(&self, items: &mut [T], order: impl Fn(&T, &T) -> Ordering + Send + Sync) {
        match self {
            Self::Many(pool) if items.len() > PIECE => {
                pool.install(|| items.par_sort_unstable_by(order));
            }
            _ => items.sort_unstable_by(order),
        }
    }
}
