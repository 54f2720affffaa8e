//! Threads that wait for work, for all engines with threads.
//!
//! The threads live as long as their [`Workers`]. While they wait for work, they spin for a short
//! time before they sleep (`team.rs`).
//!
//! Results are in the order of the pieces of work. If the pieces do not depend on the number of
//! threads, neither do the results.
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

mod team;

use std::cmp::Ordering;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
use std::sync::{Arc, Mutex, PoisonError};

use common::BuildError;

use team::Team;

/// One thread, or a team of several threads that wait for work.
#[derive(Clone, Default)]
pub enum Workers {
    /// The calling thread.
    #[default]
    One,
    /// A team of threads, among them the calling thread.
    Many(Arc<Team>),
}

impl Workers {
    /// Starts `threads` threads. The calling thread is one of them.
    ///
    /// # Errors
    /// If the system refuses to start the threads.
    pub fn new(threads: usize) -> Result<Self, BuildError> {
        if threads <= 1 {
            return Ok(Self::One);
        }
        let team = Team::start(threads);
        team.map(|team| Self::Many(Arc::new(team)))
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
            Self::Many(team) => team.count(),
        }
    }

    /// Calls `work` with every piece, and returns the results in the order of the pieces.
    ///
    /// Each thread begins with its own part of the pieces. This part is the same in every call with
    /// as many pieces. So the data of this part may still be in the core's cache. A thread that has
    /// finished its part takes pieces from other parts.
    pub fn map<T: Send, R: Send>(
        &self,
        pieces: Vec<T>,
        work: impl Fn(T) -> R + Send + Sync,
    ) -> Vec<R> {
        let team = match self {
            Self::Many(team) if pieces.len() > 1 => team,
            _ => return pieces.into_iter().map(work).collect(),
        };
        let count = team.count();
        let slots: Vec<_> =
            pieces.into_iter().map(|piece| Mutex::new(Slot::Piece(piece))).collect();
        let starts: Vec<usize> = (0..=count).map(|part| part * slots.len() / count).collect();
        let next: Vec<_> = starts.iter().map(|&start| AtomicUsize::new(start)).collect();
        team.share(&|thread| {
            for part in (thread..count).chain(0..thread) {
                let pieces = std::iter::repeat_with(|| next[part].fetch_add(1, Relaxed));
                for k in pieces.take_while(|&k| k < starts[part + 1]) {
                    let mut slot = slots[k].lock().unwrap_or_else(PoisonError::into_inner);
                    if let Slot::Piece(piece) = std::mem::replace(&mut *slot, Slot::Taken) {
                        *slot = Slot::Result(work(piece));
                    }
                }
            }
        });
        slots.into_iter().map(Slot::into_result).collect()
    }

    /// Calls `act` once on every thread, with the thread's number, and waits for all calls: a fork
    /// and a join.
    pub fn on_each(&self, act: impl Fn(usize) + Sync) {
        match self {
            Self::One => act(0),
            Self::Many(team) => team.on_each(&act),
        }
    }

    /// Sorts items in the total order `order`.
    ///
    /// The threads sort parts of equal length, and then merge pairs of parts.
    pub fn sort<T: Send>(&self, items: &mut [T], order: impl Fn(&T, &T) -> Ordering + Send + Sync) {
        let mut length = items.len().div_ceil(self.count()).max(1);
        let parts = items.chunks_mut(length).collect();
        self.map(parts, |part: &mut [T]| part.sort_unstable_by(&order));
        while length < items.len() {
            length *= 2;
            // The standard sort finds the two sorted runs of a part, and merges them.
            let parts = items.chunks_mut(length).collect();
            self.map(parts, |part: &mut [T]| part.sort_by(&order));
        }
    }
}

/// The state of a piece of work.
enum Slot<T, R> {
    /// No thread has begun the piece.
    Piece(T),
    /// A thread works on the piece.
    Taken,
    /// The piece is done.
    Result(R),
}

impl<T, R> Slot<T, R> {
    fn into_result(slot: Mutex<Self>) -> R {
        match slot.into_inner() {
            Ok(Self::Result(result)) => result,
            _ => unreachable!("a round ends when all pieces are done, or panics"),
        }
    }
}
