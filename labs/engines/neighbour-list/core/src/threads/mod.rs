//! Work that is the same on any number of threads: it is cut into pieces by the scene, never by the number of threads.

use workers::Workers;

/// The fewest particles that pay for a thread. With fewer, waking the thread takes longer than its work. Measured on the
/// machine of the book.
pub const LEAST: usize = 2000;

/// The threads of an engine, as many as pay for the particles of a scene.
#[derive(Clone, Default)]
pub struct Crew {
    most: usize,
    share: usize,
    workers: Workers,
}

impl From<Workers> for Crew {
    /// These threads, or fewer for fewer particles.
    fn from(workers: Workers) -> Self {
        Self { most: workers.count(), share: 1, workers }
    }
}

impl Crew {
    /// `most` threads or fewer: as many as have `share` particles each. It is the caller alone until
    /// the particles are counted, by [`engage`](Self::engage).
    pub fn sharing(most: usize, share: usize) -> Self {
        Self { most, share, workers: Workers::One }
    }

    /// Takes as many threads as pay for `n` particles. If the machine refuses to start them, the caller works alone:
    /// slower, with the same result.
    pub fn engage(&mut self, n: usize) {
        let threads = self.most.min(n / self.share.max(1)).max(1);
        if threads != self.workers.count() {
            self.workers = Workers::if_possible(threads);
        }
    }

    /// The threads that are engaged.
    pub fn workers(&self) -> &Workers {
        &self.workers
    }

    /// The greatest number of threads.
    pub fn most(&self) -> usize {
        self.most
    }
}

/// How long pieces of `n` things are, if they should be at least `target` long and no more than
/// `most`. A power of two of them, all alike: then two or four threads have equally many.
pub fn pieces(n: usize, target: usize, most: usize) -> usize {
    let most = (n / target).clamp(1, most);
    n.div_ceil(1 << most.ilog2()).max(1)
}

/// Cuts a slice at `ends`, ascending and ending with the slice's length.
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
