//! An array for the candidates of all threads.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicU64, Ordering};

use crate::collisions::{Candidate, Hit};

/// Number of slots in the first segment. Each further segment has twice as many slots as the
/// segment before it.
const FIRST: usize = 1 << 12;

/// An array of slots for candidates of pairs. Any thread may write to any slot.
///
/// The report reserves N (N + 1) / 2 slots at the start. This array grows by segments, and its
/// contents do not move.
pub struct Slots([OnceLock<Box<[Slot]>>; 32]);

/// A candidate of a pair: the bits of its time, and its two discs.
#[derive(Default)]
struct Slot {
    time: AtomicU64,
    discs: AtomicU64,
}

impl Default for Slots {
    fn default() -> Self {
        Self(std::array::from_fn(|_| OnceLock::new()))
    }
}

impl Slots {
    fn at(&self, slot: usize) -> &Slot {
        let k = (slot / FIRST + 1).ilog2() as usize;
        let segment = self.0[k].get_or_init(|| (0..FIRST << k).map(|_| Slot::default()).collect());
        &segment[slot + FIRST - (FIRST << k)]
    }

    // Relaxed ordering is enough, because slots are read after all threads have ended the loop.

    /// Writes the candidate of a pair to slot number `slot`, counted from 0.
    pub fn put(&self, slot: usize, candidate: Candidate) {
        let Hit::Pair(a, b) = candidate.hit else { unreachable!("only pairs are searched for") };
        let slot = self.at(slot);
        slot.time.store(candidate.time.to_bits(), Ordering::Relaxed);
        slot.discs.store(u64::from(a) << 32 | u64::from(b), Ordering::Relaxed);
    }

    /// Returns the candidates in the first `count` slots.
    pub fn first(&self, count: usize) -> impl Iterator<Item = Candidate> {
        (0..count).map(|slot| {
            let slot = self.at(slot);
            let discs = slot.discs.load(Ordering::Relaxed);
            let time = f64::from_bits(slot.time.load(Ordering::Relaxed));
            Candidate { time, hit: Hit::Pair((discs >> 32) as u32, discs as u32) }
        })
    }
}
