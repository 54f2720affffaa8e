//! Task 7.10: work stealing.

use std::ops::Range;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use crossbeam::deque::Steal;

use crate::{Deque, Victim};

/// The next part for a worker that has none: the top one of its own deque, else one that is stolen.
///
/// `others` are the deques of all other workers, to be tried in this order ([`Victim::steal`]). [`Steal::Retry`] says that
/// another thread came between: there may be a part, so the victims must be asked again. None only if
/// the own deque and all others are empty.
///
/// Book: chapter 7, *Work stealing*.
pub fn take_or_steal(own: &Deque, others: &[Victim]) -> Option<Range<usize>> {
    todo!("task 7.10: take a part, or steal one")
}

/// Leaves halves of a part where they can be stolen, and returns what is left to do at once.
///
/// As long as the part has more than `least` (1 or more) iterations it is halved, and its second half
/// pushed to `own`; if the halves differ, the first is the shorter by 1.
///
/// Book: chapter 7, *Work stealing*.
pub fn leave_halves(part: Range<usize>, least: usize, own: &Deque) -> Range<usize> {
    todo!("task 7.10b: leave halves for other workers")
}

/// A loop whose parts lie in the workers' deques.
pub struct StolenLoop {
    deques: Vec<Mutex<Deque>>,
    /// For each worker the other workers' deques, its next neighbour's first.
    others: Vec<Vec<Victim>>,
    /// Iterations that no worker has begun.
    left: AtomicUsize,
    least: usize,
}

impl StolenLoop {
    /// The loop in which each worker begins with one of `parts`.
    pub fn new(parts: impl IntoIterator<Item = Range<usize>>, least: usize) -> Self {
        let (mut deques, mut left) = (Vec::new(), 0);
        for part in parts {
            left += part.len();
            deques.push(Deque::new_lifo());
            deques[deques.len() - 1].push(part);
        }
        let around = |worker| (worker + 1..deques.len()).chain(0..worker);
        let victims = |worker| around(worker).map(|other| Victim::of(&deques[other])).collect();
        let others = (0..deques.len()).map(victims).collect();
        let deques = deques.into_iter().map(Mutex::new).collect();
        Self { deques, others, left: AtomicUsize::new(left), least: least.max(1) }
    }

    /// What one worker does until all iterations have been begun.
    pub fn work(&self, worker: usize, body: impl Fn(Range<usize>)) {
        let own = self.deques[worker].lock().expect("its worker alone takes it");
        // Empty deques are not the end: a worker may be about to leave halves of what it has taken.
        while self.left.load(Ordering::Relaxed) > 0 {
            let Some(part) = take_or_steal(&own, &self.others[worker]) else {
                thread::yield_now();
                continue;
            };
            let part = leave_halves(part, self.least, &own);
            self.left.fetch_sub(part.len(), Ordering::Relaxed);
            body(part);
        }
    }
}
