//! Threads, and work with the same result on any number of threads.
//!
//! The pieces of work depend on the scene, never on the number of threads.

use workers::Workers;

/// The least number of particles that is worth another thread, measured on the machine of the book.
///
/// With fewer particles, waking the thread takes longer than its work.
pub const LEAST: usize = 2000;

/// The threads of an engine: as many as are worth their cost for the particles of the scene.
#[derive(Clone, Default)]
pub struct Crew {
    most: usize,
    share: usize,
    workers: Workers,
}

impl From<Workers> for Crew {
    /// Uses these threads, or fewer if there are fewer particles than threads.
    fn from(workers: Workers) -> Self {
        Self { most: workers.count(), share: 1, workers }
    }
}

impl Crew {
    /// Makes a crew of at most `most` threads. Each thread must have at least `share` particles.
    ///
    /// The caller works alone until [`engage`](Self::engage) is called with the number of
    /// particles.
    pub fn sharing(most: usize, share: usize) -> Self {
        Self { most, share, workers: Workers::One }
    }

    /// Starts as many threads as are worth their cost for `n` particles.
    ///
    /// If the system refuses to start the threads, the caller works alone: more slowly, with the
    /// same result.
    pub fn engage(&mut self, n: usize) {
        let threads = self.most.min(n / self.share.max(1)).max(1);
        if threads != self.workers.count() {
            self.workers = Workers::if_possible(threads);
        }
    }

    /// Returns the threads that have been started.
    pub fn workers(&self) -> &Workers {
        &self.workers
    }

    /// Returns the greatest number of threads.
    pub fn most(&self) -> usize {
        self.most
    }
}

/// Returns the length of pieces into which `n` items are divided.
///
/// Pieces are at least `target` long if there are at least `target` items, and there are at most
/// `most` pieces. Their number is a power of two, so that two or four threads get equal work.
pub fn pieces(n: usize, target: usize, most: usize) -> usize {
    let most = (n / target).clamp(1, most);
    n.div_ceil(1 << most.ilog2()).max(1)
}

/// Cuts a slice at `ends`, an ascending list that ends with the slice's length.
pub fn cut<'a, T>(slice: &'a mut [T], ends: &[usize]) -> Vec<&'a mut [T]> {
    let mut rest = slice;
    let mut pieces = Vec::with_capacity(ends.len());
    let mut start = 0;
    for &end in ends {
        pieces.push(rest.split_off_mut(..end - start).expect("ends are in the slice"));
        start = end;
    }
    pieces
}
