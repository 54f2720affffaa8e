//! Work that is the same on any number of threads.

use std::sync::Arc;

use rayon::ThreadPool;
use rayon::prelude::*;

/// The fewest particles that pay for a thread: with fewer it costs more to wake than it does. Measured on
/// the machine of the book.
pub const LEAST: usize = 2000;

/// The threads of an engine.
///
/// Work is cut into pieces by the scene, never by the number of threads, and the results come
/// back in the order of the pieces. Which thread does which piece is then no longer visible in them.
#[derive(Clone, Default)]
pub struct Workers {
    most: usize,
    share: usize,
    pool: Option<Arc<ThreadPool>>,
}

impl Workers {
    /// `threads` threads; one means the caller's own. If the machine refuses to start them, the
    /// caller works alone: slower, with the same result.
    pub fn new(threads: usize) -> Self {
        let pool = (threads > 1)
            .then(|| rayon::ThreadPoolBuilder::new().num_threads(threads).build().ok())
            .flatten();
        Self { most: threads, share: 1, pool: pool.map(Arc::new) }
    }

    /// `most` threads or fewer: as many as have `share` particles each. It is the caller alone until
    /// the particles are counted, by [`engage`](Self::engage).
    pub fn sharing(most: usize, share: usize) -> Self {
        Self { most, share, pool: None }
    }

    /// Takes as many threads as pay for `n` particles.
    pub fn engage(&mut self, n: usize) {
        let threads = self.most.min(n / self.share.max(1)).max(1);
        if threads != self.threads() {
            self.pool = Self::new(threads).pool;
        }
    }

    /// How many there are.
    pub fn threads(&self) -> usize {
        self.pool.as_ref().map_or(1, |pool| pool.current_num_threads())
    }

    /// How many there may be.
    pub fn most(&self) -> usize {
        self.most
    }

    /// Does `work` on one of the threads. What it hands over from there costs less than what it
    /// hands over from outside: no thread has to be woken that is not needed.
    pub fn within<R: Send>(&self, work: impl FnOnce() -> R + Send) -> R {
        match &self.pool {
            Some(pool) => pool.install(work),
            None => work(),
        }
    }

    /// Does every piece of work and returns the results in the order of the pieces.
    pub fn map<T: Send, R: Send>(
        &self,
        pieces: Vec<T>,
        work: impl Fn(T) -> R + Send + Sync,
    ) -> Vec<R> {
        match &self.pool {
            Some(pool) if pieces.len() > 1 => {
                pool.install(|| pieces.into_par_iter().with_max_len(1).map(work).collect())
            }
            _ => pieces.into_iter().map(work).collect(),
        }
    }
}

/// How long pieces of `n` things are, if they should be at least `target` long and no more than
/// `most`. A power of two of them, all alike: then two or four threads have equally many.
pub fn pieces(n: usize, target: usize, most: usize) -> usize {
    let most = (n / target).clamp(1, most);
    n.div_ceil(1 << most.ilog2()).max(1)
}

/// Cuts a slice at `ends`, ascending and ending with the slice's length.
pub fn cut<T>(mut slice: &mut [T], ends: impl IntoIterator<Item = usize>) -> Vec<&mut [T]> {
    let mut start = 0;
    ends.into_iter()
        .map(|end| {
            let (piece, rest) = std::mem::take(&mut slice).split_at_mut(end - start);
            (slice, start) = (rest, end);
            piece
        })
        .collect()
}
