//! What a search finds.

use solution10::kernels::{EIGHT, Pair};

/// What a search finds.
#[derive(Default)]
pub(crate) struct Found {
    /// Pairs that are to be computed.
    pub(crate) close: Vec<Pair>,
    /// Pairs that come nearly as near.
    pub(crate) watched: Vec<Pair>,
    /// How many were looked at.
    pub(crate) tested: u64,
    /// While a search is under way: how many of `close` and `watched` are written.
    written: [usize; 2],
}

impl Found {
    /// Writes down pairs of particle `i`: with eight from each start, the ones with a bit in `wide`;
    /// with a bit in `near`, too, a pair is close.
    ///
    /// Whether a particle has a pair at all is hard to guess, and a wrong guess costs the processor
    /// more than the comparison of sixteen particles. So one pair is always written, to both lists;
    /// only if it is one does the place for the next move on.
    #[inline(always)]
    pub(crate) fn add(&mut self, i: usize, starts: [usize; 2], near: u32, mut wide: u32) {
        let Self { close, watched, written: [closes, watches], .. } = self;
        if (*closes).max(*watches) + 2 * EIGHT > close.len() {
            let room = 2 * close.len() + 1024;
            close.resize(room, [0; 2]);
            watched.resize(room, [0; 2]);
        }
        loop {
            let l = wide.trailing_zeros() as usize % (2 * EIGHT);
            let pair = [i as u32, (starts[l / EIGHT] + l % EIGHT) as u32];
            let (any, is_close) = (usize::from(wide != 0), (near >> l & 1) as usize);
            close[*closes] = pair;
            *closes += any & is_close;
            watched[*watches] = pair;
            *watches += any & !is_close;
            wide &= wide.wrapping_sub(1);
            if wide == 0 {
                return;
            }
        }
    }

    /// Begins a search.
    pub(crate) fn begin(&mut self) {
        let room = self.close.capacity().min(self.watched.capacity());
        self.close.resize(room, [0; 2]);
        self.watched.resize(room, [0; 2]);
        (self.tested, self.written) = (0, [0; 2]);
    }

    /// Ends it.
    pub(crate) fn end(&mut self) {
        self.close.truncate(self.written[0]);
        self.watched.truncate(self.written[1]);
    }
}
