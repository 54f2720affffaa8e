//! What a search finds.

use solution10::kernels::{EIGHT, Pair};

/// What a search finds.
#[derive(Default)]
pub(crate) struct Found {
    /// Pairs that are to be computed.
    pub(crate) close: Vec<Pair>,
    /// On a list: pairs that come nearly as near.
    pub(crate) watched: Vec<Pair>,
    /// How many were looked at.
    pub(crate) tested: u64,
    /// While a search is under way: how many of `close` are written.
    written: usize,
}

impl Found {
    /// Writes down pairs of particle `i`: with eight from each start, the ones with a bit in `near`.
    ///
    /// Whether a particle has a pair at all is hard to guess, and a wrong guess costs the processor
    /// more than the comparison of sixteen particles. So one pair is always written; only if
    /// it is one does the place for the next move on.
    #[inline(always)]
    pub(crate) fn add(&mut self, i: usize, starts: [usize; 2], mut near: u32) {
        let Self { close, written, .. } = self;
        if *written + 2 * EIGHT > close.len() {
            close.resize(2 * close.len() + 1024, [0; 2]);
        }
        loop {
            let l = near.trailing_zeros() as usize % (2 * EIGHT);
            close[*written] = [i as u32, (starts[l / EIGHT] + l % EIGHT) as u32];
            *written += usize::from(near != 0);
            near &= near.wrapping_sub(1);
            if near == 0 {
                return;
            }
        }
    }

    /// Begins a search.
    pub(crate) fn begin(&mut self) {
        self.close.resize(self.close.capacity(), [0; 2]);
        (self.tested, self.written) = (0, 0);
    }

    /// Ends it.
    pub(crate) fn end(&mut self) {
        self.close.truncate(self.written);
    }
}
